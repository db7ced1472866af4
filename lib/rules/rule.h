// SPDX-License-Identifier: MIT
// A rule as its author wrote it: symbolic, with source ranges.
//
// Meaning. A rule places one brick in an empty site whose neighbourhood matches its pattern,
// in some orientation of the symmetry group, when its conditions hold. Bricks are never
// removed. See docs/language.md for the file form, CONTRIBUTING.md for adding a key.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/source.h"
#include "rules/key_field.h"
#include "rules/neighbourhood.h"
#include "rules/symmetry.h"

namespace stig::rules {

/// The states allowed at each neighbour index; unused indices hold anything().
struct Pattern {
  std::array<StateSet, kMaxNeighbours> allowed;
  Pattern() { allowed.fill(StateSet::anything()); }
  bool operator==(const Pattern&) const = default;
};

/// How many neighbours show a state of a set: min <= number <= max.
struct CountCondition {
  StateSet of;
  bool faces_only = false;  ///< among: faces | all
  int min = 0;
  int max = kMaxNeighbours;
  SourceRange range;
};

/// Stages are numbered 1..kMaxStage, so that a set of stages fits a 64-bit word.
inline constexpr int kMaxStage = 63;

struct Rule {
  std::string name;
  Colour place = 0;
  Pattern pattern;
  std::optional<int> height_min, height_max;  ///< of the site, inclusive; floor = 0
  std::vector<CountCondition> counts;
  double probability = 1;            ///< in (0, 1]: chance to fire when chosen
  double weight = 1;                 ///< > 0: share in `conflicts: random`
  int stage = 0;                     ///< 1..; 0: active in every stage
  std::optional<Symmetry> symmetry;  ///< for this rule alone
  std::optional<bool> inversion;     ///< for this rule alone
  SourceRange range;                 ///< the whole entry
  SourceRange name_range, place_range, when_range;
};

template <SameButConst<CountCondition> C>
auto fields(C& count) {
  auto& [of, faces_only, min, max, range] = count;
  return std::tuple(KeyField{"of", of}, KeyField{"among", faces_only}, KeyField{"min", min},
                    KeyField{"max", max});
}

template <SameButConst<Rule> R>
auto fields(R& rule) {
  auto& [name, place, pattern, height_min, height_max, counts, probability, weight, stage, symmetry,
         inversion, range, name_range, place_range, when_range] = rule;
  // The order is that of the hash; the printer has the order of rule_schema.cpp.
  return std::tuple(
      KeyField{"name", name, Hashed::never}, KeyField{"place", place}, KeyField{"when", pattern},
      KeyField{"height/min", height_min}, KeyField{"height/max", height_max},
      KeyField{"count", counts}, KeyField{"probability", probability}, KeyField{"weight", weight},
      KeyField{"stage", stage}, KeyField{"symmetry", symmetry}, KeyField{"inversion", inversion});
}

}  // namespace stig::rules
