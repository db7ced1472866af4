// SPDX-License-Identifier: MIT
// What robots that are left can build no more: held against orders of work that are drawn, and said
// in reports.
#include "validate/out_of_reach.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "compiler/open_work.h"
#include "support.h"
#include "validate/findings.h"
#include "validate/set_up.h"

namespace stig {
namespace {

using Sides = std::vector<ApproachSide>;
constexpr ApproachSide kPlusX = ApproachSide::plus_x, kPlusY = ApproachSide::plus_y;
constexpr ApproachSide kMinusX = ApproachSide::minus_x, kMinusY = ApproachSide::minus_y;

BrickSet all_but(const TargetStates& states, const std::vector<Cell>& missing) {
  BrickSet out = BrickSet::first(states.bricks());
  for (const Cell cell : missing) out.remove(states.brick_at(cell));
  return out;
}

/// Where robots on these sides end that take one order of work, drawn.
BrickSet worked_on(const OpenWork& open, BrickSet state, const Sides& sides, std::mt19937& chance) {
  while (true) {
    const auto sites = open.in(state, sides);
    if (sites.empty()) return state;
    auto one = sites.begin();
    std::advance(one, std::uniform_int_distribution<std::size_t>(0, sites.size() - 1)(chance));
    state.add(one->first);
  }
}

/// The staircase or pyramid in a scene of its own, whose robots have built some of it.
struct HalfBuilt {
  explicit HalfBuilt(const std::string& name, int robots) : set(name) {
    target = {&set.rules, *set.compiled.proof.structure, {BuildSite{}}};
    SetUpRequest request;
    request.robots = robots;
    for (const SetUpLayout::Robot& one : lay_out(set.rules, set.compiled, request).robots) {
      RobotSpawn robot;
      robot.program = 0;
      robot.params = {{"side", std::string(to_string(one.side))}, {"sides", sides_text(one.bound)}};
      scene.robots.push_back(robot);
      trial.robots.push_back({});
    }
    scene.programs.push_back({});
    scene.programs[0].path = std::string(kControllerFile);
    trial.end = TrialEnd::time;
  }
  /// Every brick stands in its colour but these.
  void stand_all_but(const std::vector<Cell>& missing) {
    Judgement judgement;
    for (const PlacedBrick& brick : target.whole.bricks()) {
      const bool gone = std::find(missing.begin(), missing.end(), brick.at) != missing.end();
      BrickCheck check;
      check.cell = brick.at;
      check.wanted = brick.brick;
      if (!gone) check.block = 1;
      check.coloured = check.close = !gone;
      judgement.bricks.push_back(check);
    }
    trial.judgements = {judgement};
  }
  std::vector<std::string> said() const { return out_of_reach(target, set.compiled, scene, trial); }

