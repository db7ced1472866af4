// SPDX-License-Identifier: MIT
// From targets to rules that a robot can follow: what is printed compiles and completes, and what
// is called impossible is.
#include "assembly/assemble.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "assembly/large_targets.h"
#include "assembly/oracle.h"
#include "assembly/remedies.h"
#include "assembly/targets.h"
#include "compiler/lattice_walk.h"
#include "lattice/structure_text.h"
#include "support/uses.h"
#include "synthesis/shapes.h"

namespace stig {
namespace {

Target shape(std::string_view drawn) {
  Target out;
  for (const PlacedBrick& brick : structure_literal(drawn).bricks()) out.cells.push_back(brick.at);
  out.colours.assign(out.cells.size(), StateSet::anything());
  return out;
}

AssemblyTask task_for(Target target) {
  AssemblyTask out;
  out.target = std::move(target);
  out.robot = paper_robot();
  out.wording.name = "target";
  return out;
}

/// What a file with these rules is worth: compiled again, by nothing but what it says.
void check_file(const AssemblyTask& task, const AssemblyPlan& plan) {
  Diagnostics diagnostics;
  const auto rules =
      read_rule_set(std::make_shared<const SourceFile>("plan.yaml", plan.text), diagnostics);
  REQUIRE(rules);
  const CompiledRules compiled = compile_rules(*rules, task.robot, {}, diagnostics);
  REQUIRE_MESSAGE(compiled.decision, to_text(diagnostics));
  CHECK(compiled.proof.verdict == ProofVerdict::proved);
  CHECK(diagnostics.all().empty());
  CHECK(compiled.sides == plan.compiled.sides);
  std::vector<Cell> built;
  for (const PlacedBrick& brick : compiled.proof.structure->bricks()) built.push_back(brick.at);
  CHECK(built == task.target.cells);
}

void check_work(const AssemblyTask& task, const AssemblyPlan& plan) {
  std::vector<Cell> put = {plan.start};
  for (const WorkStep& step : plan.work) {
    CHECK(step.open >= 1);
    put.push_back(step.at);
  }
  std::sort(put.begin(), put.end());
  CHECK(put == task.target.cells);
}

TEST_CASE("a staircase, a plate, a plus and a bar get rules, for any number of robots") {
  for (const char* drawn : {"3 . .\n---\n3 2 .\n---\n3 2 1\n", "1 1 1\n1 1 1\n1 1 1\n",
                            ". 1 .\n1 1 1\n. 1 .\n", "1 1 1 1 1\n", "1 1\n"}) {
    CAPTURE(drawn);
    const AssemblyTask task = task_for(shape(drawn));
    const Assembly made = assemble(task, 1);
    REQUIRE(made.plan);
    CHECK_FALSE(made.obstacle);
    CHECK(made.plan->any_number);
    check_file(task, *made.plan);
    check_work(task, *made.plan);
    CHECK(assemble(task, 1).plan->text == made.plan->text);
  }
}

TEST_CASE("the sides, the start and the number of robots that were asked for stand in the file") {
  AssemblyTask task = task_for(shape("1 1 1\n1 1 1\n"));
  task.sides = {ApproachSide::plus_x, ApproachSide::minus_x};
  task.start = Cell{1, 0, 0};
  task.robots = 2;
  const Assembly made = assemble(task, 1);
  REQUIRE(made.plan);
  CHECK(made.plan->start == Cell{1, 0, 0});
  CHECK(made.plan->rules->start.front().at == Cell{1, 0, 0});
  CHECK(made.plan->rules->physical->sides == std::vector<std::string>{"+x", "-x"});
  CHECK(made.plan->rules->physical->robots == 2);
  check_file(task, *made.plan);
}

TEST_CASE("two robots get a side each, where there are rules for that; one is content with one") {
  AssemblyTask task = task_for(shape("1 1 1\n. . .\n---\n1 1 1\n1 1 1\n"));
  task.robots = 1;
  const Assembly for_one = assemble(task, 1);
  REQUIRE(for_one.plan);
  CHECK(for_one.plan->compiled.sides.size() == 1);
  task.robots = 2;
  const Assembly for_two = assemble(task, 1);
  REQUIRE(for_two.plan);
  CHECK(for_two.plan->any_number);
  CHECK(for_two.plan->compiled.sides.size() >= 2);
  CHECK(for_two.counts.candidates > for_one.counts.candidates);
  check_file(task, *for_two.plan);
}

TEST_CASE("colours of the target are kept") {
  AssemblyTask task = task_for(shape("1 1 1\n"));
  task.target.bricks.resize(2);
  task.target.bricks[0] = {"a", "red", "#ff0000", "Q3", {}};
  task.target.bricks[1] = {"b", "blue", "#0000ff", "Q2", {}};
  for (std::size_t i = 0; i < 3; ++i) task.target.colours[i] = StateSet::of(i == 1 ? 2 : 1);
  const Assembly made = assemble(task, 1);
  REQUIRE(made.plan);
  const auto bricks = made.plan->compiled.proof.structure->bricks();
  CHECK(bricks[0].brick == 1);
  CHECK(bricks[1].brick == 2);
  CHECK(bricks[2].brick == 1);
}

TEST_CASE("what cannot be built has a reason") {
  const Assembly apart = assemble(task_for(shape("1 . 1\n")), 1);
  REQUIRE(apart.obstacle);
  CHECK(apart.obstacle->kind == AssemblyObstacle::Kind::apart);
  CHECK(apart.obstacle->part.count() == 1);
  // Nothing goes over the opening of a gate: its lintel has to come last, and hangs on nothing.
  const Assembly high = assemble(task_for(shape("1\n---\n1\n---\n1\n---\n1\n")), 1);
  REQUIRE(high.obstacle);
  CHECK(high.obstacle->kind == AssemblyObstacle::Kind::remainder);
  REQUIRE(high.obstacle->remainder.barred.size() == 4);
  CHECK(high.obstacle->remainder.barred.back().bars.front().why.obstruction ==
        Obstruction::too_high);
  const Assembly line = assemble(task_for(shape("1 1 1 1 1 1 1 1\n")), 1);
  REQUIRE(line.obstacle);
  CHECK(line.obstacle->kind == AssemblyObstacle::Kind::runs);
  CHECK(line.obstacle->colours == kBlockColours);
  CHECK(line.counts.candidates == 0);
}

TEST_CASE("nothing is found without effort, and a search that was stopped says so") {
  const AssemblyTask task = task_for(shape("1 1 1\n1 1 1\n"));
  const Assembly none = assemble(task, 0);
  CHECK_FALSE(none.plan);
  CHECK_FALSE(none.obstacle);
  CHECK_FALSE(none.cut_short);
  const std::atomic<bool> stop = true;
  AssemblyHooks hooks;
  hooks.deadline.stop = &stop;
  CHECK(assemble(task, 1, hooks).cut_short);
}

TEST_CASE("targets by chance: what is made compiles and completes, what is impossible is") {
  const Builders all{paper_robot(), {kAllSides.begin(), kAllSides.end()}};
  CHECK(rc::check([&] {
    const auto kind = *rc::gen::elementOf(
        std::vector<std::string_view>(kTargetKinds.begin(), kTargetKinds.end()));
    const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1000);
    AssemblyTask task = task_for(drawn_target(kind, seed));
    RC_PRE(task.target.cells.size() <= 8U);
    RC_TAG(std::string(kind));
    std::vector<PlacedBrick> bricks;
    for (const Cell cell : task.target.cells) bricks.push_back({cell, 1});
    const bool possible = can_be_built(TargetBricks(bricks, 0), all, 100'000).value();
    const Assembly made = assemble(task, 0.02);
    if (made.plan) {
      RC_ASSERT(possible);
      check_file(task, *made.plan);
      check_work(task, *made.plan);
      check_completes(*made.plan->rules);
    }
    if (made.obstacle && !takes_more_colours(*made.obstacle)) RC_ASSERT(!possible);
  }));
}

TEST_CASE("an order whose rules are in conflict as they are written gives way to another") {
  const AssemblyTask task = task_for(drawn_target("height map", 770'913));
  const Assembly made = assemble(task, 1);
  CHECK(made.counts.refused > 0);
  REQUIRE(made.plan);
  check_file(task, *made.plan);
  check_work(task, *made.plan);
}

std::string first_remedy(const AssemblyTask& task) {
  const Assembly made = assemble(task, 1);
  REQUIRE_FALSE(made.plan.has_value());
  const auto remedies = find_remedies(task, made, {}, 1, {});
  REQUIRE_FALSE(remedies.empty());
  return remedies.front().what;
}

TEST_CASE("colours are a remedy for what colours were asked for, and kinds where there are more") {
  AssemblyTask task = task_for(box({8, 1, 1}));
  CHECK(first_remedy(task) == "with --kinds 16");
  task.most_colours = 3;
  CHECK(first_remedy(task) == "with colours as they are needed and --kinds 16");
  task.kinds = 16;
  CHECK(first_remedy(task) == "with colours as they are needed");
}

TEST_CASE("a lift that goes higher than structures takes nothing from what can be built") {
  AssemblyTask task = task_for(box({2, 1, 2}));
  task.robot.lift_travel = 5;
  CHECK(assemble(task, 1).plan.has_value());
}

TEST_CASE("of targets that are too large for rules it is said whether they are impossible") {
  const Assembly town = assemble(task_for(paved_town_target(7000, 1)), 1);
  REQUIRE(town.obstacle.has_value());
  CHECK(town.obstacle->kind == AssemblyObstacle::Kind::remainder);
  CHECK_FALSE(town.too_many);
  const Assembly plate = assemble(task_for(box({80, 80, 1})), 1);
  CHECK(plate.too_many);
  CHECK_FALSE(plate.plan.has_value());
  CHECK_FALSE(plate.obstacle.has_value());
}

TEST_CASE("a maze is left by no straight way, and is refused with as many kinds of brick") {
  AssemblyTask task = task_for(maze_target(500, 3, 1));
  task.most_colours = kMaxColours;
  const Assembly made = assemble(task, 1);
  REQUIRE(made.obstacle.has_value());
  REQUIRE(made.obstacle->kind == AssemblyObstacle::Kind::remainder);
  const auto& barred = made.obstacle->remainder.barred;
  CHECK(std::any_of(barred.begin(), barred.end(), [](const auto& one) { return one.joins; }));
}

}  // namespace
}  // namespace stig
