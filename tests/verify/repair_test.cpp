// SPDX-License-Identifier: MIT
// What is said of a repair against the plain exploration of every order.
#include <doctest/doctest.h>

#include "rules/rule_checks.h"
#include "support/small_worlds.h"
#include "support/uses.h"
#include "verify/findings.h"

using namespace stig;

namespace {

constexpr std::size_t kMostStructures = 20'000;

bool runs_in_its_box(const RuleSet& rules) {
  SwarmConfig config;
  config.motion = Motion::event;
  config.box = file_box(rules);
  return config_problem(RuleTable(rules), rules.start, config).empty();
}

bool is_refused(const RuleSet& rules) {
  Diagnostics problems;
  check_rule_set(rules, CheckScope::certain, problems);
  return problems.has_errors();
}

struct RepairTally {
  int whole = 0;     ///< repairs that are proved for all stages
  int followed = 0;  ///< of those: orders parted before the last stage
  int partial = 0;
};

/// Whether the repair, of which orders parted in `stage`, ends as it says.
void check_claim(const Repair& repair, int stage, RepairTally& tally) {
  const int last = repair.whole ? repair.repaired.stage_count() : stage;
  const auto ends = all_ends(repair.repaired, kMostStructures, last);
  if (!ends) return;
  REQUIRE(ends->size() == 1);
  CHECK(ends->begin()->size() == repair.bricks);
  CHECK_FALSE(is_refused(repair.repaired));
  ++(repair.whole ? tally.whole : tally.partial);
  if (repair.whole && stage < last) ++tally.followed;
}

void try_world(std::uint64_t seed, RepairTally& tally) {
  const RuleSet rules = staged_small_world(seed);
  if (!runs_in_its_box(rules)) return;
  CAPTURE(seed);
  VerifyOptions options;
  options.box = file_box(rules);
  const VerifyResult result = verify::verify(rules, options);
  if (result.verdict != ProofVerdict::refuted) return;
  const Findings findings = find_more(rules, options, result, {});
  if (findings.repair) check_claim(*findings.repair, result.stage, tally);
}

}  // namespace

TEST_CASE("a repair of a staged set ends in as many bricks as it says") {
  RepairTally tally;
  for (std::uint64_t seed = 0; seed < 800; ++seed) try_world(seed, tally);
  MESSAGE(tally.whole << " of all stages (" << tally.followed << " of an earlier one), "
                      << tally.partial << " of some");
  CHECK(tally.followed >= 5);
}
