// SPDX-License-Identifier: MIT
// Covering by separate-and-conquer, after FOIL (J. R. Quinlan, "Learning logical
// definitions from relations", Machine Learning 5, 1990): take an exact rule that is not
// covered yet, add the most telling demand until no wrong view matches, take away demands
// that turn out to be needless, and count what else the pattern covers.
#include "synthesis/merge.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_set>

#include "base/random.h"
#include "rules/rule_table.h"
#include "synthesis/working_views.h"

namespace stig::synthesis {
namespace {

/// One demand: cell `at` shows one of `states`.
struct Demand {
  std::size_t at = 0;
  StateSet states;
};

/// Steps for looking at one view or pattern: at all its cells, at those asked for.
constexpr std::uint64_t kStepsOfTally = 10, kStepsOfAsking = 3;

struct Positive {
  const View* view;
  std::size_t rule;  ///< index of the exact rule
};

bool matches(const Pattern& pattern, const View& view, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    if (!pattern.allowed[i].contains(view.at[i])) return false;
  }
  return true;
}

bool overlap(const Pattern& a, const Pattern& b, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    if ((a.allowed[i] & b.allowed[i]).none()) return false;
  }
  return true;
}

class Merger {
 public:
  Merger(const Frame& frame, int colours, const std::vector<ExactRule>& exact,
         const std::vector<LocalView>& views, const Allowance& allowance)
      : frame_(frame),
        size_(static_cast<std::size_t>(frame.neighbours().size)),
        colours_(colours),
        exact_(exact),
        views_(views, size_),
        allowance_(allowance) {}

  std::vector<MergedRule> cover(const std::vector<std::size_t>& order) {
    rules_.clear();
    turns_.clear();
    covered_.assign(exact_.size(), false);
    for (const std::size_t seed : order) {
      if (covered_[seed]) continue;
      if (const auto rule = general(seed)) {
        add(*rule);
      } else {
        rules_.push_back(exactly(seed));
      }
    }
    leave_out_the_needless();
    return rules_;
  }

 private:
  /// A rule that covers the seed, and others with it; nothing when the allowance is spent.
  std::optional<MergedRule> general(std::size_t seed) {
    while (!allowance_.passed()) {
      MergedRule rule = grow(seed);
      if (!views_.add_violated(rule.pattern, rule.place, allowance_)) return rule;
    }
    return std::nullopt;
  }

  MergedRule exactly(std::size_t seed) const {
    MergedRule rule{{}, exact_[seed].place, exact_[seed].rank};
    for (std::size_t i = 0; i < size_; ++i) {
      rule.pattern.allowed[i] = StateSet::of(exact_[seed].view.at[i]);
    }
    return rule;
  }

