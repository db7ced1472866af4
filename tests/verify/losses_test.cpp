// SPDX-License-Identifier: MIT
// What is said of lost bricks, against trying every order of events before a loss and after it.
#include "verify/losses.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "certify/loss_check.h"
#include "support/oracle.h"
#include "support/shipped.h"
#include "support/small_sets.h"
#include "support/small_worlds.h"
#include "support/uses.h"
#include "verify/verify.h"

using namespace stig;

namespace {

LossResult losses_of(const RuleSet& rules, LossOptions options = {}) {
  VerifyOptions settings;
  settings.box = file_box(rules);
  const VerifyResult result = verify::verify(rules, settings);
  REQUIRE(result.verdict == ProofVerdict::proved);
  options.box = settings.box;
  return find_losses(rules, *result.structure, options);
}

std::set<BrickMap> reached_by_oracle(const RuleSet& rules, const std::optional<Box>& box) {
  std::set<BrickMap> all{start_of(rules)};
  std::vector<BrickMap> open(all.begin(), all.end());
  while (!open.empty()) {
    const BrickMap one = open.back();
    open.pop_back();
    OracleWorld world(rules, box);
    for (const auto& [cell, colour] : one) world.place({cell, colour});
    for (const PlacedBrick& event : world.events(1)) {
      BrickMap next = one;
      next[event.at] = event.brick;
      if (all.insert(next).second) open.push_back(next);
    }
  }
  return all;
}

bool hangs_together(const RuleSet& rules, const BrickMap& bricks, const std::optional<Box>& box) {
  const Neighbourhood& n = neighbourhood(rules.lattice);
  std::set<Cell> joined;
  std::vector<Cell> open;
  for (const PlacedBrick& brick : rules.start) open.push_back(brick.at);
  while (!open.empty()) {
    const Cell at = open.back();
    open.pop_back();
    if (!joined.insert(at).second) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      const Cell beside = box ? box->wrap(at + n.offsets[i]) : at + n.offsets[i];
      if (n.is_face[i] && bricks.contains(beside)) open.push_back(beside);
    }
  }
  return joined.size() == bricks.size();
}

/// By brick: losses, and how many of them every order mends.
using Fates = std::map<PlacedBrick, std::pair<std::uint64_t, std::uint64_t>>;

Fates fates_by_oracle(const RuleSet& rules, const std::optional<Box>& box, const BrickMap& end) {
  Fates fates;
  const BrickMap start = start_of(rules);
  for (const BrickMap& bricks : reached_by_oracle(rules, box)) {
    for (const auto& [cell, colour] : bricks) {
      const Cell above = cell + Offset{0, 0, 1};
      if (start.contains(cell) || bricks.contains(box ? box->wrap(above) : above)) continue;
      BrickMap left = bricks;
      left.erase(cell);
      if (!hangs_together(rules, left, box)) continue;
      const Exploration after = explore_orders(rules, left, 1, box);
      REQUIRE(after.complete);
      auto& [losses, restored] = fates[{cell, colour}];
      ++losses;
      restored += after.ends == std::vector<BrickMap>{end} ? 1 : 0;
    }
  }
  return fates;
}

BrickMap map_of(const std::vector<PlacedBrick>& bricks) {
  BrickMap map;
  for (const PlacedBrick& brick : bricks) map[brick.at] = brick.brick;
  return map;
}

Fates fates_of(const LossResult& result) {
  Fates fates;
  for (const LostBrick& one : result.bricks) fates[one.brick] = {one.losses, one.restored};
  return fates;
}

std::optional<BoxSpec> spec_of(const std::optional<Box>& box) {
  if (!box) return std::nullopt;
  return BoxSpec{box->size, box->low, box->periodic};
}

}  // namespace

TEST_CASE("every loss is mended at the staircase and at the pyramid of robots") {
  const LossResult staircase = losses_of(shipped("staircase"));
  CHECK(staircase.verdict == LossVerdict::restored);
  CHECK(staircase.reached.size() == 9);
  CHECK(staircase.losses() == 16);
  CHECK(staircase.restored() == 16);
  CHECK(!staircase.lasting);
  const LossResult pyramid = losses_of(shipped("stepped-pyramid"));
  CHECK(pyramid.verdict == LossVerdict::restored);
  CHECK(pyramid.losses() == 2560);
  for (const LostBrick& one : pyramid.bricks) CHECK(one.restored == one.losses);
}

TEST_CASE("rules that ask for exact views do not mend what they would not place now") {
  const LossResult result = losses_of(shipped("staircase-exact"));
  CHECK(result.verdict == LossVerdict::lasting);
  REQUIRE(result.lasting);
  const BrickMap before = map_of(result.lasting->before);
  CHECK(before.at(result.lasting->lost.at) == result.lasting->lost.brick);
  // An order from there on does end so, and the end lacks something.
  BrickMap left = before;
  left.erase(result.lasting->lost.at);
  const RuleSet rules = shipped("staircase-exact");
  const Exploration after = explore_orders(rules, left);
  REQUIRE(after.complete);
  const BrickMap end = map_of(result.lasting->end);
  CHECK(std::find(after.ends.begin(), after.ends.end(), end) != after.ends.end());
  // No smaller structure has such a loss.
  for (const std::vector<PlacedBrick>& smaller : result.reached) {
    if (smaller.size() >= result.lasting->before.size()) continue;
    CHECK(std::find(result.after.begin(), result.after.end(), smaller) == result.after.end());
  }
}

