// SPDX-License-Identifier: MIT
// Runs on the lattice and structures without history, as pages show them.
#pragma once

#include <optional>
#include <string>

#include "lattice/loaded_structure.h"
#include "lattice/trace.h"
#include "view/page.h"
#include "view/uses.h"

namespace stig::view {

/// Adds a trace with the rules that it ran on. What is wrong with it, in words, when its events are
/// none of these rules: a colour or a rule that there is not, or two bricks in one cell.
std::optional<std::string> add_lattice_run(const Trace& trace, const RuleSet& rules,
                                           const std::string& name, PageContent& page);

/// Adds a structure, all of it there from the beginning.
void add_structure(const LoadedStructure& loaded, const std::string& name, PageContent& page);

/// Likewise as the structure that runs are held against.
void set_target(const LoadedStructure& loaded, const std::string& name, PageContent& page);

}  // namespace stig::view
