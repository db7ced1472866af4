// SPDX-License-Identifier: MIT
#include "rules/rule_printer.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "rules/rule_reader.h"
#include "rules/whole_rule_sets.h"
#include "support/golden.h"
#include "support/shipped.h"
#include "support/uses.h"

namespace stig {

namespace {

std::optional<RuleSet> read_back(const std::string& text) {
  Diagnostics diagnostics;
  auto rules = read_rule_set(std::make_shared<SourceFile>("printed", text), diagnostics);
  if (!rules) MESSAGE(to_text(diagnostics) << text);
  return rules;
}

}  // namespace

TEST_CASE("law: what is printed reads back as the same rule set") {
  CHECK(rc::check([] {
    const RuleSet rules = random_whole_rule_set();
    const auto again = read_back(print_rule_set(rules));
    RC_ASSERT(again.has_value());
    RC_ASSERT(*again == rules);
    RC_ASSERT(rule_set_hash(*again) == rule_set_hash(rules));
  }));
}

TEST_CASE("law: printing is settled after the first time") {
  CHECK(rc::check([] {
    const std::string first = print_rule_set(random_whole_rule_set());
    const auto again = read_back(first);
    RC_ASSERT(again.has_value());
    RC_ASSERT(print_rule_set(*again) == first);
  }));
}

TEST_CASE("shipped rule sets read back the same, comments kept") {
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    const RuleSet rules = shipped(name);
    const std::string text = print_rule_set(rules);
    const auto again = read_back(text);
    REQUIRE(again.has_value());
    CHECK(*again == rules);
    CHECK(again->comments.size() == rules.comments.size());
    CHECK(print_rule_set(*again) == text);
  }
}

TEST_CASE("every comment stays with what it was written at") {
  const auto rules = read_back(project_file("tests/golden/comments.yaml"));
  REQUIRE(rules.has_value());
  check_golden("tests/golden/comments-formatted.yaml", print_rule_set(*rules));
  const auto again = read_back(print_rule_set(*rules));
  REQUIRE(again.has_value());
  CHECK(again->comments.size() == rules->comments.size());
  CHECK(print_rule_set(*again) == print_rule_set(*rules));
}

TEST_CASE("a set of states without a symbol gets one in the legend") {
  RuleSet rules = shipped("staircase");
  const StateSet some = StateSet::of(1) | StateSet::of(3);
  CHECK(symbol_of(rules, some) == "{1,3}");
  rules.rules[0].pattern.allowed[0] = some;
  const auto again = read_back(print_rule_set(rules));
  REQUIRE(again.has_value());
  REQUIRE(again->legend.size() == 1);
  CHECK(again->legend[0].states == some);
  CHECK(again->rules[0].pattern == rules.rules[0].pattern);
}

TEST_CASE("drawings of both lattices") {
  RuleSet rules = shipped("staircase");
  Pattern pattern;
  pattern.allowed[0] = StateSet::empty_cell();
  pattern.allowed[12] = StateSet::of(3);
  pattern.allowed[25] = StateSet::floor();
  CHECK(draw_pattern(rules, pattern) ==
        ". ? ?   ? ? ?   ? ? ?\n"
        "? ? ?   3 * ?   ? ? ?\n"
        "? ? ?   ? ? ?   ? ? =\n");
  rules.lattice = Lattice::hexagonal;
  rules.bricks[2].symbol = "red";
  Pattern hexagonal;
  hexagonal.allowed[9] = StateSet::of(3);
  CHECK(draw_pattern(rules, hexagonal) ==
        "  ?   ?         ?   ?         ?   ?\n"
        "?   ?   ?     red *   ?     ?   ?   ?\n"
        "  ?   ?         ?   ?         ?   ?\n");
}

TEST_CASE("the hash sees what a set means, not how it is told") {
  const RuleSet rules = shipped("staircase");
  RuleSet told = rules;
  told.title = "another title";
  told.comments.clear();
  told.rules[0].name = "another name";
  CHECK(rule_set_hash(told) == rule_set_hash(rules));
  RuleSet meant = rules;
  meant.rules[0].height_max = 3;
  CHECK(rule_set_hash(meant) != rule_set_hash(rules));
  meant = rules;
  meant.start[0].at.x = 1;
  CHECK(rule_set_hash(meant) != rule_set_hash(rules));
  meant = rules;
  meant.symmetry = Symmetry::rotations;
  CHECK(rule_set_hash(meant) != rule_set_hash(rules));
}

}  // namespace stig
