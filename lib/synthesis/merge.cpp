// SPDX-License-Identifier: MIT
#include "synthesis/merge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/random.h"
#include "rules/rule_table.h"

namespace stig {
namespace {

/// One demand: cell `at` shows one of `states`.
struct Demand {
  std::size_t at = 0;
  StateSet states;
};

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
         const std::vector<LocalView>& views, const Deadline& deadline)
      : frame_(frame),
        size_(static_cast<std::size_t>(frame.neighbours().size)),
        colours_(colours),
        exact_(exact),
        views_(views),
        deadline_(deadline) {
    for (const LocalView& view : views_) {
      for (std::size_t i = 0; i < size_; ++i) ++of_colour_[view.wanted].showing[i][view.view.at[i]];
      for (std::size_t i = 0; i < size_; ++i) ++all_.showing[i][view.view.at[i]];
      ++of_colour_[view.wanted].views;
    }
  }

  std::vector<MergedRule> cover(const std::vector<std::size_t>& order) {
    rules_.clear();
    turns_.clear();
    covered_.assign(exact_.size(), false);
    for (const std::size_t seed : order) {
      if (!covered_[seed]) add(deadline_.passed() ? exactly(seed) : grow(seed));
    }
    leave_out_the_needless();
    return rules_;
  }

 private:
  struct Tally {
    std::array<std::array<std::uint32_t, 64>, kMaxNeighbours> showing{};
    std::size_t views = 0;
  };

  MergedRule exactly(std::size_t seed) const {
    MergedRule rule{{}, exact_[seed].place, exact_[seed].rank};
    for (std::size_t i = 0; i < size_; ++i) {
      rule.pattern.allowed[i] = StateSet::of(exact_[seed].view.at[i]);
    }
    return rule;
  }

  /// What may be asked of a cell so that the seed still matches.
  void for_each_demand(const View& seed, const auto& visit) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (is_brick(seed.at[i]) && colours_ > 1) visit(Demand{i, StateSet::bricks(colours_)});
      visit(Demand{i, StateSet::of(seed.at[i])});
    }
  }

  /// The gain of a demand that leaves p of p0 views to be matched and n of n0 others.
  static double gain(double p0, double n0, double p, double n) {
    return p * (std::log2(p / (p + n)) - std::log2(p0 / (p0 + n0)));
  }

  struct Active {
    std::vector<Positive> good;
    std::vector<const View*> bad;
    std::vector<const Pattern*> other;  ///< patterns that place another brick
  };

  Demand best_demand(const View& seed, const Pattern& pattern, const Active& active, bool untouched,
                     Colour place) const {
    Tally good, bad;
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
        n += untouched ? all_.showing[demand.at][s] - of_colour_[place].showing[demand.at][s]
                       : bad.showing[demand.at][s];
      }
      for (const Pattern* other : active.other) {
        n += (other->allowed[demand.at] & demand.states).none() ? 0 : 1;
      }
      if (n >= active.bad.size() + active.other.size()) return;  // tells nothing
      const double value = gain(p0, n0, p, n);
      if (value > most) {
        most = value;
        best = demand;
      }
    });
    return best;
  }

  MergedRule grow(std::size_t seed) const {
    const View& view = exact_[seed].view;
    MergedRule rule{{}, exact_[seed].place, exact_[seed].rank};
    Active active = all_active(rule.place);
    bool untouched = true;
    while (!active.bad.empty() || !active.other.empty()) {
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
    for (const LocalView& v : views_) {
      if (v.wanted != place) active.bad.push_back(&v.view);
    }
    for (const auto& [pattern, colour] : turns_) {
      if (colour != place) active.other.push_back(&pattern);
    }
    return active;
  }

  bool sound(const MergedRule& rule) const {
    for (const auto& [pattern, colour] : turns_) {
      if (colour != rule.place && overlap(pattern, rule.pattern, size_)) return false;
    }
    std::array<std::size_t, kMaxNeighbours> asked;
    std::size_t n = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (!(rule.pattern.allowed[i] == StateSet::anything())) asked[n++] = i;
    }
    return std::none_of(views_.begin(), views_.end(), [&](const LocalView& v) {
      if (v.wanted == rule.place) return false;
      for (std::size_t k = 0; k < n; ++k) {
        if (!rule.pattern.allowed[asked[k]].contains(v.view.at[asked[k]])) return false;
      }
      return true;
    });
  }

  /// Takes demands away, or asks for any brick instead of one, where that does no harm.
  void relax(MergedRule& rule) const {
    for (std::size_t i = size_; i-- > 0;) {
      const StateSet before = rule.pattern.allowed[i];
      if (before == StateSet::anything()) continue;
      rule.pattern.allowed[i] = StateSet::anything();
      if (sound(rule)) continue;
      rule.pattern.allowed[i] = before;
      if (!before.is_single() || !is_brick(before.first()) || colours_ == 1) continue;
      rule.pattern.allowed[i] = StateSet::bricks(colours_);
      if (!sound(rule)) rule.pattern.allowed[i] = before;
    }
  }

  bool covers(const MergedRule& rule, const ExactRule& exact) const {
    return rule.place == exact.place &&
           std::any_of(exact.images.begin(), exact.images.end(),
                       [&](const View& v) { return matches(rule.pattern, v, size_); });
  }

  void add(MergedRule rule) {
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

  void leave_out_the_needless() {
    std::vector<int> times(exact_.size(), 0);
    std::vector<std::vector<std::size_t>> covered_by(rules_.size());
    for (std::size_t k = 0; k < rules_.size(); ++k) {
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
  const std::vector<LocalView>& views_;
  Deadline deadline_;
  Tally all_;
  std::array<Tally, 64> of_colour_;
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
                                    const Deadline& deadline) {
  Merger merger(frame, colours, exact, views, deadline);
  std::vector<std::size_t> order(exact.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<MergedRule> best = merger.cover(order);
  for (int again = 1; again < restarts && !deadline.passed(); ++again) {
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

}  // namespace stig