  /// What may be asked of a cell so that the seed still matches. A demand is one state, or
  /// "any brick": intermediate sets would be hard to read in a drawing.
  void for_each_demand(const View& seed, const auto& visit) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (is_brick(seed.at[i]) && colours_ > 1) visit(Demand{i, StateSet::bricks(colours_)});
      visit(Demand{i, StateSet::of(seed.at[i])});
    }
  }

  /// The gain of a demand that leaves p of p0 views to be matched and n of n0 others.
  /// Information gain in bits, weighted by the views that remain matched.
  static double gain(double p0, double n0, double p, double n) {
    assert(p > 0);
    return p * (std::log2(p / (p + n)) - std::log2(p0 / (p0 + n0)));
  }

  struct Active {
    std::vector<Positive> good;
    std::vector<const View*> bad;
    std::vector<const Pattern*> other;  ///< patterns that place another brick
  };

  Demand best_demand(const View& seed, const Pattern& pattern, const Active& active, bool untouched,
                     Colour place) const {
    ViewTally good, bad;
    for (const Positive& p : active.good) {
      for (std::size_t i = 0; i < size_; ++i) ++good.showing[i][p.view->at[i]];
    }
    if (!untouched) {
      for (const View* v : active.bad) {
        for (std::size_t i = 0; i < size_; ++i) ++bad.showing[i][v->at[i]];
      }
    }
    const auto p0 = static_cast<double>(active.good.size());
    const auto n0 = static_cast<double>(active.bad.size() + active.other.size());
    Demand best;
    double most = -std::numeric_limits<double>::infinity();
    for_each_demand(seed, [&](const Demand& demand) {
      if (pattern.allowed[demand.at].subset_of(demand.states)) return;
      std::uint32_t p = 0, n = 0;
      for (State s = 0; s < 64; ++s) {
        if (!demand.states.contains(s)) continue;
        p += good.showing[demand.at][s];
        n += untouched ? views_.of_others(place, demand.at, s) : bad.showing[demand.at][s];
      }
      // Patterns for other bricks have to stay disjoint from this one, as `stigc check`
      // demands; they count like views.
      for (const Pattern* other : active.other) {
        n += (other->allowed[demand.at] & demand.states).none() ? 0 : 1;
      }
      if (n >= active.bad.size() + active.other.size()) return;  // tells nothing
      // Among demands that tell the same, those on faces are the plainest to read.
      const double value = gain(p0, n0, p, n) + (frame_.neighbours().is_face[demand.at] ? 1e-6 : 0);
      if (value > most) {
        most = value;
        best = demand;
      }
    });
    assert(most > -std::numeric_limits<double>::infinity());
    return best;
  }

  MergedRule grow(std::size_t seed) const {
    const View& view = exact_[seed].view;
    MergedRule rule{{}, exact_[seed].place, exact_[seed].rank};
    Active active = all_active(rule.place);
    bool untouched = true;
    while (!active.bad.empty() || !active.other.empty()) {
      allowance_.spend((active.good.size() + active.bad.size()) * kStepsOfTally +
                       active.other.size() * kStepsOfGlance * size_);
      const Demand demand = best_demand(view, rule.pattern, active, untouched, rule.place);
      untouched = false;
      rule.pattern.allowed[demand.at] = demand.states;
      const auto shows = [&](const View& v) { return demand.states.contains(v.at[demand.at]); };
      std::erase_if(active.good, [&](const Positive& p) { return !shows(*p.view); });
      std::erase_if(active.bad, [&](const View* v) { return !shows(*v); });
      std::erase_if(active.other, [&](const Pattern* p) {
        return (p->allowed[demand.at] & demand.states).none();
      });
    }
    relax(rule);
    return rule;
  }

  Active all_active(Colour place) const {
    Active active;
    for (std::size_t r = 0; r < exact_.size(); ++r) {
      if (covered_[r] || exact_[r].place != place) continue;
      for (const View& image : exact_[r].images) active.good.push_back({&image, r});
    }
    allowance_.spend((views_.all().size() + turns_.size()) * kStepsOfGlance);
    for (const LocalView& v : views_.all()) {
      if (v.wanted != place) active.bad.push_back(&v.view);
    }
    for (const auto& [pattern, colour] : turns_) {
      if (colour != place) active.other.push_back(&pattern);
    }
    return active;
  }

  /// Does the rule match no view where its brick does not belong, and overlap with no
  /// pattern that places another?
  bool sound(const MergedRule& rule) const {
    allowance_.spend((views_.all().size() + turns_.size()) * kStepsOfGlance);
    for (const auto& [pattern, colour] : turns_) {
      if (colour != rule.place && overlap(pattern, rule.pattern, size_)) return false;
    }
    const std::vector<std::size_t> asked = asked_cells(rule.pattern, size_);
    return std::none_of(views_.all().begin(), views_.all().end(), [&](const LocalView& v) {
      return v.wanted != rule.place && shows(v.view, asked, rule.pattern);
    });
  }

  /// Which demands keep out what must be kept out: for each view and pattern the set of
  /// those that do, sets that hold another left out. A pattern stays sound as long as every
  /// wrong view is kept out by some remaining demand, so relaxing is a hitting-set problem
  /// over these masks; minimal masks suffice.
  std::vector<std::uint32_t> keepers(const MergedRule& rule,
                                     const std::vector<std::size_t>& asked) const {
    allowance_.spend((views_.all().size() + turns_.size()) * kStepsOfAsking * asked.size());
    std::unordered_set<std::uint32_t> sets;
    for (const LocalView& v : views_.all()) {
      if (v.wanted == rule.place) continue;
      std::uint32_t set = 0;
      for (std::size_t k = 0; k < asked.size(); ++k) {
        if (!rule.pattern.allowed[asked[k]].contains(v.view.at[asked[k]])) set |= 1U << k;
      }
      sets.insert(set);
    }
    for (const auto& [pattern, colour] : turns_) {
      if (colour == rule.place) continue;
      std::uint32_t set = 0;
      for (std::size_t k = 0; k < asked.size(); ++k) {
        if ((rule.pattern.allowed[asked[k]] & pattern.allowed[asked[k]]).none()) set |= 1U << k;
      }
      sets.insert(set);
    }
    std::vector<std::uint32_t> sorted(sets.begin(), sets.end());
    std::sort(sorted.begin(), sorted.end(), [](std::uint32_t a, std::uint32_t b) {
      return std::pair(std::popcount(a), a) < std::pair(std::popcount(b), b);
    });
    std::vector<std::uint32_t> least;
    for (const std::uint32_t set : sorted) {
      if (std::none_of(least.begin(), least.end(),
                       [&](std::uint32_t l) { return (l & ~set) == 0; })) {
        least.push_back(set);
      }
    }
    return least;
  }

  /// Takes demands away, or asks for any brick instead of one, where that does no harm.
  void relax(MergedRule& rule) const {
    const std::vector<std::size_t> asked = asked_cells(rule.pattern, size_);
    const std::vector<std::uint32_t> sets = keepers(rule, asked);
    std::uint32_t kept = (1U << asked.size()) - 1;
    for (const std::size_t k : by_plainness(asked)) {
      const std::uint32_t without = kept & ~(1U << k);
      if (std::all_of(sets.begin(), sets.end(), [&](auto set) { return (set & without) != 0; })) {
        kept = without;
        rule.pattern.allowed[asked[k]] = StateSet::anything();
      }
    }
    for (std::size_t k = 0; k < asked.size() && colours_ > 1; ++k) {
      const StateSet before = rule.pattern.allowed[asked[k]];
      if (!before.is_single() || !is_brick(before.first())) continue;
      rule.pattern.allowed[asked[k]] = StateSet::bricks(colours_);
      if (!sound(rule)) rule.pattern.allowed[asked[k]] = before;
    }
  }

  /// Places in `asked`, the cells that readers can do without first: corners, edges, faces.
  std::vector<std::size_t> by_plainness(const std::vector<std::size_t>& asked) const {
    const Neighbourhood& n = frame_.neighbours();
    std::vector<std::size_t> places(asked.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    const auto weight = [&](std::size_t k) {
      return n.is_face[asked[k]] ? 2 : n.is_edge[asked[k]] ? 1 : 0;
    };
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return weight(a) < weight(b); });
    return places;
  }

  bool covers(const MergedRule& rule, const ExactRule& exact) const {
    return rule.place == exact.place &&
           std::any_of(exact.images.begin(), exact.images.end(),
                       [&](const View& v) { return matches(rule.pattern, v, size_); });
  }

  void add(MergedRule rule) {
    allowance_.spend(exact_.size() * frame_.group.size() * kStepsOfAsking);
    for (std::size_t r = 0; r < exact_.size(); ++r) {
      if (!covers(rule, exact_[r])) continue;
      covered_[r] = true;
      rule.rank = std::min(rule.rank, exact_[r].rank);
    }
    for (const Orientation& g : frame_.group) {
      turns_.emplace_back(oriented(rule.pattern, g, static_cast<int>(size_)), rule.place);
    }
    rules_.push_back(std::move(rule));
  }

  /// A rule is needless when each exact rule that it covers is covered by another that is
  /// kept.
  void leave_out_the_needless() {
    if (allowance_.out_of_time()) return;
    allowance_.spend(rules_.size() * exact_.size() * frame_.group.size() * kStepsOfAsking);
    std::vector<int> times(exact_.size(), 0);
    std::vector<std::vector<std::size_t>> covered_by(rules_.size());
    for (std::size_t k = 0; k < rules_.size(); ++k) {
      if (allowance_.out_of_time()) return;
      for (std::size_t r = 0; r < exact_.size(); ++r) {
        if (!covers(rules_[k], exact_[r])) continue;
        ++times[r];
        covered_by[k].push_back(r);
      }
    }
    std::vector<MergedRule> kept;
    for (std::size_t k = 0; k < rules_.size(); ++k) {
      const bool needless = std::all_of(covered_by[k].begin(), covered_by[k].end(),
                                        [&](std::size_t r) { return times[r] > 1; });
      if (!needless) {
        kept.push_back(rules_[k]);
        continue;
      }
      for (const std::size_t r : covered_by[k]) --times[r];
    }
    rules_ = std::move(kept);
  }

  const Frame& frame_;
  std::size_t size_;
  int colours_;
  const std::vector<ExactRule>& exact_;
  WorkingViews views_;
  Allowance allowance_;
  std::vector<bool> covered_;
  std::vector<MergedRule> rules_;
  std::vector<std::pair<Pattern, Colour>> turns_;
};

