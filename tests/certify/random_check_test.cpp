// SPDX-License-Identifier: MIT
// The checker against an exhaustive search over random rule sets.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "certify/brute_proof.h"
#include "certify/changes.h"
#include "certify/check.h"
#include "rules/rule_printer.h"
#include "support/random_rules.h"
#include "support/small_sets.h"
#include "support/uses.h"

namespace stig {
namespace {

constexpr std::size_t kMostStructures = 300;

int drawn(int low, int high) { return *rc::gen::inRange(low, high + 1); }

/// In a small box, solid or periodic, that is full after a few bricks.
RuleSet random_set_in_box() {
  RuleSet rules = random_rule_set();
  const bool one_stage = drawn(0, 2) > 0;
  for (Rule& rule : rules.rules) {
    if (one_stage) rule.stage = 0;
  }
  rules.conflicts = drawn(0, 2) == 0 ? Conflicts::first : Conflicts::random;
  rules.start = {{{0, 0, 0}, 1}};
  BoxSpec box{{drawn(1, 3), drawn(1, 3), drawn(1, 2)}, Cell{0, 0, 0}, drawn(0, 2) == 0};
  if (!box.periodic) box.origin = Cell{1 - box.size.x, 1 - box.size.y, 0};
  rules.box = box;
  if (drawn(0, 2) == 0) rules.stages[1] = drawn(1, 4);
  return rules;
}

struct Searched {
  RuleSet rules;
  std::vector<ReachedStage> stages;
};

/// A set with some events and not too many, and what they lead to; nothing when none was
/// found soon. Always at full size: rapidcheck's small cases are all alike.
std::optional<Searched> any_searched_set() {
  for (int attempt = 0; attempt < 20; ++attempt) {
    RuleSet rules = *rc::gen::resize(100, rc::gen::exec(random_set_in_box));
    auto stages = reach_all(rules, kMostStructures);
    if (stages && stages->front().events.size() > 2) return Searched{rules, *stages};
  }
  return std::nullopt;
}

/// Has every order of events one end, and has every stage been searched?
bool one_end(const RuleSet& rules, const std::vector<ReachedStage>& stages) {
  return stages.size() == static_cast<std::size_t>(rules.stage_count()) &&
         stages.back().ends.size() == 1;
}

TEST_CASE("one window over everything proves each set that has one end") {
  int proved = 0;
  CHECK(rc::check("whole windows", [&] {
    const auto searched = any_searched_set();
    if (!searched) return;
    const auto& [rules, stages] = *searched;
    if (!one_end(rules, stages)) return;
    const CheckReport report =
        check_certificate(rules, certificate_of(rules, stages, Grouping::all));
    RC_LOG() << report.refusal << "\n";
    RC_ASSERT(report.accepted);
    RC_ASSERT(report.structure == *stages.back().ends.begin());
    ++proved;
  }));
  CHECK(proved > 10);
}

/// 2s east and west of a 1 at any time, and a 3 north of it: before the 2 in the east, or after
/// the 2 in the west.
constexpr const char* kThree = R"(
  - name: east
    place: 2
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   1 * ?   ? ? ?
      ? ? ?   ? ? ?   ? ? ?
  - name: west
    place: 2
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   ? * 1   ? ? ?
      ? ? ?   ? ? ?   ? ? ?
  - name: before the east
    place: 3
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   ? * ?   ? ? ?
      ? ? ?   ? 1 .   ? ? ?
  - name: after the west
    place: 3
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   ? * ?   ? ? ?
      ? ? ?   2 1 ?   ? ? ?
)";

TEST_CASE("the order is one of events: structures that occur, one brick apart, are not enough") {
  const RuleSet rules =
      small_set(kThree, "conflicts: first\nbox: {size: [3, 3, 1], origin: [-1, -1, 0]}\n");
  const auto stages = reach_all(rules, kMostStructures);
  REQUIRE(stages);
  REQUIRE(stages->front().events.size() == 8);
  std::vector<CertifiedBrick> order{{{-1, 0, 0}, 2, 0}, {{0, 1, 0}, 3, 0}, {{1, 0, 0}, 2, 0}};
  std::vector<std::string> refusals;
  do {
    const CertifiedWindow window{{0, 1, 2}, {}, {{0}, {1}, {2}, {3}, {4}, {5}, {6}, {7}}};
    const Certificate certificate{rule_set_hash(rules), rules.box, {{order, {}, {window}}}, 4};
    refusals.push_back(check_certificate(rules, certificate).refusal);
  } while (std::next_permutation(
      order.begin(), order.end(),
      [](const CertifiedBrick& a, const CertifiedBrick& b) { return a.at < b.at; }));
  const std::string unplaced = "stage 1: no rule places the brick at (0, 1, 0) when its turn comes";
  CHECK(refusals == std::vector<std::string>{"", "", "", "", "", unplaced});
  CHECK(rc::check("orders drawn", [&] {
    RC_ASSERT(check_certificate(rules, certificate_of(rules, *stages, Grouping::all)).accepted);
  }));
}

TEST_CASE("what is accepted is the only end there is, whatever is claimed") {
  int accepted = 0, refused = 0, false_claims = 0;
  CHECK(rc::check("any certificate", [&] {
    const auto searched = any_searched_set();
    if (!searched) return;
    const auto& [rules, stages] = *searched;
    for (int attempt = 0; attempt < 20; ++attempt) {
      Certificate certificate = certificate_of(rules, stages, static_cast<Grouping>(drawn(0, 2)));
      for (int changes = drawn(0, 2); changes > 0; --changes) change_somewhere(certificate);
      const CheckReport report = check_certificate(rules, certificate);
      RC_ASSERT(report.accepted == report.refusal.empty());
      RC_LOG() << print_certificate(certificate) << "\n";
      if (report.accepted) {
        RC_ASSERT(one_end(rules, stages));
        RC_ASSERT(report.structure == *stages.back().ends.begin());
      }
      (report.accepted ? accepted : refused) += 1;
      false_claims += one_end(rules, stages) ? 0 : 1;
    }
  }));
  MESSAGE("accepted " << accepted << ", refused " << refused << ", " << false_claims
                      << " of sets without one end");
  CHECK(accepted > 100);
  CHECK(refused > 100);
  CHECK(false_claims > 100);
}

}  // namespace
}  // namespace stig
