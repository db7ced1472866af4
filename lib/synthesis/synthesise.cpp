// SPDX-License-Identifier: MIT
#include "synthesis/synthesise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <tuple>

#include "base/hash.h"
#include "synthesis/check_rules.h"
#include "synthesis/emit.h"
#include "synthesis/hints.h"
#include "synthesis/order_search.h"
#include "synthesis/reasons.h"

namespace stig {
namespace {

/// When, in shares of the budget, each part of the search is to end. The rest is for
/// merging.
constexpr double kLooking = 0.15, kLookingLarge = 0.05, kGathering = 0.5, kGatheringLarge = 0.6,
                 kGatheringAgain = 0.75, kMergingMany = 0.85;
constexpr std::array<double, 3> kDiscovering = {0.35, 0.6, 0.7};
/// For one question to the solver, round by round …
constexpr std::array<double, 3> kSlices = {0.02, 0.05, 0.15};
/// … and at least so many times what it took to set the question; and for more of what
/// was found, so many times what the quickest answer took.
constexpr double kSliceOfMaking = 20, kSliceOfSuccess = 10;
/// The number of colours asked for first, before any is known to do.
constexpr int kFirstColours = 6;
/// Looking for few rules, so many colours more than needed are tried.
constexpr int kMoreColours = 4;
/// Orders from which a search among orders begins.
constexpr std::size_t kBeginnings = 24;
/// Below this many orbits every order is tried.
constexpr std::size_t kFewOrbits = 8, kMostOrders = 1000;
constexpr std::size_t kManyOrbits = 1500;
/// More rules than this hardly fit a file (kMaxRuleFileBytes).
constexpr std::size_t kMostRules = 5000;
constexpr std::size_t kMostSolutions = 1000;
constexpr int kRestarts = 30;
/// Solutions of one number of colours that are merged; more as long as it goes quickly.
constexpr int kMergedOfEach = 3;
constexpr double kMergingQuick = 0.03;

/// An order of a frame that may do, and how many colours it needs at least.
struct Candidate {
  std::size_t frame = 0;
  std::function<Order(const Frame&)> make;
  int at_least = 1;
  bool with_ties = false;
  int refuted = 0;  ///< so many colours do not do
  int least() const { return std::max(at_least, refuted + 1); }
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
        began_(std::chrono::steady_clock::now()),
        whole_(share(1)) {}

  Synthesis run(const std::vector<std::vector<Cell>>& starts) {
    for (const std::vector<Cell>& start : starts) {
      frames_.push_back(
          std::make_shared<Frame>(make_frame(target_, {start, options_.symmetry, options_.floor})));
    }
    look_at_orders();
    colour();
    finish();
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    return std::move(result_);
  }

 private:
  void tell(double fraction, const std::string& what) {
    if (hooks_.progress) hooks_.progress(fraction, what);
  }

  /// Which orders can be used at all, and the fewest colours each might do with.
  void look_at_orders() {
    const Deadline looking = share(large() ? kLookingLarge : kLooking);
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

  /// Is every colour given, so that an order is right or wrong without a solver?
  bool all_given() const {
    return std::all_of(target_.colours.begin(), target_.colours.end(),
                       [](StateSet colours) { return colours.is_single(); });
  }

  void search_for_orders(std::set<std::uint64_t>& seen) {
    tell(0, "searching among orders");
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const double end = kLooking + (kDiscovering.back() - kLooking) * static_cast<double>(f + 1) /
                                        static_cast<double>(frames_.size());
      std::vector<Order> first;
      for (const OrderPlan& plan : order_plans()) {
        if (first.size() < kBeginnings) first.push_back(plan.make(*frames_[f]));
      }
      OrderSearch found = search_orders(*frames_[f], given_colours(f), first, share(end));
      result_.orders_tried += found.tried;
      if (found.order) {
        look_at(
            f, [order = *found.order](const Frame&) { return order; }, seen);
      } else if (found.clash) {
        hopeless_ = describe_look_alikes(*found.nearest, *found.clash, target_);
      }
    }
  }

  Colouring given_colours(std::size_t f) const {
    Colouring colours;
    for (const Orbit& orbit : frames_[f]->orbits) colours.push_back(orbit.colours.first());
    return colours;
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
    if (all_given()) {
      const auto clashes = find_clashes(*schedule, given_colours(f), 1, 1);
      if (!clashes.empty()) {
        if (!hopeless_) hopeless_ = describe_look_alikes(*schedule, clashes.front(), target_);
        return;
      }
    }
    if (search.differences().hopeless()) {
      if (!hopeless_) {
        hopeless_ = describe_look_alikes(*schedule, *search.differences().hopeless(), target_);
      }
      return;
    }
    candidates_.push_back(
        {f, make, search.at_least(), schedule->keys.size() > 2 * frames_[f]->orbits.size(), 0});
  }

