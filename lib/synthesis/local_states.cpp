// SPDX-License-Identifier: MIT
// Enumerates the local states of every site under an order (docs/synthesis.md, "What must
// hold"): sets of placed neighbours that are closed under "comes before". Closure is
// demanded between neighbours of the site alone, which may admit states that never occur;
// that is the safe side. The number of states is what the whole synthesis costs, and it is
// bounded here.
#include "synthesis/local_states.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

namespace stig::synthesis {
namespace {

/// Steps of placing a cell in an order, and of working out and looking up a state or a key.
constexpr std::uint64_t kStepsOfCell = 2'500, kStepsOfLocalState = 50, kStepsOfKey = 100;

using Masks = std::array<std::uint32_t, kMaxNeighbours>;

/// For each neighbour of a site: which others are neighbours of it. Adjacency within the
/// neighbourhood is what closure is about: of two neighbours that do not touch, neither is
/// before the other.
Masks adjacency(const Neighbourhood& n) {
  Masks masks{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(n.size); ++j) {
      if (n.index_of((Cell{} + n.offsets[j]) - (Cell{} + n.offsets[i])) >= 0) masks[i] |= 1U << j;
    }
  }
  return masks;
}

template <class Visit>
void for_each_bit(std::uint32_t mask, const Visit& visit) {
  for (; mask != 0; mask &= mask - 1) visit(static_cast<std::size_t>(std::countr_zero(mask)));
}

/// Enumerates the states of one site after another.
class Enumerator {
 public:
  Enumerator(const Frame& frame, const Order& order)
      : frame_(frame), rank_(order.rank), adjacent_(adjacency(frame.neighbours())) {}

  /// False when there are more than `most` states in all.
  bool add(const Site& site, std::size_t most, std::vector<std::uint32_t>& out) {
    list_.clear();
    std::uint32_t always = 0, possible = 0;
    // Neighbours of higher rank than a cell of the target come after it and are never there
    // while it is empty. All neighbours of a site outside may be there.
    for_each_bit(site.present, [&](std::size_t i) {
      if (of(site, i).start) {
        always |= 1U << i;
      } else if (site.orbit < 0 || rank(site, i) <= rank_[static_cast<std::size_t>(site.orbit)]) {
        possible |= 1U << i;
        list_.push_back({rank(site, i), i, 0});
      }
    });
    std::sort(list_.begin(), list_.end());
    for (Entry& entry : list_) {
      for_each_bit(adjacent_[entry.neighbour] & possible, [&](std::size_t j) {
        if (rank(site, j) < entry.rank) entry.needs |= 1U << j;
      });
    }
    return extend(always, 0, most, out);
  }

 private:
  struct Entry {
    std::int32_t rank;
    std::size_t neighbour;
    std::uint32_t needs;
    auto operator<=>(const Entry&) const = default;
  };

  const Orbit& of(const Site& site, std::size_t i) const {
    return frame_.orbits[static_cast<std::size_t>(site.beside[i])];
  }
  std::int32_t rank(const Site& site, std::size_t i) const {
    return rank_[static_cast<std::size_t>(site.beside[i])];
  }

  /// Every choice for the neighbours from `next` on: by rising rank, so that what a
  /// neighbour needs is decided before it and no choice is a dead end.
  bool extend(std::uint32_t chosen, std::size_t next, std::size_t most,
              std::vector<std::uint32_t>& out) {
    for (; next < list_.size(); ++next) {
      const Entry& entry = list_[next];
      if ((entry.needs & ~chosen) != 0) continue;
      if (!extend(chosen, next + 1, most, out)) return false;
      chosen |= 1U << entry.neighbour;
    }
    if (out.size() >= most) return false;
    out.push_back(chosen);
    return true;
  }

  const Frame& frame_;
  const std::vector<std::int32_t>& rank_;
  Masks adjacent_;
  std::vector<Entry> list_;
};

/// Lower and equal neighbours of the orbit's first cell.
void add_before_and_beside(const Frame& frame, std::size_t orbit, Schedule& schedule) {
  const std::vector<std::int32_t>& rank = schedule.order.rank;
  std::uint32_t before = 0, beside = 0;
  for_each_bit(frame.sites[orbit].present, [&](std::size_t i) {
    const auto other = static_cast<std::size_t>(frame.sites[orbit].beside[i]);
    if (rank[other] < rank[orbit] || frame.orbits[other].start) {
      before |= 1U << i;
    } else if (rank[other] == rank[orbit]) {
      beside |= 1U << i;
    }
  });
  schedule.before.push_back(before);
  schedule.beside.push_back(beside);
}

void add_keys(std::size_t orbit, Schedule& schedule) {
  const std::uint32_t free = schedule.beside[orbit];
  std::uint32_t subset = 0;
  // The subsets of a mask in rising order, by the usual trick: subtracting the mask carries
  // through its zeros.
  do {
    schedule.keys.push_back({static_cast<std::int32_t>(orbit), schedule.before[orbit] | subset});
    subset = (subset - free) & free;
  } while (subset != 0);
}

}  // namespace

std::uint64_t cost_of(const Schedule& schedule) {
  return schedule.frame->cells.size() * kStepsOfCell +
         schedule.states.masks.size() * kStepsOfLocalState +
         schedule.keys.size() * schedule.frame->group.size() * kStepsOfKey;
}

/// An order fails early: every non-start orbit needs an earlier neighbour, or its rule
/// would have to fire beside nothing.
std::optional<Schedule> make_schedule(const Frame& frame, Order order, BadOrder& problem,
                                      const ScheduleLimits& limits) {
  Schedule schedule;
  schedule.frame = &frame;
  schedule.order = std::move(order);
  assert(schedule.order.rank.size() == frame.orbits.size());
  for (std::size_t orbit = 0; orbit < frame.orbits.size(); ++orbit) {
    add_before_and_beside(frame, orbit, schedule);
    problem.at = frame.orbits[orbit].at;
    if (frame.orbits[orbit].start) continue;
    problem.cost = orbit * kStepsOfCell;
    if (schedule.before[orbit] == 0) {
      problem.kind = BadOrder::Kind::nothing_before;
      return std::nullopt;
    }
    problem.kind = BadOrder::Kind::too_many;
    if (std::size_t{1} << std::popcount(schedule.beside[orbit]) > limits.keys_of_site) {
      return std::nullopt;
    }
    add_keys(orbit, schedule);
  }
  Enumerator enumerator(frame, schedule.order);
  for (const Site& site : frame.sites) {
    schedule.states.first.push_back(schedule.states.masks.size());
    const bool is_start =
        site.orbit >= 0 && frame.orbits[static_cast<std::size_t>(site.orbit)].start;
    problem = {BadOrder::Kind::too_many, site.at, cost_of(schedule)};
    if (schedule.states.first.size() % kSitesBetweenLooks == 0 && limits.allowance.out_of_time()) {
      problem.kind = BadOrder::Kind::no_time;
      return std::nullopt;
    }
    if (!is_start && !enumerator.add(site, limits.states, schedule.states.masks)) {
      return std::nullopt;
    }
  }
  schedule.states.first.push_back(schedule.states.masks.size());
  return schedule;
}

}  // namespace stig::synthesis
