// SPDX-License-Identifier: MIT
// RuleTable against the oracle matcher: at random over everything the language
// offers, and exhaustively over small families of patterns.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "rules/rule_table.h"
#include "support/oracle.h"
#include "support/random_rules.h"
#include "support/uses.h"

namespace stig {
namespace {

bool agree(const OracleMatcher& oracle, const RuleTable& table, const View& view, std::int32_t z,
           int stage) {
  std::vector<Match> found;
  table.matches(view, z, stage, found);
  const auto expected = oracle.matches(view, z, stage);
  return found == expected && table.enabled(view, z, stage) == !expected.empty();
}

TEST_CASE("a table finds what trying every orientation finds") {
  int matched = 0;
  CHECK(rc::check("RuleTable == oracle", [&matched] {
    const RuleSet rules = random_rule_set();
    const RuleTable table(rules);
    const OracleMatcher oracle(rules);
    for (int k = 0; k < 50; ++k) {
      const View view = random_view(rules);
      const auto z = static_cast<std::int32_t>(*rc::gen::inRange(-3, 6));
      const int stage = *rc::gen::inRange(1, rules.stage_count() + 1);
      RC_ASSERT(agree(oracle, table, view, z, stage));
      matched += oracle.matches(view, z, stage).empty() ? 0 : 1;
    }
  }));
  CHECK(matched > 200);  // the law is not held by silence
}

TEST_CASE("entries of a rule are its distinct orientations, each once") {
  CHECK(rc::check("entries", [] {
    const RuleSet rules = random_rule_set();
    const RuleTable table(rules);
    const auto& entries = table.entries();
    for (std::size_t a = 0; a < entries.size(); ++a) {
      const Rule& rule = rules.rules[entries[a].source.rule];
      const auto group =
          orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule));
      RC_ASSERT(entries[a].source.orientation < group.size());
      for (std::size_t b = 0; b < a; ++b) {
        const bool same_rule = entries[a].source.rule == entries[b].source.rule;
        RC_ASSERT(!same_rule || entries[a].pattern != entries[b].pattern);
      }
    }
  }));
}

/// The groups to go through.
struct Family {
  Lattice lattice;
  Symmetry symmetry;
  bool inversion;
};

/// Over every view that shows at most two bricks of two colours.
int disagreements_over_two_bricks(const RuleSet& rules) {
  const RuleTable table(rules);
  const OracleMatcher oracle(rules);
  const auto size = static_cast<std::size_t>(neighbourhood(rules.lattice).size);
  int disagreements = 0;
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = a + 1; b < size; ++b) {
      for (State s = 0; s < 9; ++s) {
        View view;
        view.at[a] = s % 3;
        view.at[b] = s / 3;
        disagreements += agree(oracle, table, view, 0, 1) ? 0 : 1;
      }
    }
  }
  return disagreements;
}

void check_family(const Family& family, std::pair<std::size_t, std::size_t> drawn,
                  StateSet others) {
  RuleSet rules;
  rules.lattice = family.lattice;
  rules.symmetry = family.symmetry;
  rules.inversion = family.inversion;
  rules.bricks.resize(2);
  rules.rules.resize(1);
  rules.rules[0].place = 1;
  auto& allowed = rules.rules[0].pattern.allowed;
  std::fill_n(allowed.begin(), neighbourhood(family.lattice).size, others);
  const std::array<StateSet, 5> kinds{StateSet::empty_cell(), StateSet::of(1), StateSet::of(2),
                                      StateSet::bricks(2), StateSet::anything()};
  for (const StateSet first : kinds) {
    for (const StateSet second : kinds) {
      allowed[drawn.first] = first;
      allowed[drawn.second] = second;
      CHECK(disagreements_over_two_bricks(rules) == 0);
    }
  }
}

TEST_CASE("exhaustively: two cells drawn, every view of two bricks") {
  for (const Lattice lattice : {Lattice::cubic, Lattice::hexagonal}) {
    const auto below = static_cast<std::size_t>(neighbourhood(lattice).first_below);
    const auto above = static_cast<std::size_t>(neighbourhood(lattice).cells_above);
    for (const Symmetry symmetry :
         {Symmetry::none, Symmetry::rotations, Symmetry::rotations_mirrors}) {
      for (const bool inversion : {false, true}) {
        const Family family{lattice, symmetry, inversion};
        check_family(family, {above, above + 1}, StateSet::anything());
        check_family(family, {above + 1, below}, StateSet::empty_cell());
        check_family(family, {0, below + 1}, StateSet::empty_cell());
      }
    }
  }
}

}  // namespace
}  // namespace stig
