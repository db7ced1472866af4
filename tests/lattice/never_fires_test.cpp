// SPDX-License-Identifier: MIT
#include "lattice/never_fires.h"

#include <doctest/doctest.h>

#include "support/shipped.h"
#include "support/small_sets.h"
#include "support/small_worlds.h"
#include "support/uses.h"

using namespace stig;

namespace {

using Never = std::vector<std::uint32_t>;

std::optional<Box> own_box(const RuleSet& rules) {
  if (!rules.box) return std::nullopt;
  return lay_box(*rules.box, rules.start, rules.floor);
}

Never never(const RuleSet& rules) { return rules_that_never_fire(rules, own_box(rules)); }

/// Places a 1 beside a 1 that is above or below it.
std::string in_slice(bool above) {
  const std::string rows = "      ? ? ?   ? ? ?   ? ? ?\n";
  const std::string row = above ? "      ? 1 ?   ? * ?   ? ? ?\n" : "      ? ? ?   ? * ?   ? 1 ?\n";
  return "  - name: raise\n    place: 1\n    height: {max: 3}\n    when: |\n" + rows + row + rows;
}

}  // namespace

TEST_CASE("a brick that is drawn in the wrong slice is nowhere on the floor") {
  CHECK(never(small_set(in_slice(true), "floor: true\n")) == Never{0});
  CHECK(never(small_set(in_slice(false), "floor: true\n")).empty());
  // Without a floor it hangs below the start, again and again.
  CHECK(never(small_set(in_slice(true))).empty());
}

TEST_CASE("it is a warning that stands on the rule's line") {
  const RuleSet rules =
      small_set(in_slice(true) + east_of("1", "2"), "floor: true\nconflicts: random\n");
  Diagnostics diagnostics;
  check_rules_fire(rules, diagnostics);
  REQUIRE(diagnostics.all().size() == 1);
  const Diagnostic& warning = diagnostics.all().front();
  CHECK(warning.code == Code::R318);
  CHECK(warning.severity == Severity::warning);
  CHECK(warning.message == "rule 'raise' never fires: what it asks for is never built");
  CHECK(warning.range);
  CHECK_FALSE(diagnostics.has_errors());
}

TEST_CASE("of growth without end the colours are known") {
  const std::string row = east_of("1", "1");
  CHECK(never(small_set(row + east_of("3", "2"))) == Never{1});
  CHECK(never(small_set(row + east_of("1", "2"), "conflicts: random\n")).empty());
}

TEST_CASE("a rule of an earlier stage does not wait for a later one") {
  const std::string late = east_of("1", "2", "    stage: 2\n");
  const std::string early = east_of("2", "3", "    stage: 1\n");
  CHECK(never(small_set(late + early)) == Never{1});
}

TEST_CASE("no shipped set but one has a rule that is said never to fire") {
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    // Of the table of 4(n), as printed, five patterns wait for what is never there; the
    // certificate of its steps 1 to 4 says so too.
    CHECK(never(shipped(name)).size() == (name == "architecture-4n" ? 5 : 0));
  }
}

TEST_CASE("law: no rule that some order of events fires is said never to fire") {
  int said = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    const RuleSet rules = seed % 4 == 0 ? staged_small_world(seed) : small_world(seed);
    const Never found = never(rules);
    const Never by_colours = rules_that_never_fire(rules, own_box(rules), 3);
    const std::set<std::uint32_t> fired = rules_seen_to_fire(rules, 300);
    CAPTURE(seed);
    for (const Never* rules_said : {&found, &by_colours}) {
      for (const std::uint32_t rule : *rules_said) CHECK_FALSE(fired.contains(rule));
    }
    said += static_cast<int>(found.size());
  }
  CHECK(said > 100);
}