  CompiledSet set;
  BuildTarget target;
  Scene scene;
  Trial trial;
};

}  // namespace

TEST_CASE("a wing's last brick is out of reach of robots on the other sides") {
  const CompiledSet set("stepped-pyramid");
  const BrickSet standing = all_but(*set.compiled.target, {{2, 0, 0}, {0, 2, 0}});
  const auto without = reach_of(set.compiled, standing, {kPlusY, kMinusX, kMinusY});
  REQUIRE(without);
  CHECK_FALSE(without->whole);
  CHECK(without->never == std::vector{set.compiled.target->brick_at({2, 0, 0})});
  const auto with = reach_of(set.compiled, standing, {kPlusX, kPlusY});
  REQUIRE(with);
  CHECK(with->whole);
  CHECK(with->never.empty());
  CHECK_FALSE(reach_of(set.compiled, standing, {kPlusX, kPlusY}, 3));
}

TEST_CASE("a structure that robots never come to says nothing") {
  const CompiledSet set("stepped-pyramid");
  // A wing hangs before a column that is not there.
  const BrickSet odd = all_but(*set.compiled.target, {{0, 0, 1}, {0, 0, 2}});
  if (!OpenWork(set.compiled).knows(odd)) CHECK_FALSE(reach_of(set.compiled, odd, {kPlusX}));
}

TEST_CASE("no order of work that is drawn goes beyond what is said to be reached") {
  std::mt19937 chance(20261128);
  for (const char* name : {"staircase", "stepped-pyramid"}) {
    const CompiledSet set(name);
    const OpenWork open(set.compiled);
    const TargetStates& states = *set.compiled.target;
    for (int round = 0; round < 40; ++round) {
      Sides sides;
      for (const ApproachSide side : set.compiled.sides) {
        if (chance() % 2 == 0) sides.push_back(side);
      }
      // A structure on the way, by work from anywhere.
      BrickSet standing(states.bricks());
      for (std::size_t i = 0; i < states.start_bricks(); ++i) standing.add(i);
      for (std::size_t left = chance() % states.bricks(); left > 0; --left) {
        const auto sites = open.in(standing);
        if (sites.empty()) break;
        auto one = sites.begin();
        std::advance(one, static_cast<std::ptrdiff_t>(chance() % sites.size()));
        standing.add(one->first);
      }
      const auto reach = reach_of(set.compiled, standing, sides);
      REQUIRE(reach);
      BrickSet ever = standing;
      bool whole = false;
      for (int order = 0; order < 60; ++order) {
        const BrickSet end = worked_on(open, standing, sides, chance);
        ever.add(end);
        whole = whole || end.count() == states.bricks();
      }
      if (whole) CHECK(reach->whole);
      for (const std::uint32_t brick : reach->never) CHECK_FALSE(ever.has(brick));
      // These sets never end short of what some order reaches, so that each order shows all.
      CHECK(ever.count() + reach->never.size() == states.bricks());
      if (sides.size() == set.compiled.sides.size()) CHECK(reach->whole);
    }
  }
}

TEST_CASE("a report says that a wing is lost with the only robot of its side") {
  HalfBuilt built("stepped-pyramid", 4);
  built.stand_all_but({{2, 0, 0}});
  CHECK(built.said().empty());
  built.trial.robots[0].halted = built.trial.robots[0].failed = true;
  REQUIRE(built.said().size() == 1);
  CHECK(built.said()[0] ==
        "it cannot be completed: robots that still run and keep to their sides work from +y -x -y "
        "alone, from where no order of work puts a brick at (2, 0, 0)");
  built.trial.cannot = built.said();
  const auto findings = findings_of(built.target, built.trial);
  CHECK(std::count(findings.begin(), findings.end(), built.said()[0]) == 1);
  // Several.
  built.stand_all_but({{2, 0, 0}, {1, 0, 1}, {0, 2, 0}});
  REQUIRE(built.said().size() == 1);
  CHECK(built.said()[0].ends_with("puts a brick at (1, 0, 1), (2, 0, 0)"));
  // One that another robot's side reaches.
  built.stand_all_but({{0, 2, 0}});
  CHECK(built.said().empty());
  built.trial.robots[1].fallen = true;
  CHECK(built.said().size() == 1);
  for (RobotRecord& robot : built.trial.robots) robot.left = true;
  REQUIRE(built.said().size() == 1);
  CHECK(built.said()[0] == "it cannot be completed: no robot is left that works");
}

TEST_CASE("a report says that a brick on another without light stays so") {
  HalfBuilt built("stepped-pyramid", 4);
  built.stand_all_but({{2, 0, 0}});
  const auto spoil = [&](Cell cell, bool dead) {
    for (BrickCheck& brick : built.trial.judgements[0].bricks) {
      if (brick.cell == cell) brick.coloured = false, brick.dead = dead;
    }
  };
  // One that only shows another colour may be told its own.
  spoil({0, 0, 2}, false);
  CHECK(built.said().empty());
  spoil({0, 0, 2}, true);
  REQUIRE(built.said().size() == 1);
  CHECK(built.said()[0] ==
        "it cannot be completed: all LEDs of the brick at (0, 0, 2) are dead, and robots take no "
        "brick off another");
  // From the floor a robot may take it.
  spoil({0, 1, 0}, true);
  CHECK(built.said().size() == 1);
  spoil({1, 0, 1}, true);
  CHECK(built.said().size() == 2);
  built.scene.robots[2].program = RobotSpawn::kNoProgram;
  CHECK(built.said().empty());
}

TEST_CASE("nothing is said of what is wrong, of robots bound to no side, or of other programs") {
  HalfBuilt built("stepped-pyramid", 4);
  built.stand_all_but({{2, 0, 0}});
  built.trial.robots[0].halted = true;
  REQUIRE(built.said().size() == 1);
  const Trial before = built.trial;
  const auto params = built.scene.robots[3].params;
  built.trial.judgements[0].against = AgainstRules{};
  CHECK(built.said().empty());
  built.trial = before;
  built.trial.judgements[0].extra.push_back({});
  CHECK(built.said().empty());
  built.trial = before;
  built.trial.judgements[0].bricks[0].coloured = false;
  CHECK(built.said().empty());
  built.trial = before;
  built.scene.robots[3].params.pop_back();
  CHECK(built.said().empty());
  built.scene.robots[3].params = params;
  CHECK(built.said().size() == 1);
  built.scene.robots[2].program = RobotSpawn::kNoProgram;
  CHECK(built.said().empty());
}

}  // namespace stig
