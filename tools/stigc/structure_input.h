// SPDX-License-Identifier: MIT
// Structure files as arguments of commands.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "lattice/loaded_structure.h"

namespace stig {

/// Reads a file on its own terms: .txt holds numbers, cubic. Problems are reported.
std::optional<LoadedStructure> read_structure(const std::string& path, const App& app);

/// Reads a file in terms of a rule set: its bricks become the set's, matched by symbol,
/// then by colour. Problems are reported; a brick that the set does not have is one.
std::optional<Structure> read_structure_for(const RuleSet& rules, const std::string& path,
                                            const App& app);

}  // namespace stig
