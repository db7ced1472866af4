// SPDX-License-Identifier: MIT
// All that a controller for one robot is made of: the intermediate form between compiled rules
// and the text of a program.
//
//     chart      what follows what (chart.h), the same for all rule sets
//     decision   what to do before a column (decision.h), the rules
//     viewpoints from where to look at it
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/chart.h"
#include "compiler/uses.h"
#include "compiler/viewpoints.h"

namespace stig::compiler {

struct ControllerPlan {
  const Chart* chart = nullptr;
  const DecisionNode* decision = nullptr;  ///< owned by the compiled rules
  std::vector<WindowCell> asks;            ///< cells that the decision asks for, rising
  std::vector<Viewpoint> viewpoints;
  std::vector<ApproachSide> sides;
  bool turns = false;    ///< any side will do, whatever its name
  int levels = 0;        ///< of the structure
  int transport = 4;     ///< what a block on its way shows; 0: dark
  std::set<int> starts;  ///< what the bricks show that stand at first; kinds
  /// What stands in the end: cells and kinds, by which a brick of a wrong colour is found. Empty
  /// where it is larger than a robot would compare it with what it knows.
  std::vector<std::pair<Cell, int>> structure;
  int kinds = 4;            ///< that the code has by which blocks are read (sensing/led_code.h)
  bool answers = false;     ///< blocks do, when they are told a colour
  double longest_wait = 0;  ///< s, before a site is approached
  double widest = 0;        ///< rad, of a tag's normal from the line to a camera that reads it
};

/// The plan for rules that were compiled with success; it is valid for as long as `compiled` is.
ControllerPlan plan_controller(const RuleSet& rules, const Abilities& robot,
                               const CompiledRules& compiled);

/// Rules by which the placement of a leaf is made, in some structure that can arise; rising.
std::vector<std::uint32_t> rules_of(const CompiledRules& compiled, const DecisionNode& leaf);

}  // namespace stig::compiler