  ScheduleLimits limits() const {
    ScheduleLimits limits;
    if (options_.strict_only) limits.keys_of_site = options_.symmetry == Symmetry::none ? 1 : 256;
    return limits;
  }

  void colour() {
    discover(0);
    gather(large() ? kGatheringLarge : kGathering);
    const int before = best_;
    if (large() && best_ != 0) return;
    for (std::size_t round = 1; round < kSlices.size(); ++round) discover(round);
    if (best_ != before) gather(kGatheringAgain);
  }

  /// With large targets the time is better spent on few rules than on the last colour.
  bool large() const { return frames_.front()->orbits.size() > kManyOrbits; }

  Deadline share(double share) const {
    return Deadline{began_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                 std::chrono::duration<double>(options_.seconds * share)),
                    hooks_.stop};
  }

  /// Goes through the orders for fewer colours than any before has done with.
  void discover(std::size_t round) {
    const Deadline deadline = share(large() && best_ == 0 ? kGathering : kDiscovering[round]);
    for (Candidate& candidate : candidates_) {
      if (deadline.passed() || (large() && best_ != 0)) return;
      const int most = best_ == 0 ? options_.most_colours : best_ - 1;
      if (candidate.least() > most) continue;
      const auto began = std::chrono::steady_clock::now();
      const Schedule schedule = schedule_of(candidate);
      ColouringSearch search(schedule, named_);
      const std::chrono::duration<double> making = std::chrono::steady_clock::now() - began;
      const double slice = std::max(kSlices[large() ? 2 : round] * options_.seconds,
                                    kSliceOfMaking * making.count());
      halve(search, candidate, most, slice, deadline);
    }
  }

  /// The fewest colours of an order, up to `most`: by halving, a slice of time for each
  /// question. What is not answered in time counts as no, but is not remembered so.
  void halve(ColouringSearch& search, Candidate& candidate, int most, double slice,
             const Deadline& deadline) {
    int low = candidate.least();
    int high = std::min(most, std::max(low, kFirstColours));
    // More and more until so many do, then halve.
    while (high < most &&
           ask(search, candidate, high, slice, deadline, Hint::random) != Answered::yes) {
      if (given_up(search, candidate) || deadline.passed()) return;
      low = high + 1;
      high = std::min(most, 4 * high);
    }
    while (low <= high && !deadline.passed()) {
      const int k = best_ == 0 || high == most ? high : low + (high - low) / 2;
      if (ask(search, candidate, k, slice, deadline, Hint::random) == Answered::yes) {
        high = k - 1;
        most = kMaxColours;  // from now on in halves
        if (large()) return;
      } else {
        if (given_up(search, candidate) || k == most) return;
        low = k + 1;
      }
    }
  }

  /// Other solutions with as many colours: the more regular, the fewer rules.
  void gather(double until) {
    const Deadline deadline = share(until);
    const int more = options_.fewest == Fewest::rules || large() ? kMoreColours : 0;
    for (Candidate& candidate : candidates_) {
      if (best_ == 0 || solutions_.size() >= kMostSolutions) return;
      if (candidate.least() > best_ + more) continue;
      const Schedule schedule = schedule_of(candidate);
      ColouringSearch search(schedule, named_);
      for (int k = std::max(best_ + (large() ? 2 : 0), candidate.least());
           k <= std::min(best_ + more, options_.most_colours); k += large() ? 2 : 1) {
        for (const Hint hint : {Hint::depth, Hint::distance, Hint::uniform}) {
          if (deadline.passed()) return;
          if (large() && hint != Hint::depth) break;
          const double slice = kSliceOfSuccess * fastest_;
          if (ask(search, candidate, k, slice, deadline, hint) != Answered::yes) break;
        }
      }
    }
  }

  Schedule schedule_of(const Candidate& candidate) const {
    const Frame& frame = *frames_[candidate.frame];
    BadOrder bad;
    std::optional<Schedule> schedule = make_schedule(frame, candidate.make(frame), bad, limits());
    assert(schedule);
    return std::move(*schedule);
  }

