// SPDX-License-Identifier: MIT
// Shipped rule sets, changed at random: whatever the verdict, it stands up to those who
// know better.
#include <doctest/doctest.h>

#include <cstdlib>
#include <random>

#include "certify/check.h"
#include "lattice/event_orders.h"
#include "support/shipped.h"
#include "support/uses.h"
#include "verify/findings.h"

using namespace stig;

namespace {

using Words = std::mt19937_64;

std::size_t below(Words& words, std::size_t bound) { return words() % bound; }

void change(RuleSet& rules, Words& words) {
  Rule& rule = rules.rules[below(words, rules.rules.size())];
  const auto size = static_cast<std::size_t>(neighbourhood(rules.lattice).size);
  StateSet& cell = rule.pattern.allowed[below(words, size)];
  const auto colour = static_cast<Colour>(1 + below(words, rules.bricks.size()));
  switch (below(words, 8)) {
    case 0:
      cell = StateSet::anything();
      break;
    case 1:
      cell = StateSet::of(colour);
      break;
    case 2:
      cell = StateSet::empty_cell();
      break;
    case 3:
      rule.place = colour;
      break;
    case 4:
      if (rules.rules.size() > 1) rules.rules.erase(rules.rules.begin());
      break;
    case 5:
      rules.symmetry = static_cast<Symmetry>(below(words, 3));
      break;
    case 6:
      rule.height_max = static_cast<int>(below(words, 4));
      break;
    default:
      cell = StateSet::bricks(rules.colours());
  }
}

void hold(const RuleSet& rules, const VerifyOptions& options) {
  const VerifyResult result = verify::verify(rules, options);
  EventOrdersLimits limits;
  limits.states = 20'000;
  const RuleTable table(rules);
  const bool one_stage = rules.stage_count() == 1 && rules.conflicts != Conflicts::first;
  if (result.verdict == ProofVerdict::proved) {
    const CheckReport report = check_certificate(rules, *result.certificate);
    CHECK_MESSAGE(report.accepted, report.refusal);
    if (!one_stage) return;
    const EventOrders all = explore_event_orders(table, rules.start, options.box, limits);
    CHECK(all.ends.size() <= 1);
    if (all.complete) CHECK(all.ends.front() == *result.structure);
  }
  if (result.verdict == ProofVerdict::refuted) {
    CHECK_FALSE(result.refutation->first_end == result.refutation->second_end);
    if (!one_stage) return;
    const EventOrders all = explore_event_orders(table, rules.start, options.box, limits);
    if (all.complete) CHECK(all.ends.size() > 1);
  }
}

}  // namespace

TEST_CASE("changed rule sets are judged soundly, and nothing falls over") {
  const char* most = std::getenv("STIG_WORLDS");
  const std::size_t rounds = most ? static_cast<std::size_t>(std::atoi(most)) / 10 : 25;
  Words words(7);
  for (const std::string& name : shipped_names()) {
    const RuleSet original = shipped(name);
    for (std::size_t round = 0; round < rounds; ++round) {
      RuleSet rules = original;
      rules.conflicts = Conflicts::random;  // changed rules may well be at odds
      for (std::size_t k = 1 + below(words, 3); k > 0; --k) change(rules, words);
      CAPTURE(name);
      CAPTURE(round);
      VerifyOptions options;
      options.box = file_box(rules);
      options.work = 1'000'000'000;
      options.states = 50'000;
      hold(rules, options);
    }
  }
}
