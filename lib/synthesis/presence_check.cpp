// SPDX-License-Identifier: MIT
// The check of docs/synthesis.md for rules that ask only for presence: linear in cells x
// rules, without local states, and so fit for solids of any size. Soundness rests on
// monotonicity: what matches goes on matching as the structure grows, so it is enough to
// look at the whole target once and to follow one order of growth.
#include "synthesis/presence_check.h"

#include <algorithm>
#include <cassert>

namespace stig::synthesis {
namespace {

/// Steps of asking one rule at one site.
constexpr std::uint64_t kStepsOfRule = 8;

/// What a rule asks of one neighbour.
struct Asked {
  std::size_t at;
  StateSet states;
  bool may_be_empty;
};

struct AskingRule {
  std::vector<Asked> asked;
  Colour place;
  std::int32_t low, high;
};

AskingRule asking(const MergedRule& merged, std::size_t neighbours) {
  AskingRule rule{{},
                  merged.place,
                  merged.height_min.value_or(std::numeric_limits<std::int32_t>::min()),
                  merged.height_max.value_or(std::numeric_limits<std::int32_t>::max())};
  for (std::size_t i = 0; i < neighbours; ++i) {
    const StateSet states = merged.pattern.allowed[i];
    if (states == StateSet::anything()) continue;
    rule.asked.push_back({i, states, states.contains(kEmpty)});
  }
  return rule;
}

/// Is what must not be there taken as absent, or compared with the finished target? For "nothing
/// wrong is ever placed" an absence is granted, since the cell may still be empty; for
/// "this can be placed" it must hold in the finished target.
enum class Absences : std::uint8_t { granted, compared };

class GrowthCheck {
 public:
  GrowthCheck(const SolidGrid& grid, const PlaceColours& colours, std::int32_t start,
              const std::vector<MergedRule>& rules, const Allowance& allowance)
      : grid_(grid), colours_(colours), start_(start), allowance_(allowance) {
    assert(colours.size() == grid.solid.size());
    for (const MergedRule& rule : rules) rules_.push_back(asking(rule, grid.step.size()));
  }

  /// What follows from the start.
  void follow() {
    placed_.assign(grid_.solid.size(), 0);
    order_ = {start_};
    placed_[static_cast<std::size_t>(start_)] = 1;
    for (std::size_t next = 0; next < order_.size() && !allowance_.passed(); ++next) {
      allowance_.spend(grid_.step.size() * rules_.size() * kStepsOfRule);
      // Neighbours of the newest brick are the only sites whose view has changed.
      for (const std::int32_t step : grid_.step) {
        const std::int32_t site = order_[next] - step;
        if (!grid_.is_solid(site) || has(site) || !any_rule(site)) continue;
        placed_[static_cast<std::size_t>(site)] = 1;
        order_.push_back(site);
      }
    }
  }

  bool never_wrong() {
    for (const auto* sites : {&grid_.beside, &grid_.cells}) {
      for (const std::int32_t site : *sites) {
        if (site != start_ && wrong_at(site)) return false;
      }
    }
    return !allowance_.passed();
  }

  const std::vector<std::int32_t>& order() const { return order_; }

 private:
  bool has(std::int32_t at) const { return placed_[static_cast<std::size_t>(at)] != 0; }
  Colour colour(std::int32_t at) const { return colours_[static_cast<std::size_t>(at)]; }

  bool matches(const AskingRule& rule, std::int32_t site, Absences absences, bool whole) const {
    const std::int32_t z = grid_.height(site);
    if (z < rule.low || z > rule.high) return false;
    return std::all_of(rule.asked.begin(), rule.asked.end(), [&](const Asked& asked) {
      const std::int32_t there = site + grid_.step[asked.at];
      const bool right = asked.states.contains(colour(there));
      if (asked.may_be_empty) return absences == Absences::granted || right;
      return right && (whole || has(there));
    });
  }

  bool any_rule(std::int32_t site) const {
    return std::any_of(rules_.begin(), rules_.end(), [&](const AskingRule& rule) {
      return rule.place == colour(site) && matches(rule, site, Absences::compared, false);
    });
  }

  /// Does a rule place a wrong brick here when all of the target is around it?
  bool wrong_at(std::int32_t site) const {
    allowance_.spend(rules_.size() * kStepsOfRule);
    return std::any_of(rules_.begin(), rules_.end(), [&](const AskingRule& rule) {
      return rule.place != colour(site) && matches(rule, site, Absences::granted, true);
    });
  }

  const SolidGrid& grid_;
  const PlaceColours& colours_;
  std::int32_t start_;
  Allowance allowance_;
  std::vector<AskingRule> rules_;
  std::vector<std::uint8_t> placed_;
  std::vector<std::int32_t> order_;
};

}  // namespace

std::optional<std::vector<std::int32_t>> order_of_growth(const SolidGrid& grid,
                                                         const PlaceColours& colours,
                                                         std::int32_t start,
                                                         const std::vector<MergedRule>& rules,
                                                         const Allowance& allowance) {
  assert(grid.is_solid(start));
  GrowthCheck check(grid, colours, start, rules, allowance);
  if (!check.never_wrong()) return std::nullopt;
  check.follow();
  if (check.order().size() != grid.cells.size() || allowance.passed()) return std::nullopt;
  return check.order();
}

}  // namespace stig::synthesis
