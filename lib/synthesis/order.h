// SPDX-License-Identifier: MIT
// Orders of placement. A rank on the orbits of cells: of two neighbours the one of
// lower rank is placed first; neighbours of equal rank come in any order. What rules
// and proofs see of an order is no more than this.
//
// How many colours an order needs depends on how much a cell sees when it is placed. A
// cell that sees one neighbour continues a straight run, and a run of n such cells has
// to count: n colours. Breadth first by corners shows most cells a whole 2×2 of the
// shell before, and ribbons let rows side by side count together, in digits. So several
// families are tried.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "synthesis/frame.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct Order {
  std::string name;
  std::vector<std::int32_t> rank;  ///< by orbit; the start's is the lowest
};

/// Which neighbours a step goes to.
enum class Steps : std::uint8_t { faces, edges, corners };

/// Steps from the start through the target; unreached orbits get -1.
std::vector<std::int32_t> distances(const Frame& frame, Steps steps);

/// What cells are sorted by, lexicographically.
using SortKey = std::function<std::vector<std::int32_t>(Cell)>;

/// Grows an order from the start: the orbit beside what is there with the least key comes next,
/// each with a rank of its own: a cell always has something before it. An orbit's key is the least
/// of its cells'. All orbits must be connected to the start (asserted).
Order grown(const Frame& frame, const std::string& name, const SortKey& key);
/// Rank by distance, ties left free.
Order breadth_first(const Frame& frame, Steps steps);
/// Orbits in the order of a list, the start's first.
Order listed(const Frame& frame, const std::string& name, const std::vector<int>& orbits);

enum class OrderFamily : std::uint8_t {
  breadth_first,  ///< by faces, edges or corners, ties by coordinates or free
  raster,         ///< by coordinates, in any of the directions
  ribbons,        ///< raster, several rows at once
  crowded,        ///< what has the most neighbours first
};

/// An order not made yet: making it costs time on large targets.
struct OrderPlan {
  std::string name;
  OrderFamily family = OrderFamily::breadth_first;
  std::function<Order(const Frame&)> make;
};
/// The most promising first.
std::vector<OrderPlan> order_plans();

/// May neighbours have equal rank?
enum class Ties : std::uint8_t { none, allowed };

/// Every order of the orbits in which each has one before it, as long as there are no
/// more than `most`; otherwise none. With ties: those among orbits that hang together,
/// for ties of others are no different from one after the other.
std::vector<Order> all_orders(const Frame& frame, std::size_t most, Ties ties = Ties::none);

}  // namespace stig::synthesis