void sort_by_rank(std::vector<MergedRule>& rules) {
  std::stable_sort(rules.begin(), rules.end(),
                   [](const MergedRule& a, const MergedRule& b) { return a.rank < b.rank; });
}

}  // namespace

std::vector<MergedRule> as_patterns(const Frame& frame, const std::vector<ExactRule>& exact) {
  std::vector<MergedRule> rules;
  for (const ExactRule& e : exact) {
    MergedRule rule{{}, e.place, e.rank};
    for (std::size_t i = 0; i < static_cast<std::size_t>(frame.neighbours().size); ++i) {
      rule.pattern.allowed[i] = StateSet::of(e.view.at[i]);
    }
    rules.push_back(rule);
  }
  return rules;
}

std::vector<MergedRule> merge_rules(const Frame& frame, int colours,
                                    const std::vector<ExactRule>& exact,
                                    const std::vector<LocalView>& views, int restarts,
                                    const Allowance& allowance) {
  assert(colours > 0);
  Merger merger(frame, colours, exact, views, allowance);
  std::vector<std::size_t> order(exact.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<MergedRule> best = merger.cover(order);
  // Covers depend on the order in which seeds are taken; random orders are drawn from fixed
  // seeds.
  for (int again = 1; again < restarts && !allowance.passed(); ++again) {
    Random random(1, static_cast<std::uint32_t>(again), Purpose::order, 0, 0);
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[random.below(i)]);
    }
    std::vector<MergedRule> rules = merger.cover(order);
    if (rules.size() < best.size()) best = std::move(rules);
  }
  sort_by_rank(best);
  return best;
}

}  // namespace stig::synthesis
