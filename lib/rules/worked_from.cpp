// SPDX-License-Identifier: MIT
// Spells out the orientations in which robots on some sides meet a rule, as rules without
// symmetry. That makes the set larger and its meaning smaller: what no robot does, no robot
// can be asked to prove harmless. Names of turned rules carry the turn, so messages stay
// traceable.
#include "rules/worked_from.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <string_view>

namespace stig::rules {

namespace {

/// In the order of quarter turns from +x.
constexpr std::string_view kSides[] = {"+x", "+y", "-x", "-y"};

/// Where a robot at +x stands after the turn.
std::string_view side_of(const Orientation& orientation) {
  const Offset at = orientation.apply({1, 0, 0});
  assert((at.x == 0) != (at.y == 0));
  if (at.x != 0) return at.x > 0 ? kSides[0] : kSides[2];
  return at.y > 0 ? kSides[1] : kSides[3];
}

Pattern turned(const Pattern& pattern, const Orientation& orientation, int size) {
  Pattern out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    out.allowed[static_cast<std::size_t>(orientation.image[i])] = pattern.allowed[i];
  }
  return out;
}

}  // namespace

RuleSet worked_from(RuleSet rules, const std::vector<std::string>& sides) {
  const std::set<std::string_view> from(sides.begin(), sides.end());
  // Without symmetry there is nothing to leave out.
  const bool symmetric = std::any_of(rules.rules.begin(), rules.rules.end(), [&](const Rule& rule) {
    return rules.symmetry_of(rule) != Symmetry::none;
  });
  if (from.empty() || from.size() == std::size(kSides) || !symmetric ||
      rules.lattice != Lattice::cubic) {
    return rules;
  }
  const int size = neighbourhood(rules.lattice).size;
  std::vector<Rule> out;
  for (const Rule& rule : rules.rules) {
    // A rule that is written for one orientation holds for robots wherever they stand.
    const bool as_written = rules.symmetry_of(rule) == Symmetry::none;
    const auto group =
        orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule));
    // Patterns with a symmetry of their own would appear several times.
    std::vector<Pattern> known;
    for (const Orientation& orientation : group) {
      if (!as_written && !from.contains(side_of(orientation))) continue;
      Rule one = rule;
      one.pattern = turned(rule.pattern, orientation, size);
      if (std::find(known.begin(), known.end(), one.pattern) != known.end()) continue;
      known.push_back(one.pattern);
      if (&orientation != &group.front()) one.name += " (" + orientation.name + ")";
      one.symmetry.reset();
      one.inversion.reset();
      out.push_back(std::move(one));
    }
  }
  rules.rules = std::move(out);
  rules.symmetry = Symmetry::none;
  rules.inversion = false;
  return rules;
}

/// The file's own sides are what its author says of the robots' world.
const std::vector<std::string>& own_sides(const RuleSet& rules,
                                          const std::vector<std::string>& sides) {
  return sides.empty() && rules.physical ? rules.physical->sides : sides;
}

RuleSet worked_from_own(RuleSet rules, const std::vector<std::string>& sides) {
  const std::vector<std::string> from = own_sides(rules, sides);
  return worked_from(std::move(rules), from);
}

}  // namespace stig::rules
