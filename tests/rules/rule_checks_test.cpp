// SPDX-License-Identifier: MIT
// The static checks against brute force: every view tried, every orientation.
#include "rules/rule_checks.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "rules/conflicts.h"
#include "rules/rule_reader.h"
#include "rules/rule_table.h"
#include "rules/view_search.h"
#include "support/draws.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {

namespace {

/// Cells that differ in these tests: on both lattices some above, beside and below,
/// turned into each other by rotations.
std::vector<std::size_t> open_cells(Lattice lattice) {
  const Neighbourhood& n = neighbourhood(lattice);
  std::vector<std::size_t> cells;
  for (const Offset o : {Offset{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}) {
    cells.push_back(static_cast<std::size_t>(n.index_of(o)));
  }
  return cells;
}

StateSet random_states(bool floor) {
  StateSet out;
  for (State s = 0; s <= 2; ++s) {
    if (chance()) out = out | StateSet::of(s);
  }
  if (floor && chance()) out = out | StateSet::floor();
  return out.none() ? StateSet::anything() : out;
}

Rule random_rule(const RuleSet& rules, const std::string& name) {
  Rule rule;
  rule.name = name;
  rule.place = static_cast<Colour>(1 + below(2));
  // Everything else is empty, or floor where there may be floor.
  for (StateSet& states : rule.pattern.allowed) states = StateSet::empty_cell();
  const Neighbourhood& n = neighbourhood(rules.lattice);
  for (int i = n.first_below; i < n.size && rules.floor; ++i) {
    auto& states = rule.pattern.allowed[static_cast<std::size_t>(i)];
    states = StateSet::empty_cell() | StateSet::floor();
  }
  for (const std::size_t cell : open_cells(rules.lattice)) {
    rule.pattern.allowed[cell] = random_states(rules.floor);
  }
  if (chance()) rule.height_min = below(3);
  if (chance()) rule.height_max = below(3);
  for (int i = below(3); i > 0; --i) {
    const int low = below(4);
    rule.counts.push_back({random_states(rules.floor), chance(), low, low + below(27 - low), {}});
  }
  rule.stage = below(3);
  return rule;
}

RuleSet random_set() {
  RuleSet rules;
  rules.name = "random";
  rules.lattice = chance() ? Lattice::cubic : Lattice::hexagonal;
  rules.symmetry = static_cast<Symmetry>(below(3));
  rules.inversion = chance();
  rules.floor = chance();
  rules.bricks = {{"1", "1", "#000000", "", {}}, {"2", "2", "#000000", "", {}}};
  rules.start = {{{0, 0, 0}, 1}, {{5, 0, 0}, 2}};
  return rules;
}

/// A view of a site at height z in which only open cells hold bricks.
View random_view(const RuleSet& rules, std::int32_t z) {
  const Neighbourhood& n = neighbourhood(rules.lattice);
  View view;
  for (const std::size_t cell : open_cells(rules.lattice)) {
    view.at[cell] = static_cast<State>(below(3));
  }
  for (int i = n.first_below; rules.floor && z == 0 && i < n.size; ++i) {
    view.at[static_cast<std::size_t>(i)] = kFloor;
  }
  return view;
}

/// A random rule that matches a view as it is drawn.
Rule rule_around(const RuleSet& rules, const View& view, std::int32_t z, const std::string& name) {
  Rule rule = random_rule(rules, name);
  for (const std::size_t cell : open_cells(rules.lattice)) {
    rule.pattern.allowed[cell] = rule.pattern.allowed[cell] | StateSet::of(view.at[cell]);
  }
  if (rule.height_min) rule.height_min = std::min(*rule.height_min, z);
  if (rule.height_max) rule.height_max = std::max(*rule.height_max, z);
  for (CountCondition& count : rule.counts) {
    const int number = count_in_view(count, neighbourhood(rules.lattice), view);
    count.min = std::min(count.min, number);
    count.max = std::max(count.max, number);
  }
  return rule;
}

/// Calls `visit` with every view in which only open cells hold bricks, with and
/// without floor, at each height at which anything can differ. True when one call was.
template <class Visit>
bool any_view(const RuleSet& rules, Visit visit) {
  const Neighbourhood& n = neighbourhood(rules.lattice);
  const auto cells = open_cells(rules.lattice);
  for (std::int32_t z = rules.floor ? 0 : -1; z <= 4; ++z) {
    View base;
    const bool on_floor = rules.floor && z == 0;
    for (int i = n.first_below; on_floor && i < n.size; ++i) {
      base.at[static_cast<std::size_t>(i)] = kFloor;
    }
    for (int code = 0; code < 243; ++code) {
      View view = base;
      int rest = code;
      for (const std::size_t cell : cells) {
        if (!on_floor || static_cast<int>(cell) < n.first_below) {
          view.at[cell] = static_cast<State>(rest % 3);
        }
        rest /= 3;
      }
      if (visit(view, z)) return true;
    }
  }
  return false;
}

bool matches(const RuleSet& rules, const Rule& rule, const View& view, std::int32_t z) {
  Demand demand = demand_of(rule);
  for (const Orientation& g :
       orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule))) {
    demand.pattern = turned(rule.pattern, g, rules.lattice);
    if (fulfils(demand, rules.lattice, view, z)) return true;
  }
  return false;
}

