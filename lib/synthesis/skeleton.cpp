// SPDX-License-Identifier: MIT
// Greedy search for a skeleton: of the likeliest rays, the one is taken whose fills place
// the most cells for each rule it costs. The fills' closure is recomputed for each trial on
// a copy of the grid, which is what most of the time goes into. In the end fills that are
// not needed are left out, first by bisection on the plainest prefix, then one by one.
#include "synthesis/skeleton.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace stig::synthesis {
namespace {

constexpr Colour kFillColour = 1, kFirstRay = 2;
/// So many of the rays that could be next are grown to see what follows.
constexpr std::size_t kGrown = 16;
/// Steps of placing a brick, for each fill.
constexpr std::uint64_t kStepsOfBrick = 100, kStepsOfFill = 3;

/// A brick of the skeleton.
struct Joint {
  std::int32_t at;
  Colour colour;
};

class SkeletonSearch {
 public:
  SkeletonSearch(const SolidGrid& grid, std::int32_t start, const std::vector<Fill>& fills,
                 const SkeletonLimits& limits)
      : grid_(grid), fills_(fills), limits_(limits), filled_(grid, fills) {
    assert(grid.is_solid(start));
    skeleton_.start = start;
    filled_.place(start);
    joints_.push_back({start, kFirstRay});
  }

  std::optional<Skeleton> find() {
    charge(filled_.count());
    while (filled_.count() < grid_.cells.size()) {
      if (skeleton_.colours >= limits_.colours || limits_.allowance.passed() || !add_ray()) {
        return std::nullopt;
      }
    }
    if (skeleton_.colours > limits_.colours) return std::nullopt;
    thin();
    return std::move(skeleton_);
  }

 private:
  void charge(std::size_t bricks) const {
    limits_.allowance.spend(bricks * (kStepsOfBrick + fills_.size() * kStepsOfFill));
  }

  bool is_level(std::size_t along) const { return grid_.neighbours().offsets[along].z == 0; }

  /// Cells ahead that nothing fills yet; of a level ray the next alone. A level ray cannot
  /// tell where to end, having one height throughout, so it is one brick long.
  std::size_t open_ahead(const Joint& joint, std::size_t along) const {
    std::size_t length = 0;
    for (std::int32_t at = joint.at + grid_.step[along]; grid_.is_solid(at) && !filled_.has(at);
         at += grid_.step[along]) {
      ++length;
      if (is_level(along)) break;
    }
    return length;
  }

  struct Sprout {
    std::size_t joint, along;
    std::tuple<std::size_t, int> promise;
  };

  /// The likeliest rays: long ones, and of those the ones that lead away from most sides.
  std::vector<Sprout> sprouts() const {
    std::vector<Sprout> out;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      for (std::size_t along = 0; along < grid_.step.size(); ++along) {
        const std::size_t length = open_ahead(joints_[j], along);
        if (length == 0) continue;
        const Offset o = grid_.neighbours().offsets[along];
        out.push_back({j, along, {length, (o.x != 0) + (o.y != 0) + (o.z != 0)}});
      }
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const Sprout& a, const Sprout& b) { return a.promise > b.promise; });
    if (out.size() > kGrown) out.resize(kGrown);
    return out;
  }

  /// Grows a ray until it leaves the target or comes to what is filled.
  std::vector<std::int32_t> grow(const Joint& joint, std::size_t along, FilledGrid& filled) const {
    std::vector<std::int32_t> places;
    for (std::int32_t at = joint.at + grid_.step[along]; grid_.is_solid(at) && !filled.has(at);
         at += grid_.step[along]) {
      filled.place(at);
      places.push_back(at);
      if (is_level(along)) break;
    }
    return places;
  }

  /// Rules that it takes: one to begin and one to go on.
  static std::size_t cost(const std::vector<std::int32_t>& places) {
    return places.size() > 1 ? 2 : 1;
  }

  bool add_ray() {
    std::optional<FilledGrid> best;
    Sprout chosen{};
    std::vector<std::int32_t> places;
    std::size_t gain = 0;
    for (const Sprout& sprout : sprouts()) {
      if (limits_.allowance.passed()) break;
      FilledGrid trial = filled_;
      std::vector<std::int32_t> grown = grow(joints_[sprout.joint], sprout.along, trial);
      charge(trial.count() - filled_.count());
      const std::size_t gained = trial.count() - filled_.count();
      // Gains per rule are compared by cross-multiplication, in integers.
      if (best && gained * cost(places) <= gain * cost(grown)) continue;
      gain = gained;
      best = std::move(trial);
      chosen = sprout;
      places = std::move(grown);
      if (best->count() == grid_.cells.size()) break;
    }
    if (!best) return false;
    filled_ = std::move(*best);
    add(joints_[chosen.joint], chosen.along, std::move(places));
    return true;
  }

  /// The first ray continues in the start's colour if it rises or falls; a level one in that
  /// colour would match itself again and never end.
  void add(const Joint& from, std::size_t along, std::vector<std::int32_t> places) {
    const bool goes_on = skeleton_.rays.empty() && !is_level(along);
    if (skeleton_.rays.empty()) skeleton_.colours = kFirstRay;
    if (!goes_on) ++skeleton_.colours;
    const auto colour = static_cast<Colour>(skeleton_.colours);
    skeleton_.rays.push_back({from.colour, colour, along, std::move(places)});
    for (const std::int32_t at : skeleton_.rays.back().places) joints_.push_back({at, colour});
  }

  /// Do the first of the fills do?
  bool closes(const std::vector<Fill>& fills) const {
    FilledGrid filled(grid_, fills);
    filled.place(skeleton_.start);
    for (const Ray& ray : skeleton_.rays) {
      for (const std::int32_t at : ray.places) filled.place(at);
    }
    limits_.allowance.spend(filled.count() * (kStepsOfBrick + fills.size() * kStepsOfFill));
    return filled.count() == grid_.cells.size();
  }

  /// Leaves out all fills that can be spared, the least plain first.
  void thin() {
    std::size_t low = 0, high = fills_.size();
    const auto first = [&](std::size_t n) {
      return std::vector<Fill>(fills_.begin(), fills_.begin() + static_cast<std::ptrdiff_t>(n));
    };
    while (low < high) {
      const std::size_t half = (low + high) / 2;
      if (closes(first(half))) {
        high = half;
      } else {
        low = half + 1;
      }
    }
    std::vector<Fill> kept = first(high);
    for (std::size_t i = kept.size(); i-- > 0 && !limits_.allowance.out_of_time();) {
      std::vector<Fill> without = kept;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      if (closes(without)) kept = std::move(without);
    }
    skeleton_.fills = std::move(kept);
  }

  const SolidGrid& grid_;
  const std::vector<Fill>& fills_;
  const SkeletonLimits& limits_;
  FilledGrid filled_;
  std::vector<Joint> joints_;
  Skeleton skeleton_;
};

}  // namespace

std::optional<Skeleton> find_skeleton(const SolidGrid& grid, std::int32_t start,
                                      const std::vector<Fill>& fills,
                                      const SkeletonLimits& limits) {
  return SkeletonSearch(grid, start, fills, limits).find();
}

}  // namespace stig::synthesis
