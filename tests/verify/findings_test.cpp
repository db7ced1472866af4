// SPDX-License-Identifier: MIT
#include "verify/findings.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include "support/shipped.h"
#include "support/small_sets.h"

using namespace stig;

namespace {

Findings findings_of(const RuleSet& rules) {
  VerifyOptions options;
  options.box = file_box(rules);
  const VerifyResult result = verify::verify(rules, options);
  CHECK(result.verdict == ProofVerdict::proved);
  return find_more(rules, options, result, {});
}

}  // namespace

TEST_CASE("a rule that waits for a brick that never comes is dead") {
  const Findings f =
      findings_of(small_set(east_of("1", "2") + east_of("3", "1", "    height: {min: 0}\n")));
  CHECK(f.dead == std::vector<std::uint32_t>{1});
  CHECK(f.redundant.empty());
  CHECK(f.untried == 0);
}

TEST_CASE("of a refuted set it is known too") {
  const RuleSet rules = small_set(east_of("1", "2") + east_of("1", "3") + east_of("3", "1"),
                                  "conflicts: random\nfloor: true\n");
  RuleSet more = rules;
  more.rules.back().height_min = 1;
  const VerifyResult result = verify::verify(more, {});
  REQUIRE(result.verdict == ProofVerdict::refuted);
  CHECK(find_more(more, {}, result, {}).dead == std::vector<std::uint32_t>{2});
}

TEST_CASE("of two rules that do the same either can be left out") {
  const std::string again = R"(
  - name: the same, if nothing is above
    place: 2
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? . ?   1 * ?   ? ? ?
      ? ? ?   ? ? ?   ? ? ?
)";
  const Findings f = findings_of(small_set(east_of("1", "2") + again));
  CHECK(f.redundant == std::vector<std::uint32_t>{0, 1});
  CHECK(f.dead.empty());
}

TEST_CASE("what else there is to say depends on the work allowed, not on the clock") {
  const RuleSet rules = shipped("stepped-pyramid");
  VerifyOptions options;
  const VerifyResult result = verify::verify(rules, options);
  REQUIRE(result.verdict == ProofVerdict::proved);
  CHECK(result.work > 0);
  CHECK(verify::verify(rules, options).work == result.work);
  const Findings none = find_more(rules, options, result, {1});
  CHECK(none.untried == rules.rules.size());
  CHECK(none.redundant.empty());
  // For the first rule's trial alone.
  const Findings some = find_more(rules, options, result, {result.work});
  CHECK(some.untried > 0);
  CHECK(some.untried < rules.rules.size());
  CHECK(find_more(rules, options, result, {}).untried == 0);
}

TEST_CASE("a repair that was not looked for to the end is said to be open") {
  const RuleSet rules = small_set(east_of("1", "2") + east_of("1", "3"), "conflicts: random\n");
  VerifyOptions options;
  const VerifyResult result = verify::verify(rules, options);
  REQUIRE(result.verdict == ProofVerdict::refuted);
  const Findings cut = find_more(rules, options, result, {1});
  CHECK_FALSE(cut.repair);
  CHECK(cut.repair_cut_short);
  const Findings all = find_more(rules, options, result, {});
  CHECK(all.repair);
  CHECK_FALSE(all.repair_cut_short);
}

TEST_CASE("a verdict depends on the work allowed") {
  VerifyOptions options;
  options.work = 1;
  CHECK(verify::verify(shipped("stepped-pyramid"), options).verdict == ProofVerdict::unknown);
}

TEST_CASE("a row has as many rounds as bricks, four arms have fewer") {
  const Findings f = findings_of(small_set(east_of("1", "2") + east_of("2", "3")));
  REQUIRE(f.parallelism);
  CHECK(f.parallelism->rounds == std::vector<std::uint64_t>{1, 1});
  const Findings pyramid = findings_of(shipped("stepped-pyramid"));
  REQUIRE(pyramid.parallelism);
  CHECK(pyramid.parallelism->widest() >= 4);
}

TEST_CASE("a hollow that can be closed before its inside is filled") {
  // A shell grows around the start in any order; the inside fills whenever.
  std::string rules;
  const RuleSet fill = [] {
    RuleSet set = small_set(east_of("1", "1"));
    set.box = BoxSpec{{5, 5, 5}, Cell{-2, -2, -2}, false};
    set.symmetry = Symmetry::rotations;
    Rule up = set.rules.front();
    up.name = "up";
    const Neighbourhood& n = neighbourhood(set.lattice);
    for (const int z : {-1, 1}) {
      up.name = z < 0 ? "up" : "down";
      up.pattern = Pattern{};
      up.pattern.allowed[static_cast<std::size_t>(n.index_of({0, 0, z}))] = StateSet::of(1);
      set.rules.push_back(up);
    }
    set.box = BoxSpec{{9, 9, 9}, Cell{-4, -4, -4}, false};
    for (Rule& rule : set.rules) {
      rule.height_min = -2;
      rule.height_max = 2;
    }
    return set;
  }();
  const Findings f = findings_of(fill);
  CHECK_FALSE(f.walled_in.empty());
}

TEST_CASE("a plate that grows outwards walls nothing in") {
  const Findings f = findings_of(shipped("plate"));
  CHECK(f.walled_in.empty());
  CHECK(f.maybe_walled_in == 0);
}
