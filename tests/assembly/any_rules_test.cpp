// SPDX-License-Identifier: MIT
// Whether there are rules at all: held to what is known of runs, and to rules that were found.
#include "assembly/any_rules.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "assembly/assemble.h"
#include "assembly/clauses.h"
#include "assembly/run.h"
#include "assembly/targets.h"
#include "compiler/support.h"
#include "support/uses.h"

namespace stig {
namespace {

const Builders& from_all_sides() {
  static const Builders all{paper_robot(), {kAllSides.begin(), kAllSides.end()}};
  return all;
}

Answered ask(const TargetBricks& target, std::uint32_t start, int colours) {
  const auto visibility =
      std::make_shared<Visibility>(paper_robot(), window_levels(paper_robot(), target.levels()));
  return any_rules({target, from_all_sides(), visibility, colours}, start, {}).rules;
}

/// Is it refuted from whatever start?
bool refuted(const TargetBricks& target, int colours) {
  for (std::uint32_t i = 0; i < target.bricks(); ++i) {
    if (ask(target, i, colours) != Answered::no) return false;
  }
  return true;
}

TargetBricks line(int bricks) {
  std::vector<PlacedBrick> out;
  for (int x = 0; x < bricks; ++x) out.push_back({{x, 0, 0}, 1});
  return {out, 0};
}

Target ring(int wide, int deep) {
  Target out;
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) {
      if (x == 0 || y == 0 || x == wide - 1 || y == deep - 1) out.cells.push_back({x, y, 0});
    }
  }
  out.colours.assign(out.cells.size(), StateSet::anything());
  return out;
}

TargetBricks bricks(const Target& target) {
  std::vector<PlacedBrick> out;
  for (const Cell cell : target.cells) out.push_back({cell, 1});
  return {out, 0};
}

/// More pigeons than holes.
Clauses pigeons(int count) {
  Clauses out;
  std::vector<std::vector<int>> sits;
  for (int p = 0; p < count; ++p) {
    std::vector<int> holes;
    for (int h = 0; h + 1 < count; ++h) holes.push_back(out.variable());
    out.add(holes);
    for (const std::vector<int>& other : sits) {
      for (std::size_t h = 0; h < holes.size(); ++h) out.add({-holes[h], -other[h]});
    }
    sits.push_back(std::move(holes));
  }
  return out;
}

TEST_CASE("clauses are fulfilled, refuted with a proof that passes, or given up") {
  Clauses some;
  const int a = some.variable(), b = some.variable();
  some.add({a, b});
  some.add({-a});
  CHECK(some.fulfilled(1000) == Answered::yes);
  some.add({-b});
  CHECK(some.fulfilled(1000) == Answered::no);
  CHECK(some.size() == 3);
  CHECK(some.literals() == 7);
  CHECK(pigeons(5).fulfilled(100'000) == Answered::no);
  CHECK(pigeons(9).fulfilled(1) == Answered::given_up);
}

TEST_CASE("of a line that stands alone, rules are refuted exactly where a run is too long") {
  for (int colours = 1; colours <= 4; ++colours) {
    for (int length = 2; length <= 9; ++length) {
      CAPTURE(colours);
      CAPTURE(length);
      const TargetBricks target = line(length);
      CHECK(refuted(target, colours) == !runs_too_long(target, std::nullopt, colours).empty());
    }
  }
}

TEST_CASE("rings of one level with a side of six leave no rules, smaller ones do") {
  for (const int deep : {3, 4, 5, 6}) CHECK(refuted(bricks(ring(6, deep)), 4));
  for (const int deep : {3, 4, 5}) CHECK_FALSE(refuted(bricks(ring(5, deep)), 4));
  CHECK(refuted(bricks(ring(3, 3)), 1));
  AssemblyTask task;
  task.target = ring(6, 3);
  task.robot = paper_robot();
  task.wording.name = "ring";
  const Assembly made = assemble(task, 1);
  REQUIRE(made.obstacle);
  CHECK(made.obstacle->kind == AssemblyObstacle::Kind::rules);
  CHECK(takes_more_colours(*made.obstacle));
  CHECK(made.obstacle->starts == 14);
  CHECK(made.obstacle->structures > 14);
}

TEST_CASE(
    "what would be too many structures, or a brick more than there are colours, is not asked") {
  CHECK(ask(line(130), 0, 4) == Answered::given_up);
  Target plate;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) plate.cells.push_back({x, y, 0});
  }
  CHECK(ask(bricks(plate), 0, 4) == Answered::given_up);
}

TEST_CASE("whatever rules are found for robots, they are not refuted") {
  int made = 0, asked = 0;
  CHECK(rc::check([&] {
    const auto kind = *rc::gen::elementOf(
        std::vector<std::string_view>(kTargetKinds.begin(), kTargetKinds.end()));
    AssemblyTask task;
    task.target = drawn_target(kind, *rc::gen::inRange<std::uint64_t>(1, 1000));
    RC_PRE(task.target.cells.size() <= 12U);
    task.robot = paper_robot();
    task.most_colours = *rc::gen::inRange(2, 5);
    task.wording.name = "target";
    const Assembly found = assemble(task, 0.02);
    if (!found.plan) return;
    ++made;
    const TargetBricks target = bricks(task.target);
    const Answered answer = ask(target, target.brick_at(found.plan->start), task.most_colours);
    RC_ASSERT(answer != Answered::no);
    asked += answer == Answered::yes ? 1 : 0;
  }));
  CHECK(made > 20);
  CHECK(asked > 10);
}

}  // namespace
}  // namespace stig