bool reports(const RuleSet& rules, Code code) {
  Diagnostics diagnostics;
  check_rule_set(rules, CheckScope::all, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    if (d.code == code) return true;
  }
  return false;
}

std::vector<Code> codes_of(const std::string& text) {
  Diagnostics diagnostics;
  read_rule_set(std::make_shared<SourceFile>("f", text), diagnostics);
  std::vector<Code> codes;
  for (const Diagnostic& d : diagnostics.all()) codes.push_back(d.code);
  return codes;
}

}  // namespace

TEST_CASE("law: a view is found exactly when one exists, and it fulfils what was asked") {
  CHECK(rc::check([] {
    RuleSet rules = random_set();
    rules.symmetry = Symmetry::none;
    rules.inversion = false;
    const Rule rule = random_rule(rules, "r");
    Example example;
    Budget budget = 1'000'000;
    const Answer answer = find_view(rules, demand_of(rule), example, budget);
    const bool exists = any_view(
        rules, [&](const View& view, std::int32_t z) { return matches(rules, rule, view, z); });
    RC_ASSERT(answer == (exists ? Answer::yes : Answer::no));
    if (exists) RC_ASSERT(fulfils(demand_of(rule), rules.lattice, example.view, example.z));
  }));
}

TEST_CASE("law: a conflict is reported exactly when some view matches two rules") {
  CHECK(rc::check([] {
    RuleSet rules = random_set();
    rules.rules = {random_rule(rules, "a"), random_rule(rules, "b")};
    if (chance()) rules.rules[1].symmetry = static_cast<Symmetry>(below(3));
    if (chance()) rules.rules[1].inversion = chance();
    const Rule& a = rules.rules[0];
    const Rule& b = rules.rules[1];
    const bool rivals = a.place != b.place && (a.stage == b.stage || a.stage == 0 || b.stage == 0);
    const bool expected = rivals && any_view(rules, [&](const View& view, std::int32_t z) {
                            return matches(rules, a, view, z) && matches(rules, b, view, z);
                          });
    RC_ASSERT(reports(rules, Code::R301) == expected);
    rules.conflicts = Conflicts::random;
    RC_ASSERT(!reports(rules, Code::R301));
  }));
}

TEST_CASE("law: two rules that are drawn around one view are in conflict") {
  CHECK(rc::check([] {
    RuleSet rules = random_set();
    const std::int32_t z = below(5);
    const View view = random_view(rules, z);
    rules.rules = {rule_around(rules, view, z, "a"), rule_around(rules, view, z, "b")};
    rules.rules[1].place = rules.rules[0].place == 1 ? 2 : 1;
    rules.rules[1].stage = rules.rules[0].stage;
    RC_ASSERT(reports(rules, Code::R301));
    rules.conflicts = Conflicts::random;
    RC_ASSERT(!reports(rules, Code::R301));
  }));
}

