// SPDX-License-Identifier: MIT
// The table is for people, the others for programs: DOT for Graphviz, the intermediate
// representation and the line map as JSON, each with a version in its first key.
#include "compile_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "compiler/conflict_text.h"
#include "compiler/decision_text.h"
#include "report.h"

namespace stig::cli {
namespace {

std::string sides_text(const CompiledRules& compiled) {
  std::string out;
  for (const ApproachSide side : compiled.sides) {
    out += (out.empty() ? "" : " ") + std::string(to_string(side));
  }
  return out;
}

// A leaf says what to do, an inner node what to ask.
Json node_json(const RuleSet& rules, const DecisionNode& node) {
  if (!node.question) {
    if (!node.placement) return {{"do", "nothing"}};
    const Placement& p = *node.placement;
    // In the order of the enumeration.
    constexpr const char* kKinds[] = {"raise", "extend", "beside"};
    Json out = {{"do", kKinds[static_cast<std::size_t>(kind_of(p))]},
                {"led", rules.brick(p.colour).led}};
    // A raise is on top of the column: it needs no place.
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

Json robots_json(const CompiledRules& compiled) {
  const Concurrency& found = compiled.concurrency;
  Json out = {{"wanted", compiled.robots ? Json(*compiled.robots) : Json(nullptr)},
              {"any_number", found.conflicts.empty()},
              {"one_a_side", found.conflicts.empty() || found.one_a_side},
              {"structures", found.structures},
              {"pairs", found.pairs},
              {"ways_cross", found.ways_cross}};
  out["conflicts"] = Json::array();
  // Conflicts in words, since their structures mean nothing without the rest.
  for (const Conflict& one : found.conflicts) {
    out["conflicts"].push_back(
        {{"kind", to_string(one.kind)}, {"what", conflict_text(compiled, one)}});
  }
  return out;
}

// The program as a state chart: events lead from one state to the next.
Json chart_json(const Chart& chart) {
  Json out = Json::array();
  for (const ChartState& state : chart.states) {
    Json on = Json::object();
    for (const ChartStep& step : state.steps) on[std::string(step.event)] = step.to;
    out.push_back({{"state", state.name}, {"does", state.behaviour}, {"on", std::move(on)}});
  }
  return out;
}

}  // namespace

void show_drawings(const CompiledRules& compiled, const App& app) {
  // Editors that read JSON get no drawings in between.
  if (app.options().json_diagnostics) return;
  for (const RefusalDrawing& one : compiled.drawings) app.say(one.title + ":\n" + one.drawing);
}

std::string compile_table(const CompileJob& job) {
  assert(job.rules != nullptr && job.compiled != nullptr && job.compiled->decision != nullptr);
  const CompiledRules& compiled = *job.compiled;
  std::string out = fmt::format("{}: before the foremost column of a row\n\n", job.rules->name);
  out += decision_text(*job.rules, *compiled.decision);
  out += fmt::format("\nstructure    {}, {} at the start\n",
                     counted(compiled.target->bricks(), "brick"), compiled.target->start_bricks());
  out += fmt::format("sides        {}; {}\n", sides_text(compiled), to_string(compiled.directions));
  for (const Viewpoint& viewpoint : job.plan.viewpoints) {
    // In mm, as one measures on a table.
    out += fmt::format("looks from   {:.0f} mm before the column, lift at {:.0f} mm\n",
                       1e3 * viewpoint.distance, 1e3 * viewpoint.lift);
  }
  out += fmt::format("proved       {}\n", completion_text(compiled));
  out += fmt::format("robots       {}\n", robots_text(compiled));
  return out;
}

std::string compile_dot(const CompileJob& job) {
  assert(job.rules != nullptr && job.compiled != nullptr && job.plan.chart != nullptr);
  // Two graphs in one file: dot draws both.
  return decision_dot(*job.rules, *job.compiled->decision) + chart_dot(*job.plan.chart);
}

std::string compile_ir(const CompileJob& job) {
  assert(job.robot != nullptr && job.compiled != nullptr && job.plan.chart != nullptr);
  const CompiledRules& compiled = *job.compiled;
  const Abilities& robot = *job.robot;
  Json out = {{"stigc_ir", 1}, {"rules", job.rules->name}};
  out["directions"] = to_string(compiled.directions);
  out["sides"] = Json::array();
  for (const ApproachSide side : compiled.sides) out["sides"].push_back(to_string(side));
  // Those figures of the robot that the decisions depend on.
  out["robot"] = {{"levels", robot.levels},
                  {"lift_travel", robot.lift_travel},
                  {"clearance", robot.clearance},
                  {"carried_x", robot.carried_x},
                  {"effector_front", robot.effector_front}};
  out["structure"] = {{"bricks", compiled.target->bricks()},
                      {"start", compiled.target->start_bricks()},
                      {"on_the_way", structures_on_the_way(compiled)},
                      {"situations", compiled.local_situations}};
  out["robots"] = robots_json(compiled);
  out["decision"] = node_json(*job.rules, *compiled.decision);
  out["looks"] = Json::array();
  for (const Viewpoint& viewpoint : job.plan.viewpoints) {
    out["looks"].push_back({{"distance", viewpoint.distance}, {"lift", viewpoint.lift}});
  }
  out["transport"] = job.plan.transport;
  out["longest_wait"] = job.plan.longest_wait;
  out["chart"] = chart_json(*job.plan.chart);
  return dump(out);
}

std::string line_map_json(const CompileJob& job, const ControllerText& program) {
  assert(job.rules != nullptr);
  Json out = {{"stigc_line_map", 1}, {"rules", job.rules->name}, {"lines", Json::array()}};
  for (const LineOrigin& one : program.lines) {
    // Rules are called by the names that they have for people.
    out["lines"].push_back(
        {{"line", one.line}, {"rule", job.rules->rules[one.rule].name}, {"source", one.source}});
  }
  return dump(out);
}

}  // namespace stig::cli
