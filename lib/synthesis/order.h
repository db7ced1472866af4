// SPDX-License-Identifier: MIT
// Orders of placement. A rank on the orbits of cells: of two neighbours the one of
// lower rank is placed first; neighbours of equal rank come in any order. What rules
// and proofs see of an order is no more than this.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "synthesis/frame.h"

namespace stig {

struct Order {
  std::string name;
  std::vector<std::int32_t> rank;  ///< by orbit; the start's is the lowest
};

/// Which neighbours a step goes to.
enum class Steps : std::uint8_t { faces, edges, corners };

/// Steps from the start through the target; unreached orbits get -1.
std::vector<std::int32_t> distances(const Frame& frame, Steps steps);

/// Rank by distance, ties left free.
Order breadth_first(const Frame& frame, Steps steps);

/// Orbits sorted by `key` (compared lexicographically), each with a rank of its own,
/// the start first. Orbits stand for their cell that is first by the key.
Order sorted_by(const Frame& frame, const std::string& name,
                const std::function<std::vector<std::int32_t>(Cell)>& key);

/// The families that synthesise() tries, the most promising first.
std::vector<Order> candidate_orders(const Frame& frame);

}  // namespace stig
