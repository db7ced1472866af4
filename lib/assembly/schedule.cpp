// SPDX-License-Identifier: MIT
#include "assembly/schedule.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace stig::assembly {

namespace {

/// Masks of all sites together; candidates with more are given up.
constexpr std::size_t kMostStatesAtOnce = std::size_t{1} << 20;
/// A brick with f free neighbours has 2^f keys.
constexpr int kMostFree = 10;  ///< neighbours that a brick leaves free

using Bits = std::uint32_t;

/// Enumerates the states of one site after another.
class Enumerator {
 public:
  Enumerator(const CandidateOrder& candidate, const RuleView& view)
      : candidate_(candidate), view_(view) {}

  /// False when there are more than there may be.
  bool add(const Site& site, std::vector<Bits>& out) {
    bricks_.clear();
    Bits always = 0;
    const std::uint32_t own = site.orbit < 0 ? TargetBricks::kNone : brick(site.orbit);
    for (Bits rest = site.present; rest != 0; rest &= rest - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(rest));
      const std::uint32_t other = brick(site.beside[place]);
      if (other == 0) {
        // The start is always there.
        always |= Bits{1} << place;
      } else if (own == TargetBricks::kNone || !candidate_.before[other].has(own)) {
        // Any other may be there, but for those that wait for the site's own brick: they cannot be
        // there while the site is empty.
        bricks_.push_back({other, place, 0});
      }
    }
    // A brick waits for earlier ones alone, so in the order of numbers what a brick needs comes
    // before it: extend decides on bricks in this order and never has to go back.
    std::sort(bricks_.begin(), bricks_.end());
    for (Beside& one : bricks_) {
      for (const Beside& other : bricks_) {
        if (candidate_.before[one.brick].has(other.brick)) one.needs |= Bits{1} << other.place;
      }
    }
    return extend(always, 0, out);
  }

 private:
  struct Beside {
    std::uint32_t brick;
    std::size_t place;
    Bits needs;
    auto operator<=>(const Beside&) const = default;
  };

  std::uint32_t brick(std::int32_t orbit) const {
    return view_.brick[static_cast<std::size_t>(orbit)];
  }

  /// Branches on each brick that may be there: sets without it come from the call, those with it
  /// from going on. Every call ends in one set and each set is met once, so time grows with the
  /// output.
  bool extend(Bits chosen, std::size_t next, std::vector<Bits>& out) const {
    for (; next < bricks_.size(); ++next) {
      if ((bricks_[next].needs & ~chosen) != 0) continue;
      if (!extend(chosen, next + 1, out)) return false;
      chosen |= Bits{1} << bricks_[next].place;
    }
    if (out.size() >= kMostStatesAtOnce) return false;
    out.push_back(chosen);
    return true;
  }

  const CandidateOrder& candidate_;
  const RuleView& view_;
  std::vector<Beside> bricks_;
};

/// Neighbours of an orbit's cell that are of the set, a bit each.
Bits those_of(const RuleView& view, const Site& site, const BrickSet& set) {
  Bits out = 0;
  for (Bits rest = site.present; rest != 0; rest &= rest - 1) {
    const auto place = static_cast<std::size_t>(std::countr_zero(rest));
    const std::uint32_t other = view.brick[static_cast<std::size_t>(site.beside[place])];
    if (set.has(other)) out |= Bits{1} << place;
  }
  return out;
}

bool add_keys(const CandidateOrder& candidate, const RuleView& view, std::size_t orbit,
              Schedule& out) {
  const std::uint32_t brick = view.brick[orbit];
  const Bits before = those_of(view, view.frame.sites[orbit], candidate.before[brick]);
  const Bits free = those_of(view, view.frame.sites[orbit], candidate.free[brick]);
  out.before.push_back(before);
  out.beside.push_back(free);
  if (brick == 0) return true;
  // A brick none of whose neighbours come before it would be put by a rule that asks for nothing.
  if (before == 0 || std::popcount(free) > kMostFree) return false;
  Bits subset = 0;
  do {
    out.keys.push_back({static_cast<std::int32_t>(orbit), before | subset});
    // The next subset of `free` in the order of numbers: subtracting borrows through the gaps.
    subset = (subset - free) & free;
  } while (subset != 0);
  return true;
}

}  // namespace

void look_at_rules(const Target& target, const CandidateOrder& candidate, RuleView& out) {
  assert(candidate.target != nullptr);
  out.frame = make_frame(target, {{candidate.target->cell(0)}, Symmetry::none, true});
  Schedule schedule;
  schedule.frame = &out.frame;
  schedule.order.name = "within a robot's reach";
  for (const Orbit& orbit : out.frame.orbits) {
    out.brick.push_back(candidate.target->brick_at(orbit.at));
    schedule.order.rank.push_back(static_cast<std::int32_t>(out.brick.back()));
  }
  for (std::size_t orbit = 0; orbit < out.brick.size(); ++orbit) {
    // Left without a schedule: rules cannot follow this order.
    if (!add_keys(candidate, out, orbit, schedule)) return;
  }
  Enumerator enumerator(candidate, out);
  for (const Site& site : out.frame.sites) {
    schedule.states.first.push_back(schedule.states.masks.size());
    const bool is_start = site.orbit >= 0 && out.brick[static_cast<std::size_t>(site.orbit)] == 0;
    if (!is_start && !enumerator.add(site, schedule.states.masks)) return;
  }
  schedule.states.first.push_back(schedule.states.masks.size());
  out.schedule = std::move(schedule);
}

}  // namespace stig::assembly
