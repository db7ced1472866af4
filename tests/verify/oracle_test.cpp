// SPDX-License-Identifier: MIT
// Verdicts on small random worlds against the plain exploration of every order.
#include <doctest/doctest.h>

#include <cstdlib>
#include <set>

#include "certify/check.h"
#include "lattice/trace.h"
#include "rules/rule_printer.h"
#include "support/oracle.h"
#include "support/small_worlds.h"
#include "support/uses.h"
#include "verify/verify.h"

using namespace stig;

namespace {

BrickMap map_of(const Structure& structure) {
  BrickMap map;
  for (const PlacedBrick& brick : structure.bricks()) map[brick.at] = brick.brick;
  return map;
}

/// The order as a trace of its own, read back and replayed.
bool replays(const RuleSet& rules, const std::vector<Deposit>& order) {
  SwarmConfig config;
  config.motion = Motion::event;
  config.box = file_box(rules);
  TraceWriter writer(rules, config, "given");
  for (const Deposit& deposit : order) writer.deposit(deposit);
  const std::string bytes = writer.finish(order.size(), Terminated::saturated);
  Diagnostics diagnostics;
  const auto trace = read_trace("trace", bytes, diagnostics);
  if (!trace) return false;
  const ReplayReport report = replay(*trace, rules);
  INFO(report.difference);
  CHECK(report.identical);
  return report.identical;
}

/// The certificate, printed and read back, holds before the checker.
void check_by_checker(const RuleSet& rules, const VerifyResult& result) {
  REQUIRE(result.certificate);
  const std::string text = print_certificate(*result.certificate);
  Diagnostics diagnostics;
  const auto again = read_certificate("certificate", text, diagnostics);
  REQUIRE(again);
  CHECK(*again == *result.certificate);
  const CheckReport report = check_certificate(rules, *again);
  CHECK_MESSAGE(report.accepted, report.refusal);
  CHECK(report.structure == result.structure->bricks());
}

struct Tally {
  int worlds = 0, proved = 0, refuted = 0, unknown = 0, skipped = 0;
  int by_method[3] = {0, 0, 0};
};

void check_world(std::uint64_t seed, Tally& tally) {
  const RuleSet rules = small_world(seed);
  VerifyOptions options;
  options.box = file_box(rules);
  const RuleTable table(rules);
  SwarmConfig config;
  config.motion = Motion::event;
  config.box = options.box;
  if (!config_problem(table, rules.start, config).empty()) return;
  CAPTURE(seed);
  const VerifyResult result = verify::verify(rules, options);
  // Most worlds come to a halt at once and test little.
  const std::size_t deposits =
      result.refutation ? result.refutation->first.size() + result.refutation->second.size()
                        : result.run.size();
  if (result.verdict != ProofVerdict::unknown && deposits < 4) return;
  ++tally.worlds;
  const auto ends = all_ends(rules, 20'000);
  if (result.refutation) {
    const DivergingOrders& found = *result.refutation;
    CHECK(replays(rules, found.first));
    CHECK(replays(rules, found.second));
    CHECK_FALSE(found.first_end == found.second_end);
    CHECK(found.second_ended);
    if (ends) CHECK(ends->contains(map_of(found.first_end)));
    if (ends) CHECK(ends->contains(map_of(found.second_end)));
  }
  switch (result.verdict) {
    case ProofVerdict::proved:
      ++tally.proved;
      ++tally.by_method[static_cast<int>(result.method)];
      check_by_checker(rules, result);
      if (ends) CHECK(ends->size() == 1);
      if (ends) CHECK(*ends->begin() == map_of(*result.structure));
      break;
    case ProofVerdict::refuted:
      ++tally.refuted;
      CHECK(result.refutation);
      break;
    case ProofVerdict::endless:
      CHECK(false);  // in a box
      break;
    case ProofVerdict::unknown:
      ++tally.unknown;
      MESSAGE("unknown: " << result.open << " " << (ends ? ends->size() : 0) << " ends\n"
                          << (std::getenv("STIG_SHOW") ? print_rule_set(rules) : ""));
      break;
  }
  if (!ends) ++tally.skipped;
}

}  // namespace

TEST_CASE("no verdict on a small random world is at odds with trying every order") {
  const char* most = std::getenv("STIG_WORLDS");
  const int worlds = most ? std::atoi(most) : 400;
  Tally tally;
  for (std::uint64_t seed = 0; tally.worlds < worlds; ++seed) check_world(seed, tally);
  MESSAGE("proved " << tally.proved << " (" << tally.by_method[0] << " by order, "
                    << tally.by_method[1] << " by components, " << tally.by_method[2]
                    << " by exhaustion), refuted " << tally.refuted << ", unknown " << tally.unknown
                    << ", too large for the oracle " << tally.skipped);
  CHECK(tally.unknown * 50 < worlds);
  CHECK(tally.proved > worlds / 10);
  CHECK(tally.refuted > worlds / 10);
}
