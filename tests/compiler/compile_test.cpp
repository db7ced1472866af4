// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "compiler/decision_text.h"
#include "support.h"
#include "support/uses.h"

namespace stig {
namespace {

struct Compiled {
  RuleSet rules;
  Diagnostics diagnostics;
  CompiledRules result;

  explicit Compiled(RuleSet set, std::vector<ApproachSide> sides = {}) : rules(std::move(set)) {
    CompileOptions options;
    options.sides = std::move(sides);
    result = compile_rules(rules, paper_robot(), options, diagnostics);
  }
  std::string codes() const {
    std::string out;
    for (const Diagnostic& one : diagnostics.all()) out += std::string(info(one.code).name) + " ";
    return out;
  }
};

TEST_CASE("the staircase comes out as the five branches of the paper's Algorithm 1") {
  const Compiled staircase(shipped("staircase"));
  REQUIRE(staircase.result.decision);
  CHECK(staircase.result.directions == KnownDirections::declared);
  CHECK(decision_text(staircase.rules, *staircase.result.decision) ==
        "colour of the column's top?\n"
        "  Q1: nothing\n"
        "  Q2: level of the column's top?\n"
        "    0: raise with Q2\n"
        "    1: extend with Q1\n"
        "  Q3: level of the column's top?\n"
        "    0, 1: raise with Q3\n"
        "    2: extend with Q2\n");
}

TEST_CASE("the same rules from four sides are the pyramid, and need no directions") {
  const Compiled pyramid(shipped("stepped-pyramid"));
  REQUIRE(pyramid.result.decision);
  CHECK(pyramid.result.directions == KnownDirections::symmetric);
  CHECK(pyramid.result.sides.size() == 4);
  // Wings are built when the middle has its height: seen behind them, on level 2.
  CHECK(decision_text(pyramid.rules, *pyramid.result.decision) ==
        "colour of the column's top?\n"
        "  Q1: nothing\n"
        "  Q2: level of the column's top?\n"
        "    0: the cell behind the column, level 2?\n"
        "      empty: nothing\n"
        "      Q3: raise with Q2\n"
        "    1: the cell behind the column, level 2?\n"
        "      empty: nothing\n"
        "      Q3: extend with Q1\n"
        "  Q3: level of the column's top?\n"
        "    0, 1: raise with Q3\n"
        "    2: extend with Q2\n");
}

TEST_CASE("what is seen from two sides is told apart by the side, where nothing else tells") {
  const Compiled u(rule_set(STIG_TESTS_DIR "/compiler/u.yaml"),
                   {ApproachSide::plus_y, ApproachSide::minus_y});
  REQUIRE(u.result.decision);
  CHECK(decision_text(u.rules, *u.result.decision) ==
        "colour of the column's top?\n"
        "  Q1: nothing\n"
        "  Q2: side that the robot works from?\n"
        "    +y: extend with Q1\n"
        "    -y: nothing\n"
        "  Q3: the cell right of the column, level 0?\n"
        "    empty: put Q2 to the right on level 0\n"
        "    Q2: nothing\n");
  // Undeclared, a robot does not know.
  RuleSet undeclared = u.rules;
  undeclared.physical->sides.clear();
  CHECK(Compiled(undeclared).codes() == "P706 ");
}

TEST_CASE("a start that floats, or shuts a site in, is refused before anything is walked") {
  RuleSet floats = rule_set(STIG_TESTS_DIR "/compiler/overhang.yaml");
  for (PlacedBrick& brick : floats.start) ++brick.at.z;
  for (Rule& rule : floats.rules) {
    if (rule.height_min) ++*rule.height_min;
    if (rule.height_max) ++*rule.height_max;
  }
  CHECK(Compiled(floats).codes() == "P709 ");
  RuleSet shut = rule_set(STIG_TESTS_DIR "/compiler/column.yaml");
  shut.physical = PhysicalSpec{};
  const PlacedBrick middle = shut.start.front();
  for (const Cell step : {Cell{2, 0, 0}, Cell{-2, 0, 0}, Cell{0, 2, 0}, Cell{0, -2, 0}}) {
    shut.start.push_back({{middle.at.x + step.x, middle.at.y + step.y, middle.at.z}, middle.brick});
  }
  const Compiled refused(shut);
  CHECK(refused.codes() == "P710 ");
  CHECK(refused.result.policy.states.empty());
}

TEST_CASE("robots that share a side are warned of") {
  RuleSet u = rule_set(STIG_TESTS_DIR "/compiler/u.yaml");
  u.physical->robots = 2;
  CHECK(Compiled(u).codes().empty());
  const Compiled shared(u, {ApproachSide::plus_y});
  CHECK(shared.result.decision);
  CHECK(shared.codes() == "P715 ");
}

TEST_CASE("a line and a column") {
  CHECK(Compiled(rule_set(STIG_TESTS_DIR "/compiler/line.yaml")).result.decision);
  CHECK(Compiled(rule_set(STIG_TESTS_DIR "/compiler/column.yaml")).result.decision);
}

TEST_CASE("what a robot cannot build is refused, each with its own reason") {
  std::size_t files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(STIG_TESTS_DIR "/compiler/refused")) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    const Compiled compiled(rule_set(entry.path().string()));
    CHECK(!compiled.result.decision);
    CHECK(compiled.codes() == name.substr(0, 4) + " ");
    ++files;
  }
  CHECK(files == 18);
}

TEST_CASE("a site that touches the start by an edge alone is next to no column") {
  const Compiled compiled(rule_set(STIG_TESTS_DIR "/compiler/refused/P710-edge.yaml"));
  std::size_t alone = 0;
  REQUIRE(compiled.diagnostics.all().size() == 1);
  for (const Note& note : compiled.diagnostics.all()[0].notes) {
    CAPTURE(note.message);
    CHECK(note.message.find("it can be reached") == std::string::npos);
    alone += note.message.find("it is not on, before or beside any column") != std::string::npos;
  }
  CHECK(alone == 2);
}

TEST_CASE("the exact staircase needs directions, and with them cannot be reached") {
  CHECK(Compiled(shipped("staircase-exact")).codes() == "P706 ");
  CHECK(Compiled(shipped("staircase-exact"), {ApproachSide::plus_x}).codes() == "P710 ");
  CHECK(Compiled(shipped("stepped-pyramid-exact")).codes() == "P710 ");
}

TEST_CASE("a proof that ran out of budget is no refusal of the rules, one that failed is") {
  CompileOptions options;
  options.verify.seconds = 1e-9;
  Diagnostics diagnostics;
  const RuleSet staircase = shipped("staircase");
  const auto cut_short = compile_rules(staircase, paper_robot(), options, diagnostics);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].code == Code::P701);
  CHECK(!cut_short.decision);
  CHECK(cut_short.unknown);
  CHECK(!compile_rules(shipped("staircase-exact"), paper_robot(), {}, diagnostics).unknown);
}

TEST_CASE("the limit of structures is said, not passed, where columns prove nothing either") {
  const RuleSet exact = shipped("staircase-exact"), pyramid = shipped("stepped-pyramid");
  CompileOptions options;
  options.limits.states = 1;
  Diagnostics diagnostics;
  const auto result = compile_rules(exact, paper_robot(), options, diagnostics);
  CHECK(!result.decision);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].code == Code::P712);
  CHECK(result.unknown);
  const auto proved = compile_rules(pyramid, paper_robot(), options, diagnostics);
  CHECK(proved.decision);
  CHECK(proved.local_situations > 0);
}

}  // namespace
}  // namespace stig
