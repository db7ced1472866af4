// SPDX-License-Identifier: MIT
// What a site can look like while the target grows in any order that respects the
// ranks, and what its rules must look for.
//
// A local state of a site is the set of its neighbours that are placed, a bit each. It
// is closed under "comes before" among those neighbours, holds the start, and nothing
// of a higher rank than the site. That is a superset of what can be reached, so a
// claim about all local states is a claim about all orders. Under an order without
// ties there are at most 2088 (cubic) or 540 (hexagonal) of them: the independent sets
// of the graph of neighbours that are neighbours of each other.
//
// A key of a site is a local state in which it is to be placed: all neighbours of
// lower rank are there, and any of those of equal rank.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/effort.h"
#include "synthesis/order.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// States [first[s], first[s + 1]) of `masks` are those of site s.
struct LocalStates {
  std::vector<std::uint32_t> masks;
  std::vector<std::size_t> first;
  std::span<const std::uint32_t> of(std::size_t site) const {
    assert(site + 1 < first.size());
    return {masks.data() + first[site], first[site + 1] - first[site]};
  }
};

struct Key {
  std::int32_t site = 0;   ///< an orbit's first cell
  std::uint32_t mask = 0;  ///< neighbours that are there; all others are empty
};

/// A frame under an order.
struct Schedule {
  const Frame* frame = nullptr;
  Order order;
  std::vector<std::uint32_t> before;  ///< by orbit: neighbours of lower rank
  std::vector<std::uint32_t> beside;  ///< by orbit: neighbours of equal rank
  LocalStates states;
  std::vector<Key> keys;

  /// Is this a state in which the site is to be placed?
  bool intended(const Site& site, std::uint32_t mask) const {
    if (site.orbit < 0) return false;
    const std::uint32_t b = before[static_cast<std::size_t>(site.orbit)];
    return (mask & b) == b && !frame->orbits[static_cast<std::size_t>(site.orbit)].start;
  }
};

/// Steps that it takes to make a schedule, or to look for its clashes once.
std::uint64_t cost_of(const Schedule& schedule);

struct ScheduleLimits {
  std::size_t keys_of_site = 4096;
  std::size_t states = std::size_t{1} << 25;
  Allowance allowance = {};  ///< its time alone: when it is over no schedule is made
};

/// Why an order cannot be used at all.
struct BadOrder {
  enum class Kind : std::uint8_t { nothing_before, too_many, no_time } kind = Kind::nothing_before;
  Cell at;
  std::uint64_t cost = 0;  ///< steps it took to find out
};

/// Nothing, with `problem` set, when a cell has nothing before it or there are too
/// many states. The frame must outlive the schedule.
std::optional<Schedule> make_schedule(const Frame& frame, Order order, BadOrder& problem,
                                      const ScheduleLimits& limits = {});

}  // namespace stig::synthesis
