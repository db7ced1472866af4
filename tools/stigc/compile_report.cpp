// SPDX-License-Identifier: MIT
#include "compile_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compiler/decision_text.h"
#include "report.h"

namespace stig {
namespace {

std::string sides_text(const CompiledRules& compiled) {
  std::string out;
  for (const ApproachSide side : compiled.sides) {
    out += (out.empty() ? "" : " ") + std::string(to_string(side));
  }
  return out;
}

std::size_t reached(const CompiledRules& compiled) {
  return static_cast<std::size_t>(
      std::count(compiled.policy.reached.begin(), compiled.policy.reached.end(), true));
}

std::string table(const RuleSet& rules, const CompiledRules& compiled) {
  std::string out = fmt::format("{}: before the foremost column of a row\n\n", rules.name);
  out += decision_text(rules, *compiled.decision);
  out += fmt::format("\nstructure    {} bricks, {} at the start\n", compiled.target->bricks(),
                     compiled.target->start_bricks());
  out += fmt::format("sides        {}; {}\n", sides_text(compiled), to_string(compiled.directions));
  out += fmt::format(
      "proved       every order of work completes it: {} structures can occur on the way\n",
      reached(compiled));
  return out;
}

Json node_json(const RuleSet& rules, const DecisionNode& node) {
  if (!node.question) {
    if (!node.placement) return {{"do", "nothing"}};
    const Placement& p = *node.placement;
    constexpr const char* kKinds[] = {"raise", "extend", "beside"};
    Json out = {{"do", kKinds[static_cast<std::size_t>(kind_of(p))]},
                {"led", rules.brick(p.colour).led}};
    if (kind_of(p) != PlacementKind::raise) {
      out["at"] = {{"before", p.at.du}, {"left", p.at.dv}, {"level", p.at.z}};
    }
    return out;
  }
  Json out = {{"ask", question_text(*node.question)}, {"answers", Json::array()}};
  for (const auto& [answers, child] : node.branches) {
    out["answers"].push_back(
        {{"is", answers_text(rules, *node.question, answers)}, {"then", node_json(rules, *child)}});
  }
  return out;
}

Json ir(const RuleSet& rules, const Abilities& robot, const CompiledRules& compiled) {
  Json out = {{"stigc_ir", 1}, {"rules", rules.name}};
  out["directions"] = to_string(compiled.directions);
  out["sides"] = Json::array();
  for (const ApproachSide side : compiled.sides) out["sides"].push_back(to_string(side));
  out["robot"] = {{"levels", robot.levels},
                  {"lift_travel", robot.lift_travel},
                  {"clearance", robot.clearance},
                  {"carried_x", robot.carried_x},
                  {"effector_front", robot.effector_front}};
  out["structure"] = {{"bricks", compiled.target->bricks()},
                      {"start", compiled.target->start_bricks()},
                      {"on_the_way", reached(compiled)}};
  out["decision"] = node_json(rules, *compiled.decision);
  return out;
}

}  // namespace

std::string compile_text(CompileTarget target, const RuleSet& rules, const Abilities& robot,
                         const CompiledRules& compiled) {
  switch (target) {
    case CompileTarget::table:
      return table(rules, compiled);
    case CompileTarget::dot:
      return decision_dot(rules, *compiled.decision);
    case CompileTarget::ir:
      return dump(ir(rules, robot, compiled));
  }
  return {};
}

}  // namespace stig
