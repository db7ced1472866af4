// SPDX-License-Identifier: MIT
// The search for a rule set, by shares of one effort: a skeleton first, then orders, then
// colours (few questions to the solver for every order, then longer ones for the orders
// that remain), then more solutions with as many colours, then merging. All limits are
// counted work, so the same input gives the same result; only the deadline depends on the
// machine, and `cut_short` says when it did.
#include "synthesis/synthesise.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "synthesis/best_rules.h"
#include "synthesis/by_skeleton.h"
#include "synthesis/candidates.h"
#include "synthesis/effort.h"
#include "synthesis/hints.h"
#include "synthesis/reasons.h"

namespace stig::synthesis {
namespace {

/// When, in shares of the effort, each part of the search is to end. The rest is for
/// merging.
constexpr double kSkeleton = 0.1, kLooking = 0.15, kLookingLarge = 0.05, kGathering = 0.5,
                 kGatheringLarge = 0.6, kGatheringAgain = 0.75, kMergingMany = 0.85,
                 kMergingQuick = 0.03, kExplaining = 0.1;
constexpr std::array<double, 3> kDiscovering = {0.35, 0.6, 0.7};
/// For one question to the solver, round by round …
constexpr std::array<double, 3> kSlices = {0.02, 0.05, 0.15};
/// … and at least so many times what it took to set the question; and for more of what
/// was found, so many times what the easiest answer took.
constexpr std::uint64_t kSliceOfMaking = 20, kSliceOfSuccess = 10;
/// The number of colours asked for first, before any is known to do.
constexpr int kFirstColours = 6;
/// Looking for few rules, so many colours more than needed are tried.
constexpr int kMoreColours = 4;
constexpr std::size_t kManyOrbits = 1500;
constexpr std::size_t kMostSolutions = 1000;

class Synthesiser {
 public:
  Synthesiser(const Target& target, const SynthesisOptions& options, const SynthesisHooks& hooks)
      : target_(target),
        options_(options),
        hooks_(hooks),
        named_(static_cast<int>(target.bricks.size())),
        effort_(hooks.deadline),
        whole_(share(1)),
        candidates_(target, options, [this](const std::string& what) { tell(what); }) {}

  Synthesis run(const std::vector<std::vector<Cell>>& starts) {
    const auto began = std::chrono::steady_clock::now();
    tell("looking for a skeleton");
    skeleton_ = solve_by_skeleton(target_, options_, share(kSkeleton));
    if (skeleton_ && (skeleton_->colour_count == 1 || target_.cells.size() > kManyOrbits)) {
      result_.best = std::move(skeleton_);
    } else {
      search(starts);
    }
    result_.orders_tried = candidates_.tried();
    result_.cut_short = effort_.cut_short();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    result_.seconds = took.count();
    return std::move(result_);
  }

 private:
  void search(const std::vector<std::vector<Cell>>& starts) {
    if (skeleton_) best_ = skeleton_->colour_count;
    for (const std::vector<Cell>& start : starts) candidates_.add_start(start);
    candidates_.look_at_families(share(large() ? kLookingLarge : kLooking), whole_);
    if (candidates_.list.empty() && !skeleton_) look_at_every_order();
    const bool open = candidates_.list.empty() && !every_order_;
    if (open && candidates_.all_given() && !options_.family) {
      candidates_.search(share(kDiscovering.back()));
    }
    colour();
    if (solutions_.empty() && !skeleton_) {
      if (!every_order_) look_at_every_order();
      discover(kSlices.back(), share(kMergingMany));
    }
    finish();
  }

  void look_at_every_order() {
    every_order_ = candidates_.look_at_every_order(share(kMergingMany));
  }

  void tell(const std::string& what) {
    if (hooks_.progress) hooks_.progress(0, what);
  }

  /// So many steps are this share of the effort.
  std::uint64_t steps(double share) const {
    return static_cast<std::uint64_t>(options_.effort * share * kStepsOfEffort);
  }
  /// Up to this share of the effort.
  Allowance share(double share) { return {&effort_, steps(share)}; }

  void colour() {
    discover(0);
    if (improves_on_skeleton()) gather(large() ? kGatheringLarge : kGathering);
    const int before = best_;
    if (large() && best_ != 0) return;
    for (std::size_t round = 1; round < kSlices.size(); ++round) discover(round);
    if (best_ != before) gather(kGatheringAgain);
  }

  /// Is there any reason to look for more solutions with so many colours?
  bool improves_on_skeleton() const { return !skeleton_ || best_ < skeleton_->colour_count; }

  /// With large targets effort is better spent on few rules than on the last colour.
  bool large() const { return candidates_.frames().front()->orbits.size() > kManyOrbits; }

