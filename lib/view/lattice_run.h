// SPDX-License-Identifier: MIT
// Runs on the lattice and structures without history, as pages show them.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

/// A cell with something to say of it.
struct SceneMark {
  Cell at;
  bool in_the_way = false;  ///< otherwise wanted
  std::string text;
};

/// A moment at which rules or robots do not go on: bricks of a rule set, marks, and why in lines.
void add_marked_structure(const RuleSet& rules, const std::vector<PlacedBrick>& bricks,
                          const std::string& name, const std::vector<SceneMark>& marks,
                          const std::vector<std::string>& why, PageContent& page);

/// Likewise as the structure that runs are held against.
void set_target(const LoadedStructure& loaded, const std::string& name, PageContent& page);

}  // namespace stig::view
