// SPDX-License-Identifier: MIT
#include "validate/judge.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support.h"
#include "validate/findings.h"

namespace stig {
namespace {

Judgement judged(const Staircase& stairs) {
  return judge(stairs.target, 0, stairs.blocks, stairs.events());
}

std::string all_findings(const Staircase& stairs, const Judgement& judgement) {
  Trial trial;
  trial.judgements = {judgement};
  trial.loose = {stairs.block(8, {9, 9, 0}, Led::off)};
  std::string out;
  for (const std::string& one : findings_of(stairs.target, trial)) out += one + "\n";
  return out;
}

TEST_CASE("a right structure is complete, wherever and however the blocks are turned") {
  Staircase stairs;
  // A cube looks the same in 24 positions.
  stairs.blocks[2].X_WB.q = stairs.blocks[2].X_WB.q * rotation({0, 0, M_PI / 2});
  stairs.blocks[3].X_WB.q = stairs.blocks[3].X_WB.q * rotation({M_PI, 0, 0});
  stairs.blocks[1].X_WB.p += Vec3{0.001, 0, 0};
  const Judgement judgement = judged(stairs);
  CHECK(judgement.verdict == BuildVerdict::complete);
  CHECK(judgement.bricks.size() == 6);
  CHECK(judgement.placements == 5);
  CHECK(judgement.allowed == 5);
  CHECK(judgement.worst_drift == doctest::Approx(0.001));
  CHECK(judgement.worst_joint_way == doctest::Approx(0.001));
  // The lattice that fits best shares it out.
  CHECK(judgement.worst_way > 0.0002);
  CHECK(judgement.worst_way < 0.001);
  CHECK(all_findings(stairs, judgement).empty());
}

TEST_CASE("a block elsewhere in the arena does not matter") {
  Staircase stairs;
  stairs.blocks.push_back(stairs.block(9, {5, 5, 0}, Led::off));
  CHECK(judged(stairs).verdict == BuildVerdict::complete);
}

TEST_CASE("what was pushed out first is told first") {
  Staircase stairs;
  std::erase_if(stairs.blocks, [&](const WatchedBlock& block) {
    return block.block == stairs.at({2, 0, 0}).block;
  });
  Trial trial;
  trial.judgements = {judged(stairs)};
  const auto leaves = [&](double time, Cell cell) {
    trial.events.push_back({BrickEvent::Kind::left, time, 3, cell, Led::q1});
  };
  leaves(50, {2, 0, 0});
  CHECK(findings_of(stairs.target, trial).front() ==
        "the brick at (2, 0, 0) left its place at 50 s");
  leaves(50.6, {1, 0, 0});
  leaves(80, {1, 0, 1});
  CHECK(findings_of(stairs.target, trial).front() ==
        "the bricks at (2, 0, 0) and (1, 0, 0) left their places at 50 s");
}

TEST_CASE("a missing brick") {
  Staircase stairs;
  std::erase_if(stairs.blocks, [&](const WatchedBlock& block) {
    return block.block == stairs.at({2, 0, 0}).block;
  });
  const Judgement judgement = judged(stairs);
  CHECK(judgement.verdict == BuildVerdict::incomplete);
  CHECK(judgement.missing() == 1);
  CHECK(all_findings(stairs, judgement).find("missing: a Q1 brick at (2, 0, 0)") !=
        std::string::npos);
}

TEST_CASE("what has come to its cell but has not rested there is no brick yet") {
  Staircase stairs;
  std::vector<BrickEvent> events = stairs.events();
  const Cell last = events.back().cell;
  events.pop_back();
  const Judgement judgement = judge(stairs.target, 0, stairs.blocks, events);
  CHECK(judgement.verdict == BuildVerdict::incomplete);
  CHECK(judgement.missing() == 1);
  CHECK(judgement.extra.empty());
  CHECK(judgement.placements == 4);
  for (const BrickCheck& brick : judgement.bricks)
    CHECK(brick.block.has_value() == (brick.cell != last));
  // Nobody has brought anything: what lies there is no work of the rules.
  CHECK(judge(stairs.target, 0, stairs.blocks, {}).missing() == 5);
  // In a cell where no brick belongs it is in the way all the same.
  stairs.blocks.push_back(stairs.block(9, {0, 1, 0}, Led::q1));
  CHECK(judge(stairs.target, 0, stairs.blocks, events).verdict == BuildVerdict::wrong);
}

TEST_CASE("a brick 4 mm off is wrong, one turned by 3° too") {
  Staircase off, turned;
  off.at({1, 0, 1}).X_WB.p += Vec3{0, 0.004, 0};
  CHECK(judged(off).verdict == BuildVerdict::wrong);
  CHECK(judged(off).worst_drift == doctest::Approx(0.004));
  CHECK(judged(off).worst_joint_way == doctest::Approx(0.004));
  CHECK(judged(off).worst_way > 0.002);
  CHECK(all_findings(off, judged(off)).find("at (1, 0, 1) is off by") != std::string::npos);
  WatchedBlock& block = turned.at({2, 0, 0});
  block.X_WB.q = rotation({0, 0, 3 * M_PI / 180}) * block.X_WB.q;
  CHECK(judged(turned).verdict == BuildVerdict::wrong);
  const Judgement judgement = judged(turned);
  CHECK(judgement.worst_joint_turn * 180 / M_PI == doctest::Approx(3));
}

TEST_CASE("neighbours that part by more than 2 mm, each within 2 mm of its cell") {
  Staircase stairs;
  const Vec3 along = rotate(stairs.target.sites[0].X_WL.q, {0.0015, 0, 0});
  stairs.at({1, 0, 0}).X_WB.p += along;
  CHECK(judged(stairs).verdict == BuildVerdict::complete);
  stairs.at({1, 0, 1}).X_WB.p += -along;
  const Judgement judgement = judged(stairs);
  CHECK(judgement.worst_drift == doctest::Approx(0.0015));
  CHECK(judgement.worst_joint_way == doctest::Approx(0.003));
  CHECK(judgement.verdict == BuildVerdict::wrong);
  REQUIRE(judgement.loose.size() == 1);
  CHECK(judgement.loose[0].a == Cell{1, 0, 0});
  CHECK(judgement.loose[0].b == Cell{1, 0, 1});
  CHECK(all_findings(stairs, judgement)
            .find("(1, 0, 0) and (1, 0, 1) are off against each other by 3.0 mm") !=
        std::string::npos);
}

TEST_CASE("small errors that add up along a column are drift, not error") {
  Staircase stairs;
  for (int level = 1; level < 3; ++level) {
    stairs.at({0, 0, level}).X_WB.p += Vec3{0.0014, 0, 0} * static_cast<double>(level);
  }
  const Judgement judgement = judged(stairs);
  CHECK(judgement.worst_drift == doctest::Approx(0.0028));
  CHECK(judgement.worst_joint_way == doctest::Approx(0.0014).epsilon(0.01));
  CHECK(judgement.worst_way < 0.002);
  CHECK(judgement.verdict == BuildVerdict::complete);
}

TEST_CASE("a wrong colour, a brick too much, a block between cells") {
  Staircase colour, extra, between;
  colour.at({0, 0, 2}).led = Led::q1;
  CHECK(judged(colour).verdict == BuildVerdict::wrong);
  CHECK(all_findings(colour, judged(colour)).find("at (0, 0, 2) shows Q1, not Q3") !=
        std::string::npos);
  extra.blocks.push_back(extra.block(7, {0, 1, 0}, Led::q2));
  CHECK(judged(extra).verdict == BuildVerdict::wrong);
  CHECK(all_findings(extra, judged(extra)).find("too much: a Q2 brick at (0, 1, 0)") !=
        std::string::npos);
  between.blocks.push_back(between.block(7, {0, 1, 0}, Led::off));
  between.blocks.back().X_WB.p += rotate(between.target.sites[0].X_WL.q, {0.025, 0.006, 0});
  CHECK(judged(between).verdict == BuildVerdict::wrong);
  CHECK(all_findings(between, judged(between)).find("in the way: a dark block") !=
        std::string::npos);
}

TEST_CASE("a placement that no rule allows is named, the first of them") {
  Staircase stairs;
  std::vector<BrickEvent> events = stairs.events();
  // The low column before the middle one carries its second brick.
  const auto low = std::find_if(events.begin(), events.end(), [](const BrickEvent& e) {
    return e.cell == Cell{2, 0, 0};
  });
  const auto middle = std::find_if(events.begin(), events.end(), [](const BrickEvent& e) {
    return e.cell == Cell{1, 0, 1};
  });
  REQUIRE(low != events.end());
  REQUIRE(middle != events.end());
  REQUIRE(middle < low);
  std::iter_swap(low, middle);
  const Judgement judgement = judge(stairs.target, 0, stairs.blocks, events);
  CHECK(judgement.verdict == BuildVerdict::wrong);
  REQUIRE(judgement.against);
  CHECK(events[judgement.against->event].cell == Cell{2, 0, 0});
  CHECK(judgement.allowed < judgement.placements);
  CHECK(judgement.against->reason.find("a Q1 brick at (2, 0, 0)") != std::string::npos);
  CHECK(judgement.against->reason.find("'start the low column'") != std::string::npos);
  CHECK(judgement.against->reason.find("(1, 0, 1)") != std::string::npos);
}

TEST_CASE("what left is gone for the rules: the same brick may come again") {
  Staircase stairs;
  std::vector<BrickEvent> events = stairs.events();
  BrickEvent gone = events.back();
  gone.kind = BrickEvent::Kind::left;
  gone.time += 1;
  BrickEvent again = events.back();
  again.time += 2;
  again.block = 99;
  SUBCASE("after it left") {
    events.push_back(gone);
    events.push_back(again);
    stairs.at(again.cell).block = again.block;
    CHECK(judge(stairs.target, 0, stairs.blocks, events).verdict == BuildVerdict::complete);
  }
  SUBCASE("a dark one is against the rules") {
    events.push_back(gone);
    again.led = Led::off;
    events.push_back(again);
    const Judgement judgement = judge(stairs.target, 0, stairs.blocks, events);
    REQUIRE(judgement.against);
    CHECK(judgement.against->reason.find("shows 'off'") != std::string::npos);
  }
}

}  // namespace
}  // namespace stig
