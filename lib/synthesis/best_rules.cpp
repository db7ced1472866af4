// SPDX-License-Identifier: MIT
// The search leaves many colourings (solutions); merging exact rules into general ones is
// the dear part, so it is spent where it promises most. Solutions are sorted by colours and
// exact rules, a few of each number of colours are merged once, and the best is merged
// again from many random beginnings with the effort that is left. What is kept is the
// Pareto front of colours against rules.
#include "synthesis/best_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <tuple>

#include "synthesis/candidates.h"
#include "synthesis/check_rules.h"
#include "synthesis/emit.h"

namespace stig::synthesis {
namespace {

/// More rules than this hardly fit a file (kMaxRuleFileBytes).
constexpr std::size_t kMostRules = 5000;
constexpr int kRestarts = 30;
/// When the time is over rules are still made for targets of so many cells: in a moment.
constexpr std::size_t kMostCellsAfterwards = 10'000;
/// Solutions of one number of colours that are merged; more as long as it goes quickly.
constexpr int kMergedOfEach = 3;
/// Steps of making a view and the rule that asks for it.
constexpr std::uint64_t kStepsOfView = 500;

class RuleChooser {
 public:
  RuleChooser(const Target& target, const SynthesisOptions& options, const MergingLimits& limits,
              const SynthesisHooks& hooks, Synthesis& result)
      : target_(target), options_(options), limits_(limits), hooks_(hooks), result_(result) {}

  void run(std::vector<Solution> solutions, std::optional<Solution> ready) {
    std::stable_sort(solutions.begin(), solutions.end(), [](const auto& a, const auto& b) {
      return std::tuple(a.exact_rules > kMostRules, a.colour_count, a.exact_rules) <
             std::tuple(b.exact_rules > kMostRules, b.colour_count, b.exact_rules);
    });
    std::map<int, int> merged;
    std::vector<Solution> done;
    // A ready solution (by a skeleton) is compared with the others and never merged again:
    // its rules ask for heights.
    if (ready) done.push_back(std::move(*ready));
    for (Solution& solution : solutions) {
      const bool enough = merged[solution.colour_count] >= kMergedOfEach && limits_.quick.passed();
      // At least one solution gets rules, however little effort is left.
      if (!done.empty() && (enough || limits_.many.passed())) continue;
      // Exact rules alone, too, take their time.
      if (limits_.whole.out_of_time() && solution.frame->cells.size() > kMostCellsAfterwards) {
        continue;
      }
      ++merged[solution.colour_count];
      if (hooks_.progress) {
        hooks_.progress(0.9, fmt::format("{} colours: merging {} exact rules",
                                         solution.colour_count, solution.exact_rules));
      }
      make_rules(solution, 1);
      done.push_back(std::move(solution));
    }
    choose(std::move(done));
    if (result_.best && !result_.best->heights && !limits_.whole.passed())
      make_rules(*result_.best, kRestarts);
  }

 private:
  void make_rules(Solution& solution, int restarts) {
    BadOrder bad;
    const std::optional<Schedule> schedule =
        make_schedule(*solution.frame, solution.order, bad, schedule_limits(options_));
    assert(schedule);
    limits_.whole.spend(cost_of(*schedule));
    const auto exact = exact_rules(*schedule, solution.colours);
    const auto views =
        options_.merge ? local_views(*schedule, solution.colours, limits_.whole) : std::nullopt;
    if (views) {
      limits_.whole.spend(views->size() * kStepsOfView);
      std::vector<MergedRule> rules = merge_rules(*solution.frame, solution.colour_count, exact,
                                                  *views, restarts, limits_.whole);
      if (solution.rules.empty() || rules.size() < solution.rules.size()) {
        solution.rules = std::move(rules);
      }
    } else if (solution.rules.empty()) {
      solution.rules = as_patterns(*solution.frame, exact);
    }
    const RuleSet rules = make_rule_set(*solution.frame, solution.colours, solution.colour_count,
                                        target_.bricks, solution.rules, {});
    // The last check asks the compiled rules themselves, at every local state
    // (check_rules.h). A fault here would be one of the merging, so it is asserted and not
    // reported.
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
    // Sorted by the preferred measure, a solution joins the front only if no earlier one is
    // as good in both.
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

  const Target& target_;
  const SynthesisOptions& options_;
  const MergingLimits& limits_;
  const SynthesisHooks& hooks_;
  Synthesis& result_;
};

}  // namespace

void choose_rules(const Target& target, const SynthesisOptions& options,
                  std::vector<Solution> solutions, std::optional<Solution> ready,
                  const MergingLimits& limits, const SynthesisHooks& hooks, Synthesis& result) {
  RuleChooser(target, options, limits, hooks, result).run(std::move(solutions), std::move(ready));
}

}  // namespace stig::synthesis
