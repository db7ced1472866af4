// SPDX-License-Identifier: MIT
// Structure files as arguments of commands.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "lattice/loaded_structure.h"
#include "uses.h"

namespace stig::cli {

/// Reads a file on its own terms; `lattice` is for files that do not say theirs, and
/// holds the others to it. A mesh becomes bricks, and a remark says how. Problems are reported.
std::optional<LoadedStructure> read_structure(const std::string& path,
                                              std::optional<Lattice> lattice, const App& app,
                                              const MeshOptions& mesh = {});

/// Reads a file in terms of a rule set: its bricks become the set's, matched by symbol,
/// then by colour. Problems are reported; a brick that the set does not have is one. A
/// file that does not say where its structure stands is remarked on.
std::optional<Structure> read_structure_for(const RuleSet& rules, const std::string& path,
                                            const App& app);

}  // namespace stig::cli
