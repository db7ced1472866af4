// SPDX-License-Identifier: MIT
// Collects what a program consists of, apart from its text. Whatever does not depend on the
// rules (chart, library) is only referred to.
#include "compiler/controller_plan.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "base/led_name.h"
#include "sensing/led_code.h"

namespace stig::compiler {

namespace {

constexpr std::size_t kMostBricks = 400;  ///< that a robot compares with what it knows
constexpr double kLongestWait = 30;       ///< s; Allwright et al. 2017, section 7.2

void gather_asks(const DecisionNode& node, std::set<WindowCell>& out) {
  if (!node.question) return;
  if (node.question->kind == Question::Kind::cell) out.insert(node.question->cell);
  for (const auto& [answers, child] : node.branches) gather_asks(*child, out);
}

/// In the paper a block on its way is Q4. Where bricks are, another colour that none is. A
/// block in transport needs a colour that no brick has, or another robot could take it for
/// one. If all four are in use it shows a code word that none has, where bricks show code words,
/// and otherwise it is left dark.
int transport_colour(const RuleSet& rules, int kinds) {
  const auto taken = [&](int kind) {
    const std::string_view led = kLedNames[static_cast<std::size_t>(kind)];
    return std::any_of(rules.bricks.begin(), rules.bricks.end(),
                       [&](const Brick& brick) { return brick.led == led; });
  };
  for (int colour = kBlockColours; colour > 0; --colour) {
    if (!taken(colour)) return colour;
  }
  for (int kind = kinds; kind > kBlockColours; --kind) {
    if (!taken(kind)) return kind;
  }
  return 0;
}

}  // namespace

ControllerPlan plan_controller(const RuleSet& rules, const Abilities& robot,
                               const CompiledRules& compiled) {
  assert(compiled.decision != nullptr && compiled.target != nullptr);
  ControllerPlan out;
  out.chart = &building_chart();
  out.decision = compiled.decision.get();
  std::set<WindowCell> asks;
  gather_asks(*out.decision, asks);
  out.asks.assign(asks.begin(), asks.end());
  out.viewpoints = choose_viewpoints(seeing(rules.highest_kind(), robot), compiled);
  out.sides = compiled.sides;
  out.turns = compiled.directions != KnownDirections::declared;
  out.levels = compiled.target->levels();
  out.kinds = sensing::code_size(std::max(1, rules.highest_kind()));
  out.transport = transport_colour(rules, out.kinds);
  const auto kind_of = [&](Colour colour) {
    return kind_named(rules.brick(colour).led).value_or(0);
  };
  for (const PlacedBrick& brick : rules.start) out.starts.insert(kind_of(brick.brick));
  const TargetBricks& target = *compiled.target;
  for (std::size_t i = 0; i < target.bricks() && target.bricks() <= kMostBricks; ++i) {
    out.structure.emplace_back(target.cell(i), kind_of(target.colour(i)));
  }
  // Robots wait a random time before they approach, so that two that saw the same do not
  // act at the same moment.
  out.longest_wait = compiled.robots == 1 ? 0 : kLongestWait;
  out.widest = robot.block.most_angle;
  out.answers = robot.answers;
  return out;
}

/// For comments and the map of lines alone: the decision itself does not depend on rules'
/// names.
std::vector<std::uint32_t> rules_of(const CompiledRules& compiled, const DecisionNode& leaf) {
  std::set<std::uint32_t> out;
  const Policy& policy = compiled.policy;
  const std::set<std::uint32_t> seen(leaf.observations.begin(), leaf.observations.end());
  for (const Situation& situation : policy.situations) {
    if (!policy.reached[situation.state] || !seen.contains(situation.observation)) continue;
    for (const auto& [placement, to] : situation.placements) {
      if (placement != leaf.placement) continue;
      const BrickSet& before = policy.states[situation.state];
      const auto brick = brick_added(before, policy.states[to], compiled.target->bricks());
      if (const auto rule = compiled.target->rule_for(before, brick)) out.insert(*rule);
    }
  }
  return {out.begin(), out.end()};
}

}  // namespace stig::compiler
