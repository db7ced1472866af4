// SPDX-License-Identifier: MIT
#include "synthesis/synthesise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <set>

#include "base/hash.h"
#include "synthesis/check_rules.h"
#include "synthesis/emit.h"
#include "synthesis/proof_files.h"
#include "synthesis/reasons.h"

namespace stig {
namespace {

/// Shares of the budget.
constexpr double kLooking = 0.15, kColouring = 0.75;
/// Seconds for one question to the solver, round by round, in shares of the budget.
constexpr std::array<double, 3> kSlices = {0.015, 0.06, 0.25};
/// Below this many orbits every order is tried.
constexpr std::size_t kFewOrbits = 8, kMostOrders = 1000;
constexpr std::size_t kMostSolutions = 64;
constexpr int kRestarts = 8;

/// An order of a frame that may do, and how many colours it needs at least.
struct Candidate {
  std::size_t frame = 0;
  std::function<Order(const Frame&)> make;
  int at_least = 1;
  std::size_t states = 0;
  int refuted = 0;  ///< so many colours do not do
};

std::uint64_t hash_of(const Schedule& schedule) {
  std::uint64_t h = 0;
  for (const std::uint32_t mask : schedule.before) h = combine(h, mask);
  for (const std::uint32_t mask : schedule.beside) h = combine(h, mask);
  return h;
}

class Synthesiser {
 public:
  Synthesiser(const Target& target, const SynthesisOptions& options, const SynthesisHooks& hooks)
      : target_(target),
        options_(options),
        hooks_(hooks),
        named_(static_cast<int>(target.bricks.size())),
        whole_(Deadline::after(options.seconds, hooks.stop)) {}

  Synthesis run(const std::vector<std::vector<Cell>>& starts) {
    const auto began = std::chrono::steady_clock::now();
    for (const std::vector<Cell>& start : starts) {
      frames_.push_back(
          std::make_shared<Frame>(make_frame(target_, {start, options_.symmetry, options_.floor})));
    }
    look_at_orders();
    colour();
    finish();
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return std::move(result_);
  }

 private:
  void tell(double fraction, const std::string& what) {
    if (hooks_.progress) hooks_.progress(fraction, what);
  }

  /// Which orders can be used at all, and the fewest colours each might do with.
  void look_at_orders() {
    const Deadline looking = whole_.within(options_.seconds * kLooking);
    std::set<std::uint64_t> seen;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      if (frames_[f]->orbits.size() > kFewOrbits + 1 || options_.family) continue;
      for (Order& order : all_orders(*frames_[f], kMostOrders)) {
        look_at(
            f, [order](const Frame&) { return order; }, seen);
      }
    }
    for (const OrderPlan& plan : order_plans()) {
      if (options_.family && plan.family != *options_.family) continue;
      for (std::size_t f = 0; f < frames_.size(); ++f) {
        if (looking.passed() && !candidates_.empty()) break;
        look_at(f, plan.make, seen);
      }
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const auto& a, const auto& b) { return a.at_least < b.at_least; });
  }

  void look_at(std::size_t f, const std::function<Order(const Frame&)>& make,
               std::set<std::uint64_t>& seen) {
    if (whole_.passed()) return;
    BadOrder bad;
    const std::optional<Schedule> schedule =
        make_schedule(*frames_[f], make(*frames_[f]), bad, limits());
    if (!schedule || !seen.insert(combine(f, hash_of(*schedule))).second) return;
    ++result_.orders_tried;
    const ColouringSearch search(*schedule, named_);
    tell(0, fmt::format("{} orders looked at", result_.orders_tried));
    if (search.differences().hopeless()) {
      if (!hopeless_) {
        hopeless_ = describe_look_alikes(*schedule, *search.differences().hopeless(), target_);
      }
      return;
    }
    candidates_.push_back({f, make, search.at_least(), schedule->states.masks.size(), 0});
  }

  ScheduleLimits limits() const {
    ScheduleLimits limits;
    if (options_.strict_only) limits.keys_of_site = options_.symmetry == Symmetry::none ? 1 : 256;
    return limits;
  }

  void colour() {
    const Deadline colouring = whole_.within(options_.seconds * kColouring);
    for (const double slice : kSlices) {
      for (Candidate& candidate : candidates_) {
        if (colouring.passed()) return;
        if (candidate.at_least > most_wanted()) break;
        try_candidate(candidate, slice * options_.seconds, colouring);
      }
    }
  }