TEST_CASE("law: a rule that never matches, or matches bare space, is told exactly") {
  CHECK(rc::check([] {
    RuleSet rules = random_set();
    rules.rules = {random_rule(rules, "a")};
    const Rule& rule = rules.rules[0];
    const bool possible = any_view(
        rules, [&](const View& view, std::int32_t z) { return matches(rules, rule, view, z); });
    RC_ASSERT(reports(rules, Code::R305) == !possible);
    const bool bare = any_view(rules, [&](const View& view, std::int32_t z) {
      for (const State state : view.at) {
        if (is_brick(state)) return false;
      }
      return matches(rules, rule, view, z);
    });
    RC_ASSERT(reports(rules, Code::R304) == bare);
  }));
}

TEST_CASE("law: an image of a rule repeats it, exactly when it is in the group") {
  CHECK(rc::check([] {
    RuleSet rules = random_set();
    const Rule rule = random_rule(rules, "a");
    Rule image = rule;
    image.name = "b";
    const auto all = orientations(rules.lattice, Symmetry::rotations_mirrors, true);
    const Orientation& g = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
    image.pattern = turned(rule.pattern, g, rules.lattice);
    rules.rules = {rule, image};
    bool in_group = false;
    for (const Orientation& h : orientations(rules.lattice, rules.symmetry, rules.inversion)) {
      in_group = in_group || turned(rule.pattern, h, rules.lattice) == image.pattern;
    }
    RC_ASSERT(reports(rules, Code::R303) == in_group);
    rules.rules[1].height_max = rule.height_max.value_or(0) + 1;
    RC_ASSERT(!reports(rules, Code::R303));
  }));
}

TEST_CASE("rules of different stages do not conflict, and orientations of one never do") {
  const std::string text = project_file("tests/bad/R301-conflict-exact.yaml");
  CHECK(codes_of(text) == std::vector{Code::R301});
  std::string staged = text;
  staged.replace(staged.find("place: 2"), 8, "stage: 1\n    place: 2");
  staged.replace(staged.find("place: pink"), 11, "stage: 2\n    place: pink");
  CHECK(codes_of(staged).empty());
  std::string same = text;
  same.replace(same.find("place: pink"), 11, "place: 2");
  CHECK(codes_of(same) == std::vector{Code::R303});
}

TEST_CASE("a repetition is found behind a rule that holds in fewer orientations") {
  const std::string head = project_file("tests/bad/R303-repeated.yaml");
  Diagnostics diagnostics;
  auto rules = read_rule_set(std::make_shared<const SourceFile>("m.yaml", head), diagnostics);
  REQUIRE(rules.has_value());
  Rule rule = rules->rules[0];
  for (StateSet& states : rule.pattern.allowed) states = StateSet::empty_cell();
  rule.pattern.allowed[open_cells(rules->lattice)[0]] = StateSet::of(1);
  rules->rules.assign(3, rule);
  rules->rules[0].symmetry = Symmetry::none;
  rules->rules[1].symmetry = rules->rules[2].symmetry = Symmetry::rotations;
  for (std::size_t i = 0; i < 3; ++i) rules->rules[i].name = std::string(1, "ABC"[i]);
  Diagnostics found;
  check_repetitions(*rules, found);
  REQUIRE(found.all().size() == 1);
  CHECK(found.all()[0].message == "rule 'C' repeats rule 'B'");
}

TEST_CASE("many conflicts: each pair once, and an end") {
  RuleSet rules;
  rules.bricks = {{"1", "1", "#000000", "", {}}, {"2", "2", "#000000", "", {}}};
  rules.start = {{{0, 0, 0}, 1}};
  Rule rule;
  rule.pattern.allowed[0] = StateSet::of(1);
  for (int i = 0; i < 40; ++i) {
    rule.place = static_cast<Colour>(1 + i % 2);
    rule.name = "r" + std::to_string(i);
    rule.height_min = -i;
    rules.rules.push_back(rule);
  }
  Diagnostics diagnostics;
  check_rule_set(rules, CheckScope::all, diagnostics);
  CHECK(diagnostics.count(Severity::error) == 100);
  CHECK(diagnostics.count(Severity::warning) == 1);
}

}  // namespace stig
