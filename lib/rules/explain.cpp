// SPDX-License-Identifier: MIT
// Explains by trying: every orientation of every rule is compared with the view, and the
// one with the fewest disagreeing cells is reported. No index of the rule table is asked, so
// an explanation is an independent account of a match.
#include "rules/explain.h"

#include <cassert>

#include "rules/rule_table.h"
#include "rules/site_condition.h"

namespace stig::rules {
namespace {

/// All disagreeing cells are listed, not only the first, since authors look for a pattern
/// in them.
std::vector<FailedCell> failed_cells(const Neighbourhood& neighbours, const Pattern& pattern,
                                     const View& view) {
  std::vector<FailedCell> failed;
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours.size); ++i) {
    if (pattern.allowed[i].contains(view.at[i])) continue;
    failed.push_back({neighbours.offsets[i], pattern.allowed[i], view.at[i]});
  }
  return failed;
}

/// A bound, unless it stands for none.
std::optional<int> bound(std::int64_t value, std::int64_t none) {
  return value == none ? std::nullopt : std::optional(static_cast<int>(value));
}

/// Conditions are listed whether or not the drawing matches.
std::vector<FailedCondition> failed_conditions(const Rule& rule, const Neighbourhood& neighbours,
                                               const View& view, const SiteState& site) {
  std::vector<FailedCondition> failed;
  for_each_part(
      site_condition(rule), site,
      [&](std::string_view key, const Interval& asked, std::int64_t value) {
        if (asked.contains(value)) return;
        failed.push_back({key, 0, static_cast<int>(value), bound(asked.low, Interval().low),
                          bound(asked.high, Interval().high)});
      });
  for (std::size_t i = 0; i < rule.counts.size(); ++i) {
    const CountCondition& condition = rule.counts[i];
    const int number = count_in_view(condition, neighbours, view);
    if (number >= condition.min && number <= condition.max) continue;
    failed.push_back({"count", i, number, condition.min, condition.max});
  }
  return failed;
}

}  // namespace

Explanation explain(const RuleSet& rules, const View& view, std::int32_t z, int stage) {
  assert(stage >= 1);
  const Neighbourhood& neighbours = neighbourhood(rules.lattice);
  Explanation result{view, z, stage, {}};
  for (std::size_t r = 0; r < rules.rules.size(); ++r) {
    const Rule& rule = rules.rules[r];
    const auto turns =
        orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule));
    RuleExplanation said;
    said.rule = static_cast<std::uint32_t>(r);
    said.orientations = static_cast<std::uint32_t>(turns.size());
    for (std::size_t t = 0; t < turns.size(); ++t) {
      auto cells =
          failed_cells(neighbours, oriented(rule.pattern, turns[t], neighbours.size), view);
      // Strictly fewer, so the first of several nearest orientations is kept.
      if (t > 0 && cells.size() >= said.cells.size()) continue;
      said.cells = std::move(cells);
      said.orientation = static_cast<std::uint32_t>(t);
    }
    said.conditions = failed_conditions(rule, neighbours, view, {z, stage});
    said.fires = said.cells.empty() && said.conditions.empty();
    result.rules.push_back(std::move(said));
  }
  return result;
}

}  // namespace stig::rules