  /// No more colours than this are of interest now.
  int most_wanted() const {
    if (best_ == 0) return options_.most_colours;
    return options_.fewest == Fewest::rules ? std::min(options_.most_colours, best_ + 8)
                                            : best_ - (solutions_.size() < 8 ? 0 : 1);
  }

  void try_candidate(Candidate& candidate, double slice, const Deadline& deadline) {
    if (solutions_.size() >= kMostSolutions) return;
    const Frame& frame = *frames_[candidate.frame];
    BadOrder bad;
    const std::optional<Schedule> schedule =
        make_schedule(frame, candidate.make(frame), bad, limits());
    assert(schedule);
    ColouringSearch search(*schedule, named_);
    Colouring colours;
    for (int k = std::max(candidate.at_least, candidate.refuted + 1); k <= most_wanted(); ++k) {
      if (deadline.passed()) return;
      ColouringLimits limits{deadline.within(slice), {}};
      limits.progress = [&](int n, int rounds) {
        tell(0, fmt::format("{}: {} colours, round {}", schedule->order.name, n, rounds));
      };
      const Answered answered = search.colour(k, limits, colours);
      if (answered == Answered::no) candidate.refuted = k;
      if (answered == Answered::yes) {
        keep(candidate, *schedule, colours, k);
        return;
      }
      if (search.differences().hopeless()) {
        candidate.at_least = kMaxColours + 1;
        if (!hopeless_) {
          hopeless_ = describe_look_alikes(*schedule, *search.differences().hopeless(), target_);
        }
        return;
      }
    }
  }

  void keep(Candidate& candidate, const Schedule& schedule, const Colouring& colours, int k) {
    Solution solution;
    solution.frame = frames_[candidate.frame];
    solution.order = schedule.order;
    solution.colours = colours;
    solution.colour_count = k;
    solution.fewer_refuted = candidate.refuted == k - 1 || candidate.at_least == k;
    solution.exact_rules = exact_rules(schedule, colours).size();
    if (best_ == 0 || k < best_) best_ = k;
    candidate.at_least = std::max(candidate.at_least, k);
    solutions_.push_back(std::move(solution));
  }

  /// Rules for the most promising solutions of each number of colours.
  void finish() {
    std::stable_sort(solutions_.begin(), solutions_.end(), [](const auto& a, const auto& b) {
      return std::pair(a.colour_count, a.exact_rules) < std::pair(b.colour_count, b.exact_rules);
    });
    std::map<int, int> merged;
    std::vector<Solution> done;
    for (Solution& solution : solutions_) {
      if (!done.empty() && (whole_.passed() || merged[solution.colour_count] >= 3)) continue;
      ++merged[solution.colour_count];
      tell(0.9, fmt::format("{} colours: merging {} exact rules", solution.colour_count,
                            solution.exact_rules));
      make_rules(solution);
      done.push_back(std::move(solution));
    }
    choose(std::move(done));
    if (result_.best) return;
    if (candidates_.empty() && hopeless_) {
      result_.impossible = std::move(hopeless_);
    } else {
      explain_failure();
    }
  }

  void make_rules(Solution& solution) {
    BadOrder bad;
    const std::optional<Schedule> schedule =
        make_schedule(*solution.frame, solution.order, bad, limits());
    assert(schedule);
    const auto exact = exact_rules(*schedule, solution.colours);
    if (options_.merge) {
      const auto views = local_views(*schedule, solution.colours);
      solution.rules = merge_rules(*solution.frame, solution.colour_count, exact, views, kRestarts,
                                   whole_.within(options_.seconds * 0.1));
    } else {
      solution.rules = as_patterns(*solution.frame, exact);
    }
    const RuleSet rules = make_rule_set(*solution.frame, solution.colours, solution.colour_count,
                                        target_.bricks, solution.rules, {});
    [[maybe_unused]] const auto fault = find_fault(*schedule, solution.colours, rules);
    assert(!fault);
  }

  void choose(std::vector<Solution> done) {
    const auto better = [&](const Solution& a, const Solution& b) {
      const std::pair ka(static_cast<std::size_t>(a.colour_count), a.rules.size());
      const std::pair kb(static_cast<std::size_t>(b.colour_count), b.rules.size());
      if (options_.fewest == Fewest::colours) return ka < kb;
      return std::pair(ka.second, ka.first) < std::pair(kb.second, kb.first);
    };
    std::stable_sort(done.begin(), done.end(), better);
    std::vector<Solution> front;
    for (Solution& s : done) {
      const bool worse = std::any_of(front.begin(), front.end(), [&](const Solution& f) {
        return f.colour_count <= s.colour_count && f.rules.size() <= s.rules.size();
      });
      if (!worse) front.push_back(std::move(s));
    }
    if (front.empty()) return;
    result_.best = std::move(front.front());
    result_.others.assign(std::make_move_iterator(front.begin() + 1),
                          std::make_move_iterator(front.end()));
  }

