// SPDX-License-Identifier: MIT
#include "lattice/expectation.h"

#include <doctest/doctest.h>

#include "support/shipped.h"
#include "support/small_sets.h"
#include "support/uses.h"

namespace stig {
namespace {

/// The standing of one key.
Standing standing(const RuleSet& rules, const std::string& key,
                  const ExpectationLimits& limits = {}) {
  for (const ExpectationItem& item : verify_expectation(rules, limits).items) {
    if (item.key == key) return item.standing;
  }
  FAIL("not judged: " << key);
  return Standing::undecided;
}

std::string expecting(const std::string& text) { return "expect:\n" + text; }

const std::string kChain = east_of("1", "2") + east_of("2", "3");
const std::string kRace = "conflicts: random\n";
const std::string kRaceRules = east_of("1", "2") + east_of("1", "3");

TEST_CASE("coordinated is held by exhaustion") {
  const RuleSet rules = small_set(kChain, expecting("  verdict: coordinated\n  bricks: 3\n"
                                                    "  structure: |\n    1 2 3\n"));
  const ExpectationReport report = verify_expectation(rules);
  REQUIRE(report.items.size() == 3);
  for (const ExpectationItem& item : report.items) CHECK(item.standing == Standing::held);
  CHECK(report.items[1].method == "all 3 reachable states");
  CHECK(report.passed());
}

TEST_CASE("without the states to be exhaustive, agreement is no proof and says so") {
  ExpectationLimits limits;
  limits.search.states = 2;
  const RuleSet rules = small_set(kChain, expecting("  verdict: coordinated\n"));
  const ExpectationReport report = verify_expectation(rules, limits);
  CHECK(report.items.at(0).standing == Standing::not_contradicted);
  CHECK(report.items[0].method == "64 sampled orders; trying all was given up after 2 states");
  CHECK(report.passed());
}

TEST_CASE("a race is not coordinated, and is order-dependent") {
  CHECK(standing(small_set(kRaceRules, kRace + expecting("  verdict: coordinated\n")), "verdict") ==
        Standing::failed);
  CHECK(standing(small_set(kRaceRules, kRace + expecting("  verdict: order-dependent\n")),
                 "verdict") == Standing::held);
}

TEST_CASE("order-dependent fails where one end is proved, and stays open where it is not") {
  const RuleSet rules = small_set(kChain, expecting("  verdict: order-dependent\n"));
  CHECK(standing(rules, "verdict") == Standing::failed);
  ExpectationLimits limits;
  limits.search.states = 2;
  CHECK(standing(rules, "verdict", limits) == Standing::undecided);
  CHECK_FALSE(verify_expectation(rules, limits).passed());
}

TEST_CASE("what ends is not endless; growth past the limit does not contradict it") {
  const std::string endless = expecting("  verdict: endless\n");
  CHECK(standing(small_set(kChain, endless), "verdict") == Standing::failed);
  const ExpectationReport report = verify_expectation(small_set(east_of("1", "1"), endless));
  CHECK(report.items.at(0).standing == Standing::not_contradicted);
  CHECK(report.items[0].found ==
        "no end found; 8 of 8 sampled orders still growing after 20000 deposits");
  CHECK(report.passed());
}

TEST_CASE("growth past the limit proves nothing of an end: it may come later") {
  ExpectationLimits limits;
  limits.deposits = 20;
  const RuleSet rules =
      small_set(east_of("1", "1"),
                expecting("  verdict: coordinated\n  bricks: 3\n  structure: |\n    1 1 1\n"));
  const ExpectationReport report = verify_expectation(rules, limits);
  REQUIRE(report.items.size() == 3);
  for (const ExpectationItem& item : report.items) CHECK(item.standing == Standing::undecided);
  CHECK(standing(small_set(east_of("1", "1"), expecting("  verdict: order-dependent\n")), "verdict",
                 limits) == Standing::undecided);
}

TEST_CASE("in a box growth is followed to its end, however far that is") {
  ExpectationLimits limits;
  limits.deposits = 20;
  const std::string box = "box: {size: [90, 1, 1], origin: [0, 0, 0]}\n";
  const auto in_box = [&](const std::string& expect) {
    return standing(small_set(east_of("1", "1"), box + expecting(expect)),
                    expect.substr(2, expect.find(':') - 2), limits);
  };
  CHECK(in_box("  verdict: endless\n") == Standing::failed);
  CHECK(in_box("  verdict: coordinated\n") == Standing::held);
  CHECK(in_box("  bricks: 90\n") == Standing::held);
}

TEST_CASE("a limit on steps leaves open what needs more of them") {
  ExpectationLimits limits;
  limits.steps = 20;
  limits.search.states = 5;
  const RuleSet rules = small_set(
      east_of("1", "1"), "box: {size: [90, 1, 1]}\n" + expecting("  verdict: coordinated\n"));
  const ExpectationReport report = verify_expectation(rules, limits);
  CHECK(report.items.at(0).standing == Standing::undecided);
  CHECK(report.items[0].found == "no end found; 8 of 8 sampled orders stopped after 20 steps");
}

TEST_CASE("the limit of the last stage is an end") {
  ExpectationLimits limits;
  limits.deposits = 20;
  const RuleSet rules =
      small_set(east_of("1", "1", "    stage: 1\n"),
                "stages: {1: 4}\n" + expecting("  verdict: coordinated\n  bricks: 5\n"));
  CHECK(standing(rules, "verdict", limits) == Standing::held);
  CHECK(standing(rules, "bricks", limits) == Standing::held);
}

TEST_CASE("growth that a box stops is not endless") {
  const RuleSet rules = small_set(
      east_of("1", "1"), "box: {size: [9, 1, 1]}\n" + expecting("  verdict: coordinated\n"));
  CHECK(standing(rules, "verdict") == Standing::held);
}

TEST_CASE("another number of bricks, and another structure, fail with words") {
  const RuleSet rules = small_set(kChain, expecting("  bricks: 4\n  structure: |\n    1 2 3 3\n"));
  const ExpectationReport report = verify_expectation(rules);
  REQUIRE(report.items.size() == 2);
  CHECK(report.items[0].standing == Standing::failed);
  CHECK(report.items[0].found == "one end, 3 bricks");
  CHECK(report.items[1].standing == Standing::failed);
  CHECK(report.items[1].found ==
        "3 bricks; at (3, 0, 0) from the lowest corner empty, not brick 3");
}

TEST_CASE("low probability is waited for, up to the limit on steps") {
  const RuleSet rules = small_set(east_of("1", "2", "    probability: 0.01\n"),
                                  expecting("  verdict: coordinated\n"));
  CHECK(standing(rules, "verdict") == Standing::held);
}

TEST_CASE("a stop ends it without a judgement") {
  const std::atomic<bool> stop{true};
  const RuleSet rules = small_set(east_of("1", "1"), expecting("  verdict: endless\n"));
  const ExpectationReport report = verify_expectation(rules, {}, {{}, &stop});
  CHECK(report.interrupted);
  CHECK(report.items.empty());
  CHECK_FALSE(report.passed());
}

TEST_CASE("a set without expectations has nothing to be held to") {
  CHECK(verify_expectation(small_set(kChain)).items.empty());
}

TEST_CASE("every shipped set is as it expects") {
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    ExpectationLimits limits;
    limits.search.states = 200000;  // what is larger is left to the sampled orders
    CHECK(verify_expectation(shipped(name), limits).passed());
  }
}

}  // namespace
}  // namespace stig
