// SPDX-License-Identifier: MIT
// Films of runs on the lattice, and of structures, which have no time.
#pragma once

#include <optional>

#include "film.h"
#include "uses.h"

namespace stig::cli {

/// The film of a trace on the lattice; problems are reported.
std::optional<Film> lattice_film(const RenderOptions& options, const std::string& bytes,
                                 const App& app);
/// The single picture of a structure file.
std::optional<Film> structure_film(const RenderOptions& options, const App& app);

}  // namespace stig::cli