  /// One question to the solver.
  Answered ask(ColouringSearch& search, Candidate& candidate, int k, double slice,
               const Deadline& deadline, Hint hint) {
    const Schedule& schedule = search.differences().schedule();
    ColouringLimits limits{deadline.within(slice), {}};
    limits.progress = [&](int n, int rounds) {
      tell(0, fmt::format("{}: {} colours, round {}", schedule.order.name, n, rounds));
    };
    const auto began = std::chrono::steady_clock::now();
    Colouring colours = hint_of(*schedule.frame, hint, k);
    const Answered answered = search.colour(k, limits, colours);
    if (answered == Answered::no) candidate.refuted = std::max(candidate.refuted, k);
    if (answered == Answered::yes) {
      keep(candidate, schedule, colours, k);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
      fastest_ = fastest_ == 0 ? took.count() : std::min(fastest_, took.count());
    }
    return answered;
  }

  /// Has it turned out that no colours do for this order?
  bool given_up(const ColouringSearch& search, Candidate& candidate) {
    if (!search.differences().hopeless()) return false;
    candidate.refuted = kMaxColours;
    if (!hopeless_) {
      hopeless_ = describe_look_alikes(search.differences().schedule(),
                                       *search.differences().hopeless(), target_);
    }
    return true;
  }

  void keep(Candidate& candidate, const Schedule& schedule, const Colouring& colours, int k) {
    Solution solution;
    solution.frame = frames_[candidate.frame];
    solution.order = schedule.order;
    solution.colours = colours;
    solution.colour_count = k;
    solution.fewer_refuted = candidate.least() == k;
    solution.exact_rules = exact_rules(schedule, colours).size();
    if (best_ == 0 || k < best_) best_ = k;
    solutions_.push_back(std::move(solution));
  }

  /// Rules for the most promising solutions of each number of colours; then, for the
  /// one that is best, as few as can be had in the time that is left.
  void finish() {
    std::stable_sort(solutions_.begin(), solutions_.end(), [](const auto& a, const auto& b) {
      return std::tuple(a.exact_rules > kMostRules, a.colour_count, a.exact_rules) <
             std::tuple(b.exact_rules > kMostRules, b.colour_count, b.exact_rules);
    });
    const Deadline many = share(kMergingMany),
                   quick = many.within(options_.seconds * kMergingQuick);
    std::map<int, int> merged;
    std::vector<Solution> done;
    for (Solution& solution : solutions_) {
      const bool enough = merged[solution.colour_count] >= kMergedOfEach && quick.passed();
      if (!done.empty() && (many.passed() || enough)) continue;
      ++merged[solution.colour_count];
      tell(0.9, fmt::format("{} colours: merging {} exact rules", solution.colour_count,
                            solution.exact_rules));
      make_rules(solution, 1);
      done.push_back(std::move(solution));
    }
    choose(std::move(done));
    if (result_.best) {
      if (!whole_.passed()) make_rules(*result_.best, kRestarts);
      return;
    }
    if (candidates_.empty() && hopeless_) {
      result_.impossible = std::move(hopeless_);
    } else {
      explain_failure();
    }
  }

  void make_rules(Solution& solution, int restarts) {
    BadOrder bad;
    const std::optional<Schedule> schedule =
        make_schedule(*solution.frame, solution.order, bad, limits());
    assert(schedule);
    const auto exact = exact_rules(*schedule, solution.colours);
    if (options_.merge) {
      const auto views = local_views(*schedule, solution.colours);
      std::vector<MergedRule> rules =
          merge_rules(*solution.frame, solution.colour_count, exact, views, restarts, whole_);
      if (solution.rules.empty() || rules.size() < solution.rules.size()) {
        solution.rules = std::move(rules);
      }
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
      const bool a_large = a.rules.size() > kMostRules, b_large = b.rules.size() > kMostRules;
      if (a_large != b_large) return b_large;
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
        std::all_of(candidates_.begin(), candidates_.end(),
                    [&](const Candidate& c) { return c.least() > options_.most_colours; });
    if (!all_refuted) {
      result_.out_of_time = true;
    } else if (hopeless_) {
      result_.impossible = std::move(hopeless_);
    } else {
      const auto easiest =
          std::min_element(candidates_.begin(), candidates_.end(),
                           [](const auto& a, const auto& b) { return a.least() < b.least(); });
      const Schedule schedule = schedule_of(*easiest);
      result_.impossible =
          describe_few_colours(schedule, named_, options_.most_colours, easiest->least(),
                               result_.orders_tried, whole_.within(options_.seconds * 0.1));
    }
  }

  const Target& target_;
  const SynthesisOptions& options_;
  const SynthesisHooks& hooks_;
  int named_;
  std::chrono::steady_clock::time_point began_;
  Deadline whole_;
  std::vector<std::shared_ptr<const Frame>> frames_;
  std::vector<Candidate> candidates_;
  std::vector<Solution> solutions_;
  int best_ = 0;        ///< fewest colours so far; 0: none
  double fastest_ = 0;  ///< seconds of the quickest solution; 0: none
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

}  // namespace stig
