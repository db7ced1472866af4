// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "compiler/controller_lua.h"
#include "support.h"
#include "support/uses.h"

namespace stig {
namespace {

struct Planned {
  RuleSet rules;
  Abilities robot = paper_robot();
  CompiledRules compiled;
  ControllerPlan plan;

  explicit Planned(RuleSet set) : rules(std::move(set)) {
    Diagnostics diagnostics;
    compiled = compile_rules(rules, robot, {}, diagnostics);
    REQUIRE(compiled.decision);
    plan = plan_controller(rules, robot, compiled);
  }
};

std::string decisions(const ControllerText& program) {
  const std::size_t from = program.text.find("local function decide");
  return program.text.substr(from, program.text.find("\nend\n", from) + 5 - from);
}

TEST_CASE("the staircase's decisions as Lua") {
  const Planned staircase(shipped("staircase"));
  const ControllerText program =
      controller_lua(staircase.rules, "staircase.yaml", staircase.plan, staircase.compiled, {});
  CHECK(decisions(program) ==
        "local function decide(column)\n"
        "   if column.top_colour == 2 then\n"
        "      if column.top_level == 0 then\n"
        "         -- staircase.yaml:54 raise the middle column\n"
        "         return { what = 'raise', colour = 2, branch = 1 }\n"
        "      elseif column.top_level == 1 then\n"
        "         -- staircase.yaml:65 start the low column\n"
        "         return { what = 'extend', colour = 1, level = 0, branch = 2 }\n"
        "      end\n"
        "   elseif column.top_colour == 3 then\n"
        "      if column.top_level == 0 or column.top_level == 1 then\n"
        "         -- staircase.yaml:40 raise the tall column\n"
        "         return { what = 'raise', colour = 3, branch = 3 }\n"
        "      elseif column.top_level == 2 then\n"
        "         -- staircase.yaml:48 start the middle column\n"
        "         return { what = 'extend', colour = 2, level = 0, branch = 4 }\n"
        "      end\n"
        "   end\n"
        "end\n");
  CHECK(program.lines.size() == 8);
}

TEST_CASE(
    "columns whose foot is not there are cases like others, without a branch for what is not "
    "seen") {
  const Planned overhang(rule_set(STIG_TESTS_DIR "/compiler/overhang.yaml"));
  const ControllerText program =
      controller_lua(overhang.rules, "o.yaml", overhang.plan, overhang.compiled, {});
  CHECK(decisions(program) ==
        "local function decide(column)\n"
        "   if column.top_colour == 1 then\n"
        "      -- o.yaml:15 up\n"
        "      return { what = 'raise', colour = 2, branch = 1 }\n"
        "   elseif column.top_colour == 2 then\n"
        "      -- o.yaml:21 out\n"
        "      return { what = 'extend', colour = 3, level = 1, branch = 2 }\n"
        "   end\n"
        "end\n");
}

TEST_CASE("for ARGoS the same program, its library between the adapter and four callbacks") {
  const Planned staircase(shipped("staircase"));
  const std::string adapter = "local argos = {}\nreturn argos\n";
  const std::string building =
      "local lattice = require 'mission.lattice'\nlocal building = {}\nreturn building\n";
  const ControllerText ours =
      controller_lua(staircase.rules, "s.yaml", staircase.plan, staircase.compiled, {building});
  const ControllerText argos = controller_argos(staircase.rules, "s.yaml", staircase.plan,
                                                staircase.compiled, "{}", adapter, {building});
  CHECK(decisions(argos) == decisions(ours));
  const std::size_t own = ours.text.find("local building = (function()");
  REQUIRE(own != std::string::npos);
  CHECK(ours.text.find("require") == std::string::npos);
  CHECK(argos.text.substr(0, own) == ours.text.substr(0, own));
  std::size_t at = 0;
  for (const char* next : {"local argos = (function()", "local math = argos.math", "argos.describe",
                           "local building = (function()", "function init()", "function reset()",
                           "function step()", "function destroy()"}) {
    CAPTURE(next);
    at = argos.text.find(next, at);
    REQUIRE(at != std::string::npos);
  }
  REQUIRE(argos.lines.size() == ours.lines.size());
  for (std::size_t i = 0; i < ours.lines.size(); ++i) {
    CHECK(argos.lines[i].line == ours.lines[i].line);
  }
}

TEST_CASE("where nothing is to be done, the program does nothing") {
  const Planned done(rule_set(STIG_TESTS_DIR "/compiler/done.yaml"));
  const ControllerText program = controller_lua(done.rules, "d.yaml", done.plan, done.compiled, {});
  CHECK(decisions(program) == "local function decide(_)\nend\n");
}

TEST_CASE("names from untrusted files stay in their comments and texts") {
  RuleSet rules = shipped("staircase");
  rules.name = "x\nos.exit()";
  for (Rule& rule : rules.rules) rule.name = "]]\nerror('out')";
  const Planned planned(std::move(rules));
  const ControllerText program =
      controller_lua(planned.rules, "a\nb.yaml", planned.plan, planned.compiled, {});
  CHECK(program.text.find("\nos.exit") == std::string::npos);
  CHECK(program.text.find("\nerror") == std::string::npos);
  CHECK(program.text.find("\nb.yaml") == std::string::npos);
}

TEST_CASE("from the chosen looks alone every column that can arise leads to the same decision") {
  for (const char* name : {"staircase", "stepped-pyramid"}) {
    CAPTURE(name);
    const Planned planned(shipped(name));
    CHECK(planned.plan.viewpoints.size() <= 3);
    Sight sight(*planned.compiled.target, planned.robot);
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < sight.viewpoints().size(); ++i) {
      const Viewpoint& one = sight.viewpoints()[i];
      if (std::any_of(planned.plan.viewpoints.begin(), planned.plan.viewpoints.end(),
                      [&](const Viewpoint& l) {
                        return l.distance == one.distance && l.lift == one.lift;
                      })) {
        used.push_back(i);
      }
    }
    REQUIRE(used.size() == planned.plan.viewpoints.size());
    const Policy& policy = planned.compiled.policy;
    for (const Situation& at : policy.situations) {
      if (!policy.reached[at.state]) continue;
      const auto& from = sight.look_from_each(policy.states[at.state], at.side, at.u, at.v);
      Observation seen = from[used[0]];
      for (const std::size_t i : used) {
        for (std::size_t c = 0; c < seen.cells.size(); ++c) {
          if (from[i].cells[c] != kUnseen) seen.cells[c] = from[i].cells[c];
        }
      }
      CHECK(decide(*planned.compiled.decision, seen) ==
            decide(*planned.compiled.decision, policy.observations[at.observation]));
    }
  }
}

TEST_CASE("the chart leads from every state to every other, and only to states it has") {
  const Chart& chart = building_chart();
  std::set<std::string_view> names;
  for (const ChartState& state : chart.states) CHECK(names.insert(state.name).second);
  for (const ChartState& state : chart.states) {
    std::set<std::string_view> events, reached{state.name};
    for (const ChartStep& step : state.steps) {
      CHECK(names.contains(step.to));
      CHECK(events.insert(step.event).second);
    }
    for (std::size_t before = 0; before != reached.size();) {
      before = reached.size();
      for (const ChartState& one : chart.states) {
        if (!reached.contains(one.name)) continue;
        for (const ChartStep& step : one.steps) reached.insert(step.to);
      }
    }
    CHECK(reached.size() == names.size());
  }
}

TEST_CASE("a block on its way has a colour that no brick has") {
  CHECK(Planned(shipped("staircase")).plan.transport == 4);
  RuleSet rules = shipped("staircase");
  for (Brick& brick : rules.bricks) {
    if (brick.led == "Q1") brick.led = "Q4";
  }
  CHECK(Planned(std::move(rules)).plan.transport == 1);
}

}  // namespace
}  // namespace stig
