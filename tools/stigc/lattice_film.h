// SPDX-License-Identifier: MIT
// Films of runs on the lattice, and of structures, which have no time.
#pragma once

#include <optional>

#include "film.h"
#include "uses.h"

namespace stig::cli {

/// Of a trace on the lattice; problems are reported.
std::optional<Film> lattice_film(const RenderOptions& options, const std::string& bytes,
                                 const App& app);
/// Of a structure file.
std::optional<Film> structure_film(const RenderOptions& options, const App& app);

}  // namespace stig::cli
