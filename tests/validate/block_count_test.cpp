// SPDX-License-Identifier: MIT
#include "validate/block_count.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include "support.h"
#include "validate/findings.h"

namespace stig {
namespace {

/// The start, a brick on it, and one block of every other kind; a cache 2 m off.
struct Yard : Staircase {
  Watch watch{target};
  std::vector<WatchedBlock> there{blocks[0], blocks[1]};
  std::vector<CacheSpawn> caches{1};

  Yard() {
    caches[0].at = {2, 0, 0.125};
    there.push_back(lying(10, {2.1, 0.1, 0.0275}));
    there.push_back(lying(11, {1, 1, 0.0275}));
    there.push_back(lying(12, {1, -1, 0.0275}));
    there.back().fixed = true;
    there.push_back(lying(13, {-1, 0, 0.0275}));
  }

  static WatchedBlock lying(std::size_t number, Vec3 at) {
    WatchedBlock out;
    out.block = number;
    out.X_WB.p = at;
    return out;
  }
  void look() {
    const WatchedHand hand{there.back().X_WB.p + Vec3{0, 0, 0.0275 + 0.001}};
    for (int i = 0; i < 10; ++i) watch.look(0.2 * i, there, {hand});
  }
  BlockCount count() const {
    BlockCount out = count_blocks(there, watch, caches);
    out.began = 2;
    out.dropped = 5;
    out.left = 1;
    return out;
  }
};

TEST_CASE("every block is counted once, wherever it is") {
  Yard yard;
  yard.look();
  const BlockCount count = yard.count();
  CHECK(count == BlockCount{2, 5, 2, 1, 1, 1, 1, 1});
  CHECK(count.adds_up());
  CHECK(count_text(count) ==
        "2 and 5 dropped; 2 in the structure, 1 carried, 1 at caches, 1 loose elsewhere, 1 fixed "
        "elsewhere, 1 out of the arena");
}

TEST_CASE("a block that is nowhere is missed") {
  Yard yard;
  yard.look();
  yard.there.erase(yard.there.begin() + 3);
  const BlockCount count = yard.count();
  CHECK_FALSE(count.adds_up());
  CHECK(count_text(count).ends_with("which does not add up"));
}

TEST_CASE("what keeps a cache from dropping blocks") {
  Yard yard;
  const auto troubles = [&] {
    yard.look();
    return cache_troubles(yard.set.rules, yard.there, yard.watch, yard.caches);
  };
  CHECK(troubles().empty());
  yard.there[2].led = Led::q1;
  REQUIRE(troubles().size() == 1);
  CHECK(
      troubles()[0] ==
      "the cache at (2.00, 0.00) m drops no block while one that shows Q1 lies at (2.10, 0.10) m");
  // In a robot's hand it is on its way out.
  std::swap(yard.there[2].X_WB, yard.there.back().X_WB);
  yard.there[2].X_WB.p.x = 1.2;
  CHECK(troubles().empty());
  yard.there.back().X_WB.p.x = 1.5;
  REQUIRE(troubles().size() == 1);
  CHECK(troubles()[0].find("is empty") != std::string::npos);
}

TEST_CASE("a robot that was stopped is told with where it stands and what is missing there") {
  const Yard yard;
  Trial trial;
  RobotRecord robot;
  robot.name = "robot 1";
  robot.state = "reach";
  robot.failed = robot.halted = robot.holding = true;
  robot.X_WR.p = centre_of(yard.target.sites[0], {1, 0, 0}) + Vec3{0.06, 0.08, 0};
  trial.robots = {robot};
  trial.judgements = {judge(yard.target, 0, {yard.blocks[0]}, {})};
  const std::vector<std::string> findings = findings_of(yard.target, trial);
  const auto text = [&](const char* part) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const std::string& one) { return one.find(part) != std::string::npos; });
  };
  CHECK(text("robot 1 was stopped for good in state 'reach', with a block, at ("));
  CHECK(text("m from the missing brick at ("));
}

TEST_CASE("what a script broke is told after why the run ended, and not of complete runs") {
  const Yard yard;
  Trial trial;
  trial.broken = {"the cameras of robot 1 see nothing"};
  trial.judgements = {judge(yard.target, 0, {yard.blocks[0]}, {})};
  const std::vector<std::string> findings = findings_of(yard.target, trial);
  REQUIRE(findings.size() > 2);
  CHECK(findings[1] == trial.broken[0]);
  trial.judgements[0].verdict = BuildVerdict::complete;
  const std::vector<std::string> whole = findings_of(yard.target, trial);
  CHECK(std::find(whole.begin(), whole.end(), trial.broken[0]) == whole.end());
}

}  // namespace
}  // namespace stig