TEST_CASE("what is said of losses in small random worlds is what trying everything says") {
  int worlds = 0, tried = 0, lasting = 0, restored = 0;
  for (std::uint64_t seed = 0; worlds < 300 && seed < 20'000; ++seed) {
    const RuleSet rules = small_world(seed);
    if (rules.stage_count() > 1 || !rules.stages.empty()) continue;
    VerifyOptions settings;
    settings.box = file_box(rules);
    SwarmConfig config;
    config.motion = Motion::event;
    config.box = settings.box;
    const RuleTable table(rules);
    if (!config_problem(table, rules.start, config).empty()) continue;
    const VerifyResult proof = verify::verify(rules, settings);
    if (proof.verdict != ProofVerdict::proved || proof.run.size() < 3) continue;
    LossOptions options;
    options.box = settings.box;
    options.states = 300;
    const LossResult result = find_losses(rules, *proof.structure, options);
    if (result.verdict == LossVerdict::unknown) continue;
    CAPTURE(seed);
    ++worlds;
    (result.verdict == LossVerdict::restored ? restored : lasting) += 1;
    const BrickMap end = map_of(proof.structure->bricks());
    // The oracle's worlds have rims, and all rules that match.
    if (rules.conflicts != Conflicts::first && !(settings.box && settings.box->periodic)) {
      ++tried;
      CHECK(fates_of(result) == fates_by_oracle(rules, settings.box, end));
    }
    CHECK(result.verdict ==
          (result.losses() == result.restored() ? LossVerdict::restored : LossVerdict::lasting));
    // The checker holds what is claimed, and refuses what is not.
    const std::string refusal = loss_refusal(
        rules, spec_of(settings.box), {proof.structure->bricks(), result.reached, result.after});
    CHECK((refusal.empty()) == (result.verdict == LossVerdict::restored));
  }
  MESSAGE("restored " << restored << ", lasting " << lasting << ", tried " << tried);
  CHECK(worlds == 300);
  CHECK(tried > 100);
  CHECK(restored > 5);
  CHECK(lasting > 5);
}

TEST_CASE("the checker refuses a list that leaves something out, or another end") {
  const RuleSet rules = shipped("staircase");
  const LossResult result = losses_of(rules);
  const std::vector<PlacedBrick> end =
      *std::max_element(result.reached.begin(), result.reached.end(),
                        [](const auto& a, const auto& b) { return a.size() < b.size(); });
  CHECK(loss_refusal(rules, std::nullopt, {end, result.reached, result.after}).empty());
  for (std::size_t i = 0; i < result.reached.size(); ++i) {
    auto fewer = result.reached;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK(!loss_refusal(rules, std::nullopt, {end, fewer, result.after}).empty());
  }
  REQUIRE(!result.after.empty());
  for (std::size_t i = 0; i < result.after.size(); ++i) {
    auto fewer = result.after;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK(!loss_refusal(rules, std::nullopt, {end, result.reached, fewer}).empty());
  }
  std::vector<PlacedBrick> other = end;
  other.pop_back();
  CHECK(!loss_refusal(rules, std::nullopt, {other, result.reached, result.after}).empty());
}

TEST_CASE("in a periodic box of one level a brick can be lost") {
  const auto row = [](const std::string& size, const std::string& periodic) {
    return small_set(east_of("1", "2") + east_of("2", "3"),
                     "box: {size: " + size + ", origin: [0, 0, 0], periodic: " + periodic + "}\n");
  };
  for (const RuleSet& rules :
       {row("[5, 1, 1]", "true"), row("[5, 1, 2]", "true"), row("[5, 1, 1]", "false")}) {
    CHECK(losses_of(rules).losses() == 2);
  }
}

TEST_CASE("the check obeys the budget as the search does") {
  const RuleSet rules = shipped("stepped-pyramid");
  LossOptions options;
  std::uint64_t least = 1;
  // What the search alone takes is not enough for the check.
  for (options.work = 1'000'000; least == 1 && options.work < 60'000'000'000;
       options.work += options.work / 8) {
    const LossResult result = losses_of(rules, options);
    if (result.verdict == LossVerdict::restored) least = options.work;
    if (!result.reached.empty() && result.verdict == LossVerdict::unknown) {
      CHECK(result.open.find("was spent") != std::string::npos);
      return;
    }
  }
  FAIL("no budget ends in the check");
}

TEST_CASE("where there is more than the budget allows nothing is said") {
  LossOptions options;
  options.states = 5;
  const LossResult few = losses_of(shipped("staircase"), options);
  CHECK(few.verdict == LossVerdict::unknown);
  CHECK(few.open == "there are more than 5 structures");
  options = {};
  options.work = 1;
  CHECK(losses_of(shipped("staircase"), options).verdict == LossVerdict::unknown);
  const std::atomic<bool> stop = true;
  options = {};
  options.stop = &stop;
  const LossResult stopped = losses_of(shipped("staircase"), options);
  CHECK(stopped.verdict == LossVerdict::unknown);
  CHECK(stopped.interrupted);
}