  void discover(std::size_t round) {
    discover(kSlices[large() ? 2 : round],
             share(large() && best_ == 0 ? kGathering : kDiscovering[round]));
  }

  /// Goes through the orders for fewer colours than any before has done with.
  void discover(double slice, const Allowance& allowance) {
    for (Candidate& candidate : candidates_.list) {
      if (allowance.passed() || (large() && best_ != 0)) return;
      const int most = best_ == 0 ? options_.most_colours : best_ - 1;
      if (candidate.least() > most) continue;
      const std::uint64_t before = effort_.spent();
      const std::optional<Schedule> schedule = candidates_.schedule_of(candidate, whole_);
      if (!schedule) return;
      ColouringSearch search(*schedule, named_, whole_);
      effort_.spend(search.cost());
      const std::uint64_t making = effort_.spent() - before;
      halve(search, candidate, most, std::max(steps(slice), kSliceOfMaking * making), allowance);
    }
  }

  /// The fewest colours of an order, up to `most`: by halving, a slice of the effort for
  /// each question. What is not answered within it counts as no, but is not remembered so:
  /// it may be answered within a longer slice.
  void halve(ColouringSearch& search, Candidate& candidate, int most, std::uint64_t slice,
             const Allowance& allowance) {
    int low = candidate.least();
    int high = std::min(most, std::max(low, kFirstColours));
    // More and more until so many do, then halve. Growing by factors of four finds a
    // feasible number after few questions; feasible ones are mostly quick.
    while (high < most &&
           ask(search, candidate, high, slice, allowance, Hint::random) != Answered::yes) {
      if (given_up(search, candidate) || allowance.passed()) return;
      low = high + 1;
      high = std::min(most, 4 * high);
    }
    while (low <= high && !allowance.passed()) {
      const int k = best_ == 0 || high == most ? high : low + (high - low) / 2;
      if (ask(search, candidate, k, slice, allowance, Hint::random) == Answered::yes) {
        high = k - 1;
        most = kMaxColours;  // from now on in halves
        if (large()) return;
      } else {
        if (given_up(search, candidate) || k == most) return;
        low = k + 1;
      }
    }
  }

  /// Other solutions with as many colours. Regular starting colours give solutions whose
  /// views repeat, and which so need fewer rules.
  void gather(double until) {
    const Allowance allowance = share(until);
    const int more = options_.fewest == Fewest::rules || large() ? kMoreColours : 0;
    for (Candidate& candidate : candidates_.list) {
      if (best_ == 0 || solutions_.size() >= kMostSolutions || allowance.passed()) return;
      if (candidate.least() > best_ + more) continue;
      const std::optional<Schedule> schedule = candidates_.schedule_of(candidate, whole_);
      if (!schedule) return;
      ColouringSearch search(*schedule, named_, whole_);
      effort_.spend(search.cost());
      for (int k = std::max(best_ + (large() ? 2 : 0), candidate.least());
           k <= std::min(best_ + more, options_.most_colours); k += large() ? 2 : 1) {
        for (const Hint hint : {Hint::depth, Hint::distance, Hint::uniform}) {
          if (allowance.passed()) return;
          if (large() && hint != Hint::depth) break;
          const std::uint64_t slice = kSliceOfSuccess * easiest_;
          if (ask(search, candidate, k, slice, allowance, hint) != Answered::yes) break;
        }
      }
    }
  }

  /// One question to the solver.
  Answered ask(ColouringSearch& search, Candidate& candidate, int k, std::uint64_t slice,
               const Allowance& allowance, Hint hint) {
    const Schedule& schedule = search.differences().schedule();
    ColouringLimits limits{allowance.within(slice), {}};
    limits.progress = [&](int n, int rounds) {
      tell(fmt::format("{}: {} colours, round {}", schedule.order.name, n, rounds));
    };
    const std::uint64_t before = effort_.spent();
    Colouring colours = hint_of(*schedule.frame, hint, k);
    const Answered answered = search.colour(k, limits, colours);
    if (answered == Answered::no) candidate.refuted = std::max(candidate.refuted, k);
    if (answered == Answered::yes) {
      keep(candidate, schedule, colours, k);
      const std::uint64_t took = effort_.spent() - before;
      easiest_ = easiest_ == 0 ? took : std::min(easiest_, took);
    }
    return answered;
  }

  /// Has it turned out that no colours do for this order?
  bool given_up(const ColouringSearch& search, Candidate& candidate) {
    if (!search.differences().hopeless()) return false;
    candidate.refuted = kMaxColours;
    candidates_.note_look_alike(search.differences().schedule(), *search.differences().hopeless());
    return true;
  }