  void explain_failure() {
    const bool all_refuted =
        std::all_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) {
          return c.at_least > options_.most_colours || c.refuted >= options_.most_colours;
        });
    if (!all_refuted) {
      result_.out_of_time = true;
    } else if (hopeless_) {
      result_.impossible = std::move(hopeless_);
    } else {
      int least = kMaxColours;
      for (const Candidate& c : candidates_)
        least = std::min(least, std::max(c.at_least, c.refuted + 1));
      result_.impossible = describe_few_colours(options_.most_colours, least, result_.orders_tried);
    }
  }

  const Target& target_;
  const SynthesisOptions& options_;
  const SynthesisHooks& hooks_;
  int named_;
  Deadline whole_;
  std::vector<std::shared_ptr<const Frame>> frames_;
  std::vector<Candidate> candidates_;
  std::vector<Solution> solutions_;
  int best_ = 0;
  std::optional<Impossible> hopeless_;
  Synthesis result_;
};

}  // namespace

Synthesis synthesise(const Target& target, const SynthesisOptions& options,
                     const SynthesisHooks& hooks) {
  std::vector<std::vector<Cell>> starts;
  if (options.start.empty()) {
    starts = likely_starts(target, options.symmetry, options.floor);
  } else {
    starts.push_back(options.start);
  }
  Synthesis result;
  std::optional<Impossible> problem;
  std::erase_if(starts, [&](const std::vector<Cell>& start) {
    std::optional<Impossible> found =
        find_obstacle(target, {start, options.symmetry, options.floor});
    const bool bad = found.has_value();
    if (bad && !problem) problem = std::move(found);
    return bad;
  });
  if (starts.empty()) {
    result.impossible = std::move(problem);
    return result;
  }
  return Synthesiser(target, options, hooks).run(starts);
}

std::vector<std::vector<Cell>> likely_starts(const Target& target, Symmetry symmetry, bool) {
  Cell low = target.cells.front(), high = low;
  for (const Cell c : target.cells) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  std::vector<std::vector<Cell>> starts;
  if (symmetry != Symmetry::none) {
    // The cells on the axis, or nearest to it, level by level from the lowest.
    for (std::int32_t z = low.z; z <= high.z && starts.empty(); ++z) {
      std::vector<Cell> middle;
      for (std::int32_t x = (low.x + high.x) >> 1; x <= (low.x + high.x + 1) >> 1; ++x) {
        for (std::int32_t y = (low.y + high.y) >> 1; y <= (low.y + high.y + 1) >> 1; ++y) {
          if (index_in(target.cells, {x, y, z}) >= 0) middle.push_back({x, y, z});
        }
      }
      if (!middle.empty()) starts.push_back(middle);
    }
    if (starts.empty()) starts.push_back({target.cells.front()});
    return starts;
  }
  const auto by = [&](const auto& key) {
    return *std::min_element(target.cells.begin(), target.cells.end(),
                             [&](Cell a, Cell b) { return key(a) < key(b); });
  };
  const auto add = [&](Cell c) {
    const std::vector<Cell> start{c};
    if (std::find(starts.begin(), starts.end(), start) == starts.end()) starts.push_back(start);
  };
  add(by([](Cell c) { return std::array{c.z, c.y, c.x}; }));
  const auto from_middle = [&](Cell c) {
    return std::abs(2 * c.x - low.x - high.x) + std::abs(2 * c.y - low.y - high.y);
  };
  add(by([&](Cell c) { return std::array{c.z, from_middle(c), c.y, c.x}; }));
  return starts;
}

std::optional<MinimalityProof> prove_fewest(const Solution& solution, int named,
                                            const Deadline& deadline) {
  const int k = solution.colour_count - 1;
  if (k < 1) return std::nullopt;
  BadOrder bad;
  const std::optional<Schedule> schedule = make_schedule(*solution.frame, solution.order, bad);
  assert(schedule);
  ColouringSearch search(*schedule, named);
  Colouring colours;
  if (search.colour(k, {deadline, {}}, colours) != Answered::no) return std::nullopt;
  std::optional<Refutation> refutation = refute(search, named, k, deadline);
  if (!refutation) return std::nullopt;
  return MinimalityProof{print_problem(*schedule, named, k), std::move(refutation->cnf),
                         std::move(refutation->drat)};
}

}  // namespace stig
