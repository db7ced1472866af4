// SPDX-License-Identifier: MIT
// Runs as bytes: all of it comes back, and bytes that are none are refused.
#include "validate/trial_bytes.h"

#include <doctest/doctest.h>

#include "support/uses.h"

namespace stig {
namespace {

/// A run in which every list has an entry, and every number is its own.
Trial full_trial() {
  Trial t;
  t.seed = 7;
  t.hash = 0xfedcba9876543210;
  t.end = TrialEnd::script;
  t.message = "enough\nof it";
  t.time = 12.25;
  t.judgements.resize(2);
  t.judgements[0].verdict = BuildVerdict::wrong;
  t.judgements[0].bricks = {
      {{1, -2, 3}, 4, true, 5, Led::q2, {1, 2, 3}, 0.5, 0.25, {4, 5, 6}, true, false, true}};
  t.judgements[0].bricks.emplace_back();
  t.judgements[0].extra = {{9, {7, 8, 9}, Led::q4, {0.1, 0.2, 0.3}, -1, true}};
  t.judgements[0].placements = 3;
  t.judgements[0].allowed = 2;
  t.judgements[0].against = AgainstRules{2, "not so"};
  t.judgements[0].worst_joint_turn = 0.125;
  t.judgements[0].loose = {{{1, 1, 1}, {2, 2, 2}, 3, 4}};
  t.events = {{BrickEvent::Kind::left, 3.5, 6, {1, 2, 3}, Led::q1, kNoRobot}};
  t.hauls = {{1, 2, 3, 4, 5, {6, 7, 8}, {9, 10, 11}, true, Cell{1, 2, 3}}};
  t.hauls.emplace_back();
  RobotRecord robot;
  robot.name = "one";
  robot.spent = {{"search", 1.5}, {"carry", 2.5}};
  robot.shown = {{"x", -1}};
  robot.idle = {{1, 2}};
  robot.idle_in = {{"search", 1}};
  robot.busy = {1, 2, 3};
  robot.energy.lift = 8;
  robot.holding = true;
  t.robots = {robot};
  t.loose = {{3, {}, Led::q3, true, true}};
  t.blocks.left = 2;
  t.broken = {"dark", "dead"};
  t.caches = {"empty"};
  t.lines = {{1, "one", "hello", true}};
  t.pictures = {{2, std::string("\0png", 4)}};
  t.measures = {{"m", 0.1}};
  return t;
}

TEST_CASE("a run comes back from its bytes") {
  const std::string bytes = trial_bytes(full_trial());
  const auto back = trial_of(bytes);
  REQUIRE(back);
  // Members are listed once for both ways: what is written again has all that was read.
  CHECK(trial_bytes(*back) == bytes);
  CHECK(back->hash == full_trial().hash);
  CHECK(back->end == TrialEnd::script);
  CHECK(back->message == "enough\nof it");
  CHECK(back->judgements[0].bricks[0].block == 5);
  CHECK_FALSE(back->judgements[0].bricks[1].block);
  CHECK(back->judgements[0].bricks[0].close);
  CHECK(back->judgements[0].against->reason == "not so");
  CHECK(back->events == full_trial().events);
  CHECK(back->hauls[0].placed == Cell{1, 2, 3});
  CHECK_FALSE(back->hauls[1].placed);
  CHECK(back->robots[0].spent == full_trial().robots[0].spent);
  CHECK(back->robots[0].idle == full_trial().robots[0].idle);
  CHECK(back->blocks == full_trial().blocks);
  CHECK(back->pictures[0].png.size() == 4);
  CHECK(back->measures == full_trial().measures);
}

TEST_CASE("bytes that were cut off, or go on, are no run") {
  const std::string bytes = trial_bytes(full_trial());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_FALSE(trial_of(std::string_view(bytes).substr(0, size)));
  }
  CHECK_FALSE(trial_of(bytes + "x"));
}

}  // namespace
}  // namespace stig
