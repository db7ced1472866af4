// SPDX-License-Identifier: MIT
// Verdicts on published and shipped rule sets. The numbers of T3 and T4 were computed
// elsewhere, by exhaustive programs.
#include <doctest/doctest.h>

#include "certify/check.h"
#include "rules/rule_printer.h"
#include "support/shipped.h"
#include "support/small_sets.h"
#include "support/uses.h"
#include "verify/findings.h"
#include "verify/verify.h"

using namespace stig;

namespace {

VerifyResult verdict(const RuleSet& rules, std::uint64_t work = kVerifyWork) {
  VerifyOptions options;
  options.box = file_box(rules);
  options.work = work;
  return verify::verify(rules, options);
}

/// The steps of architecture 4(n) from `first` to `last` as stages 1, 2, ….
RuleSet steps_of_4n(int last) {
  RuleSet rules = shipped("architecture-4n");
  std::erase_if(rules.rules, [&](const Rule& rule) { return rule.stage > last; });
  return rules;
}

}  // namespace

TEST_CASE("T3a: steps 1 to 5 of architecture 4(n) are proved, with their numbers of deposits") {
  const VerifyResult result = verdict(steps_of_4n(5));
  REQUIRE(result.verdict == ProofVerdict::proved);
  const std::vector<std::size_t> ends{1, 9, 18, 34, 58};
  CHECK(result.stage_ends == ends);
  // Step 5 has 160000 reachable structures, which nobody has to look at.
  CHECK(result.local_states < 1000);
}

TEST_CASE("T3b: step 6 is refuted, and one pattern more repairs it") {
  const RuleSet rules = steps_of_4n(6);
  const VerifyResult result = verdict(rules);
  REQUIRE(result.verdict == ProofVerdict::refuted);
  CHECK(result.stage == 6);
  REQUIRE(result.refutation);
  for (const Structure* end : {&result.refutation->first_end, &result.refutation->second_end}) {
    CHECK(end->size() >= 1 + 58 + 20);
    CHECK(end->size() <= 1 + 58 + 24);
  }
  VerifyOptions options;
  options.box = file_box(rules);
  const Findings findings = find_more(rules, options, result, {});
  REQUIRE(findings.repair);
  CHECK(findings.repair->added.size() == 1);
  CHECK(findings.repair->removed.empty());
  CHECK(findings.repair->bricks == 1 + 58 + 24);
  CHECK(verdict(findings.repair->repaired).verdict == ProofVerdict::proved);
}

TEST_CASE("T3c: step 2 with mirrors is refuted") {
  RuleSet rules = steps_of_4n(2);
  rules.symmetry = Symmetry::rotations_mirrors;
  const VerifyResult result = verdict(rules);
  CHECK(result.verdict == ProofVerdict::refuted);
  CHECK(result.stage == 2);
}

TEST_CASE("T3d: all rules of architecture 4(n) at once are refuted") {
  RuleSet rules = shipped("architecture-4n");
  for (Rule& rule : rules.rules) rule.stage = 0;
  CHECK(verdict(rules).verdict == ProofVerdict::refuted);
}

TEST_CASE("T4: architecture 4(c) is proved, 73 deposits") {
  const VerifyResult result = verdict(shipped("architecture-4c"));
  REQUIRE(result.verdict == ProofVerdict::proved);
  CHECK(result.run.size() == 73);
}

TEST_CASE("T10: the short rules, on one side and on four") {
  const VerifyResult one = verdict(shipped("staircase"));
  REQUIRE(one.verdict == ProofVerdict::proved);
  CHECK(one.structure->size() == 6);
  const VerifyResult four = verdict(shipped("stepped-pyramid"));
  REQUIRE(four.verdict == ProofVerdict::proved);
  CHECK(four.structure->size() == 15);
}

TEST_CASE("shipped sets are as they expect") {
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    const RuleSet rules = shipped(name);
    if (!rules.expect || !rules.expect->verdict) continue;
    const ProofVerdict found = verdict(rules).verdict;
    switch (*rules.expect->verdict) {
      case Verdict::coordinated:
        CHECK(found == ProofVerdict::proved);
        break;
      case Verdict::order_dependent:
        CHECK(found == ProofVerdict::refuted);
        break;
      case Verdict::endless:
        CHECK(found == ProofVerdict::endless);
        break;
    }
  }
}

TEST_CASE("growth without end is shown by its period") {
  const RuleSet rules = small_set(east_of("1", "2") + east_of("2", "1"));
  const VerifyResult result = verdict(rules);
  REQUIRE(result.verdict == ProofVerdict::endless);
  CHECK(result.endless->period == 2);
  CHECK(result.endless->step == Offset{2, 0, 0});
}

TEST_CASE("a rule that only goes so high does not grow for ever") {
  const std::string up = R"(
  - name: up
    place: 1
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   ? * ?   ? 1 ?
      ? ? ?   ? ? ?   ? ? ?
    height: {max: 30000}
)";
  const VerifyResult result = verdict(small_set(up));
  REQUIRE(result.verdict == ProofVerdict::proved);
  CHECK(result.structure->size() == 30001);
}

