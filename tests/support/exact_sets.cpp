// SPDX-License-Identifier: MIT
#include "support/exact_sets.h"
#include "support/uses.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <string>

namespace stig {
namespace {

Pattern exactly(const View& view, int size) {
  Pattern pattern;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    pattern.allowed[i] = StateSet::of(view.at[i]);
  }
  return pattern;
}

std::vector<Pattern> turns_of(const RuleSet& rules, const Pattern& pattern) {
  std::vector<Pattern> turns;
  for (const Orientation& g : orientations(rules.lattice, rules.symmetry, rules.inversion)) {
    Pattern turned;
    for (std::size_t i = 0; i < static_cast<std::size_t>(neighbourhood(rules.lattice).size); ++i) {
      turned.allowed[static_cast<std::size_t>(g.image[i])] = pattern.allowed[i];
    }
    turns.push_back(turned);
  }
  return turns;
}

/// Adds the rule unless one of its turns is there with the same colour.
void add_rule(RuleSet& rules, const Pattern& pattern, Colour place) {
  const auto turns = turns_of(rules, pattern);
  for (const Rule& known : rules.rules) {
    const bool same = std::find(turns.begin(), turns.end(), known.pattern) != turns.end();
    if (same && known.place == place) return;
  }
  Rule rule;
  rule.name = "rule " + std::to_string(rules.rules.size() + 1);
  rule.place = place;
  rule.pattern = pattern;
  rules.rules.push_back(rule);
}

/// One pattern for every subset of the neighbours in the same orbit.
void add_patterns_of(RuleSet& rules, const BrickMap& before, Cell site,
                     const std::vector<Cell>& orbit, Colour colour) {
  const Neighbourhood& n = neighbourhood(rules.lattice);
  std::vector<Cell> free;
  for (const Cell other : orbit) {
    if (n.index_of(other - site) >= 0) free.push_back(other);
  }
  for (unsigned subset = 0; subset < 1U << free.size(); ++subset) {
    OracleWorld world(rules, std::nullopt);
    for (const auto& [cell, c] : before) world.place({cell, c});
    for (std::size_t k = 0; k < free.size(); ++k) {
      if ((subset >> k) & 1U) world.place({free[k], colour});
    }
    add_rule(rules, exactly(world.view(site), n.size), colour);
  }
}

bool shows_nothing(const Pattern& pattern, int size) {
  return std::all_of(pattern.allowed.begin(), pattern.allowed.begin() + size,
                     [](StateSet s) { return s == StateSet::empty_cell(); });
}

bool has_conflict(const RuleSet& rules) {
  for (const Rule& a : rules.rules) {
    const auto turns = turns_of(rules, a.pattern);
    for (const Rule& b : rules.rules) {
      const bool same = std::find(turns.begin(), turns.end(), b.pattern) != turns.end();
      if (same && a.place != b.place) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::vector<Cell>> orbits_of(const BrickMap& target, Symmetry symmetry) {
  std::set<std::vector<Cell>> orbits;
  for (const auto& [cell, colour] : target) {
    std::set<Cell> orbit;
    for (const Orientation& g : orientations(Lattice::cubic, symmetry, false)) {
      orbit.insert(Cell{} + g.apply(cell - Cell{}));
    }
    orbits.insert({orbit.begin(), orbit.end()});
  }
  return {orbits.begin(), orbits.end()};
}

RuleSet exact_set(const BrickMap& target, const std::vector<std::vector<Cell>>& orbits,
                  Symmetry symmetry) {
  RuleSet rules;
  rules.symmetry = symmetry;
  rules.bricks.resize(3);
  assert(orbits.at(0).size() == 1);
  const Cell start = orbits[0][0];
  rules.start = {{start, target.at(start)}};
  BrickMap before = start_of(rules);
  for (std::size_t k = 1; k < orbits.size(); ++k) {
    for (const Cell site : orbits[k]) {
      add_patterns_of(rules, before, site, orbits[k], target.at(site));
    }
    for (const Cell site : orbits[k]) before[site] = target.at(site);
  }
  return rules;
}

bool builds_exactly(const RuleSet& rules, const BrickMap& target) {
  const int size = neighbourhood(rules.lattice).size;
  for (const Rule& rule : rules.rules) {
    if (shows_nothing(rule.pattern, size)) return false;
  }
  if (has_conflict(rules)) return false;
  const Exploration found = explore_orders(rules, start_of(rules), 1, std::nullopt,
                                           {.states = 1000, .deposits = target.size()});
  return found.complete && found.ends == std::vector<BrickMap>{target};
}

}  // namespace stig
