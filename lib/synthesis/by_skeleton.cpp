// SPDX-License-Identifier: MIT
// Tries skeletons (skeleton.h) from the likely starts of a target and keeps the one with
// the fewest colours or rules. Fills with few needs come first, since their rules are short
// and plain; fills above or below one brick alone are the last resort. Works for free
// colours, one start and no symmetry; other cases are left to the search among orders.
#include "synthesis/by_skeleton.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <tuple>

#include "base/text.h"
#include "synthesis/skeleton_rules.h"

namespace stig::synthesis {
namespace {

/// Fills of so many needs are tried, few at first.
constexpr int kFewNeeds = 2, kManyNeeds = 3;
/// For larger targets so many colours are good enough.
constexpr std::size_t kLargeTarget = 1500;
constexpr int kGoodEnough = 6;

/// The outermost cells of bottom and top, and those nearest to their middles. Corners are
/// natural ends of rays; a start in the middle of a face suits flat targets.
std::vector<Cell> outermost(const Target& target) {
  assert(!target.cells.empty());
  Cell low = target.cells.front(), high = low;
  for (const Cell c : target.cells) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  std::vector<Cell> starts;
  const auto add_least = [&](const auto& key) {
    const Cell c = *std::min_element(target.cells.begin(), target.cells.end(),
                                     [&](Cell a, Cell b) { return key(a) < key(b); });
    if (std::find(starts.begin(), starts.end(), c) == starts.end()) starts.push_back(c);
  };
  for (const int z : {1, -1}) {
    for (const int y : {1, -1}) {
      for (const int x : {1, -1}) {
        add_least([=](Cell c) { return std::tuple(z * c.z, y * c.y, x * c.x); });
      }
    }
    add_least([=](Cell c) {
      return std::tuple(z * c.z,
                        std::abs(2 * c.x - low.x - high.x) + std::abs(2 * c.y - low.y - high.y),
                        c.y, c.x);
    });
  }
  return starts;
}

class SkeletonSolver {
 public:
  SkeletonSolver(const Target& target, const SynthesisOptions& options, const SolidGrid& grid,
                 const Allowance& allowance)
      : target_(target), options_(options), grid_(grid), allowance_(allowance) {}

  std::optional<Solution> solve(const std::vector<Cell>& starts) {
    for (const int needs : {kFewNeeds, kManyNeeds}) {
      look_from(starts, safe_fills(grid_, needs, allowance_));
    }
    if (!best_) look_from(starts, upright(safe_fills(grid_, 1, allowance_)));
    if (!best_) return std::nullopt;
    return solution();
  }

 private:
  void look_from(const std::vector<Cell>& starts, const std::vector<Fill>& fills) {
    for (const Cell start : starts) {
      if (allowance_.passed() || good_enough()) return;
      look_at(start, fills);
    }
  }

  /// Fills above or below one brick. They leave slopes to rays, and from rays others can branch.
  std::vector<Fill> upright(std::vector<Fill> fills) const {
    const Neighbourhood& n = grid_.neighbours();
    const auto leans = [&](const Fill& fill) {
      return fill.needs != 1U << n.index_of({0, 0, 1}) &&
             fill.needs != 1U << n.index_of({0, 0, -1});
    };
    fills.erase(std::remove_if(fills.begin(), fills.end(), leans), fills.end());
    return fills;
  }

  struct Found {
    Cell start;
    std::size_t rays;
    SkeletonRules made;
  };

  bool good_enough() const {
    if (!best_) return false;
    return best_->made.colour_count <= (target_.cells.size() > kLargeTarget ? kGoodEnough : 1);
  }

  /// A lexicographic pair, so that the second measure decides among equals.
  auto score(const Found& found) const {
    const auto colours = static_cast<std::size_t>(found.made.colour_count);
    return options_.fewest == Fewest::colours ? std::pair(colours, found.made.rules.size())
                                              : std::pair(found.made.rules.size(), colours);
  }

  void look_at(Cell start, const std::vector<Fill>& fills) {
    const auto skeleton =
        find_skeleton(grid_, grid_.place_of(start), fills, {options_.most_colours, allowance_});
    if (!skeleton) return;
    auto made = make_skeleton_rules(grid_, *skeleton, options_.floor, allowance_);
    if (!made || made->colour_count > options_.most_colours) return;
    Found found{start, skeleton->rays.size(), std::move(*made)};
    if (!best_ || score(found) < score(*best_)) best_ = std::move(found);
  }

  /// Solutions of both methods have the same form: the order of growth that was checked
  /// becomes the rank, each cell an orbit of its own.
  Solution solution() {
    Solution out;
    const auto frame = std::make_shared<Frame>(
        make_frame(target_, {{best_->start}, Symmetry::none, options_.floor}));
    out.order.name =
        best_->rays == 0 ? "fills alone" : counted(best_->rays, "ray") + ", then fills";
    std::vector<std::int32_t> rank(grid_.solid.size(), 0);
    for (std::size_t i = 0; i < best_->made.order.size(); ++i) {
      rank[static_cast<std::size_t>(best_->made.order[i])] = static_cast<std::int32_t>(i);
    }
    for (const Orbit& orbit : frame->orbits) {
      const auto place = static_cast<std::size_t>(grid_.place_of(orbit.at));
      out.order.rank.push_back(rank[place]);
      out.colours.push_back(best_->made.colours[place]);
    }
    out.frame = frame;
    out.colour_count = best_->made.colour_count;
    // One colour cannot be undercut, so this is "the fewest" without a proof.
    out.fewer_refuted = out.colour_count == 1;
    out.heights = true;
    out.rules = std::move(best_->made.rules);
    return out;
  }

  const Target& target_;
  const SynthesisOptions& options_;
  const SolidGrid& grid_;
  Allowance allowance_;
  std::optional<Found> best_;
};

}  // namespace

std::optional<Solution> solve_by_skeleton(const Target& target, const SynthesisOptions& options,
                                          const Allowance& allowance) {
  const bool free = std::all_of(target.colours.begin(), target.colours.end(),
                                [](StateSet colours) { return colours == StateSet::anything(); });
  const bool level = std::all_of(target.cells.begin(), target.cells.end(),
                                 [&](Cell c) { return c.z == target.cells.front().z; });
  if (!options.heights || !free || level || options.symmetry != Symmetry::none || options.family ||
      options.start.size() > 1) {
    return std::nullopt;
  }
  const auto grid = make_solid_grid(target, options.floor);
  if (!grid) return std::nullopt;
  return SkeletonSolver(target, options, *grid, allowance)
      .solve(options.start.empty() ? outermost(target) : options.start);
}

}  // namespace stig::synthesis
