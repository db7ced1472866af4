// SPDX-License-Identifier: MIT
#include "support/random_rules.h"

#include <rapidcheck.h>

#include <vector>

#include "support/draw_fields.h"
#include "support/uses.h"

namespace stig {
namespace {

int number(int low, int high) { return *rc::gen::inRange(low, high + 1); }
bool one_in(int n) { return number(1, n) == n; }

/// Every state a cell may show under the set.
std::vector<State> states_of(const RuleSet& rules) {
  std::vector<State> states{kEmpty};
  for (int c = 1; c <= rules.colours(); ++c) states.push_back(static_cast<State>(c));
  if (rules.floor) states.push_back(kFloor);
  return states;
}

StateSet random_set(const RuleSet& rules) {
  StateSet set;
  for (const State s : states_of(rules)) {
    if (one_in(2)) set = set | StateSet::of(s);
  }
  return set.none() ? StateSet::empty_cell() : set;
}

/// How a rule draws its cells: exactly, with wildcards here and there, or hardly at all.
enum class Manner { exact, mixed, sparse };

StateSet random_cell(const RuleSet& rules, Manner manner) {
  const auto colour = static_cast<State>(number(1, rules.colours()));
  if (manner == Manner::exact) {
    return one_in(4) ? StateSet::of(colour) : StateSet::empty_cell();
  }
  if (manner == Manner::sparse && !one_in(6)) return StateSet::anything();
  switch (number(0, 6)) {
    case 0:
    case 1:
      return StateSet::anything();
    case 2:
      return StateSet::bricks(rules.colours());
    case 3:
      return StateSet::of(colour);
    case 4:
      return random_set(rules);
    default:
      return StateSet::empty_cell();
  }
}

CountCondition random_count(const RuleSet& rules) {
  CountCondition count;
  count.of = random_set(rules);
  count.faces_only = one_in(2);
  count.min = number(0, 3);
  count.max = number(count.min, 20);
  return count;
}

Rule random_rule(const RuleSet& rules) {
  Rule rule;
  rule.place = static_cast<Colour>(number(1, rules.colours()));
  const auto manner = static_cast<Manner>(number(0, 2));
  const Neighbourhood& n = neighbourhood(rules.lattice);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    rule.pattern.allowed[i] = random_cell(rules, manner);
  }
  if (one_in(3)) rule.counts.push_back(random_count(rules));
  draw_fields(rule, rule_form(), 4, {});
  return rule;
}

State random_state_in(const RuleSet& rules, StateSet allowed) {
  std::vector<State> states;
  for (const State s : states_of(rules)) {
    if (allowed.contains(s)) states.push_back(s);
  }
  if (states.empty()) return kEmpty;
  return states[static_cast<std::size_t>(number(0, static_cast<int>(states.size()) - 1))];
}

}  // namespace

RuleSet random_rule_set() {
  RuleSet rules;
  rules.lattice = one_in(2) ? Lattice::cubic : Lattice::hexagonal;
  rules.symmetry = static_cast<Symmetry>(number(0, 2));
  rules.inversion = one_in(3);
  rules.floor = one_in(3);
  rules.bricks.resize(static_cast<std::size_t>(number(1, 3)));
  const int count = number(1, 6);
  for (int r = 0; r < count; ++r) rules.rules.push_back(random_rule(rules));
  return rules;
}

View random_view(const RuleSet& rules) {
  const Neighbourhood& n = neighbourhood(rules.lattice);
  const auto r = static_cast<std::size_t>(number(0, static_cast<int>(rules.rules.size()) - 1));
  const Rule& rule = rules.rules[r];
  const auto group = orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule));
  const auto g = static_cast<std::size_t>(number(0, static_cast<int>(group.size()) - 1));
  View view;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    const auto there = static_cast<std::size_t>(n.index_of(group[g].apply(n.offsets[i])));
    view.at[there] = random_state_in(rules, rule.pattern.allowed[i]);
  }
  for (int change = number(0, 2); change > 0; --change) {
    view.at[static_cast<std::size_t>(number(0, n.size - 1))] =
        random_state_in(rules, StateSet::anything());
  }
  return view;
}

}  // namespace stig