  void keep(Candidate& candidate, const Schedule& schedule, const Colouring& colours, int k) {
    Solution solution;
    solution.frame = candidates_.frames()[candidate.frame];
    solution.order = schedule.order;
    solution.colours = colours;
    solution.colour_count = k;
    solution.fewer_refuted = candidate.least() == k;
    solution.exact_rules = exact_rules(schedule, colours).size();
    effort_.spend(cost_of(schedule));
    if (best_ == 0 || k < best_) best_ = k;
    solutions_.push_back(std::move(solution));
  }

  /// Rules for the most promising solutions of each number of colours; then, for the one
  /// that is best, as few as can be had with the effort that is left.
  void finish() {
    if (solutions_.empty() && !skeleton_) return explain_failure();
    const Allowance many = share(kMergingMany);
    choose_rules(target_, options_, std::move(solutions_), std::move(skeleton_),
                 {many.within(steps(kMergingQuick)), many, whole_}, hooks_, result_);
    result_.unanswered = !result_.best;
  }

  void explain_failure() {
    const std::vector<Candidate>& list = candidates_.list;
    // Nothing may be claimed unless every candidate has been refuted, and no clock has
    // interfered.
    const bool all_refuted = std::all_of(list.begin(), list.end(), [&](const Candidate& c) {
      return c.least() > options_.most_colours;
    });
    if (!all_refuted || effort_.cut_short()) {
      result_.unanswered = true;
    } else if (candidates_.look_alike() || list.empty()) {
      result_.obstacle = candidates_.look_alike();
      result_.unanswered = !result_.obstacle;
    } else {
      const auto easiest = std::min_element(list.begin(), list.end(),
                                            [](auto& a, auto& b) { return a.least() < b.least(); });
      const std::optional<Schedule> schedule = candidates_.schedule_of(*easiest, whole_);
      result_.unanswered = !schedule;
      if (!schedule) return;
      result_.obstacle =
          describe_few_colours(*schedule, named_, options_.most_colours, easiest->least(),
                               Allowance{&effort_, effort_.spent() + steps(kExplaining)});
    }
    // "Proved" says: for all starts, all orders, and heights included.
    if (result_.obstacle) result_.obstacle->proved = every_order_ && heights_do_not_help();
  }

  /// In a level target all cells have one height, and what else sees them has another view.
  bool heights_do_not_help() const {
    return !options_.heights || std::all_of(target_.cells.begin(), target_.cells.end(),
                                            [&](Cell c) { return c.z == target_.cells.front().z; });
  }

  const Target& target_;
  const SynthesisOptions& options_;
  const SynthesisHooks& hooks_;
  int named_;
  Effort effort_;
  Allowance whole_;
  Candidates candidates_;
  std::vector<Solution> solutions_;
  std::optional<Solution> skeleton_;
  int best_ = 0;               ///< fewest colours so far; 0: none
  std::uint64_t easiest_ = 0;  ///< steps of the easiest solution; 0: none
  bool every_order_ = false;   ///< there are no others than those that were looked at
  Synthesis result_;
};

/// The starts that nothing stands in the way of; for none at all, what does.
std::vector<std::vector<Cell>> usable_starts(const Target& target, const SynthesisOptions& options,
                                             std::optional<Obstacle>& problem) {
  std::vector<std::vector<Cell>> starts{options.start};
  if (options.start.empty()) starts = likely_starts(target, options.symmetry, options.floor);
  std::erase_if(starts, [&](const std::vector<Cell>& start) {
    std::optional<Obstacle> found = find_obstacle(target, {start, options.symmetry, options.floor});
    if (!found && start.size() >= target.cells.size()) {
      found.emplace();
      found->kind = Obstacle::Kind::bad_start;
      found->what = "the start is all of the target: there is nothing to build";
      found->proved = true;
    }
    const bool bad = found.has_value();
    if (bad && !problem) problem = std::move(found);
    return bad;
  });
  return starts;
}

}  // namespace

Synthesis synthesise(const Target& target, const SynthesisOptions& options,
                     const SynthesisHooks& hooks) {
  std::optional<Obstacle> problem;
  const auto starts = usable_starts(target, options, problem);
  if (!starts.empty()) return Synthesiser(target, options, hooks).run(starts);
  Synthesis result;
  result.obstacle = std::move(problem);
  // No start was given: without a symmetry one brick is as good as any other, and a single cell is
  // the only start that there is.
  result.obstacle->proved =
      !options.start.empty() || options.symmetry == Symmetry::none || target.cells.size() == 1;
  return result;
}

}  // namespace stig::synthesis