TEST_CASE("two rows ordered by the way around are proved with far chains") {
  // A row to the east, around a corner, and back two rows further north. Between the rows
  // waits a rule for a northern brick without a southern one.
  const RuleSet rules = small_set(
      R"(
  - {name: east, place: 1, when: "? ? ? ? ? ? ? ? ?\n? ? ? 1 * ? ? ? ?\n? ? ? ? ? ? ? ? ?"}
  - {name: turn, place: 2, when: "? ? ? ? ? ? ? ? ?\n? ? ? ? * 3 ? ? ?\n? ? ? ? 1 ? ? ? ?"}
  - {name: up, place: 2, when: "? ? ? ? ? ? ? ? ?\n? ? ? ? * ? ? ? ?\n? ? ? ? 2 3 ? ? ?"}
  - {name: back, place: 2, when: "? ? ? ? ? ? ? ? ?\n? ? ? . * 2 ? ? ?\n? ? ? ? . ? ? ? ?"}
  - {name: trap, place: 3, when: "? ? ? ? 2 ? ? ? ?\n? ? ? ? * ? ? ? ?\n? ? ? ? . ? ? ? ?"}
)",
      "conflicts: random\nstart: [{at: [0, 0, 0], brick: 1}, {at: [10, 1, 0], brick: 3}]\n"
      "box: {size: [11, 3, 1], origin: [0, 0, 0]}\n");
  const VerifyResult result = verdict(rules);
  REQUIRE(result.verdict == ProofVerdict::proved);
  CHECK_FALSE(result.certificate->stages[0].far.empty());
  CHECK(result.certificate->stages[0].windows.empty());
  CHECK_MESSAGE(check_certificate(rules, *result.certificate).accepted,
                check_certificate(rules, *result.certificate).refusal);
}

TEST_CASE("without a budget nothing is claimed") {
  CHECK(verdict(steps_of_4n(6), 0).verdict == ProofVerdict::unknown);
}

TEST_CASE("a rule that takes over higher up ends what looked endless") {
  const std::string up =
      "  - {name: cap, place: 2, height: {min: 9000}, "
      "when: \"? ? ? ? ? ? ? ? ?\\n? ? ? ? * ? ? 1 ?\\n? ? ? ? ? ? ? ? ?\"}\n"
      "  - {name: up, place: 1, "
      "when: \"? ? ? ? ? ? ? ? ?\\n? ? ? ? * ? ? 1 ?\\n? ? ? ? ? ? ? ? ?\"}\n";
  const VerifyResult result = verdict(small_set(up, "conflicts: first\n"));
  REQUIRE(result.verdict == ProofVerdict::proved);
  CHECK(result.structure->size() == 9001);
}

TEST_CASE("what is unlikely is tried too: an order that ends beside one that does not") {
  const std::string race =
      "  - {name: go, place: 1, weight: 1000000, "
      "when: \"? ? ? ? ? ? ? ? ?\\n? ? ? 1 * ? ? ? ?\\n? ? ? ? ? ? ? ? ?\"}\n"
      "  - {name: stop, place: 2, weight: 0.000001, "
      "when: \"? ? ? ? ? ? ? ? ?\\n? ? ? 1 * ? ? ? ?\\n? ? ? ? ? ? ? ? ?\"}\n";
  CHECK(verdict(small_set(race, "conflicts: random\n")).verdict == ProofVerdict::refuted);
}

TEST_CASE("growth by a count is proved, however many states there are") {
  const std::string rule =
      "  - {name: any, place: 1, count: [{of: [\"#\"], among: all, min: 1}], "
      "when: \"? ? ? ? ? ? ? ? ?\\n? ? ? ? * ? ? ? ?\\n? ? ? ? ? ? ? ? ?\"}\n";
  const VerifyResult result =
      verdict(small_set(rule, "box: {size: [4, 4, 3], origin: [0, 0, 0]}\n"));
  REQUIRE(result.verdict == ProofVerdict::proved);
  CHECK(result.structure->size() == 48);
  CHECK(result.method == ProofMethod::certificate);
}

TEST_CASE("stages that end differently and stay so are refuted over all stages") {
  // Stage 1 places one brick, on either side; stage 2 another on top of it.
  const std::string rules = R"(
  - {name: beside, stage: 1, place: 2, when: "? ? ? ? ? ? ? ? ?\n? ? ? 1 * ? ? ? ?\n? ? ? ? ? ? ? ? ?"}
  - {name: on top, stage: 2, place: 3, when: "? ? ? ? ? ? ? ? ?\n? ? ? ? * ? ? 2 ?\n? ? ? ? ? ? ? ? ?"}
)";
  const VerifyResult result = verdict(small_set(rules, "symmetry: rotations\nstages: {1: 1}\n"));
  REQUIRE(result.verdict == ProofVerdict::refuted);
  CHECK(result.refutation->first_end.size() == result.refutation->second_end.size());
}

TEST_CASE("when the effort is used up nothing falls over, wherever that is") {
  RuleSet rules = small_set(east_of("1", "1"), "box: {size: [20000, 1, 1], origin: [0, 0, 0]}\n");
  for (const std::uint64_t work : {1'000'000, 5'000'000, 20'000'000, 50'000'000}) {
    const VerifyResult result = verdict(rules, work);
    const bool sound =
        result.verdict == ProofVerdict::unknown || result.verdict == ProofVerdict::proved;
    CHECK(sound);
  }
}

TEST_CASE("an order that ends and one that does not: refuted") {
  // The cap stops the row, if it comes before the row has passed.
  const std::string cap = R"(
  - name: cap
    place: 3
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   . * ?   ? 1 ?
      ? ? ?   ? ? ?   ? ? ?
)";
  const std::string row = R"(
  - name: row
    place: 1
    when: |
      . ? ?   ? ? ?   ? ? ?
      . . .   1 * ?   ? ? ?
      . ? ?   ? ? ?   ? ? ?
)";
  const VerifyResult result = verdict(small_set(cap + row));
  CHECK(result.verdict == ProofVerdict::refuted);
}
