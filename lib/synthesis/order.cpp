// SPDX-License-Identifier: MIT
// Orders of placement: breadth-first ranks, orders grown by a key along a frontier, and the
// enumeration of all orders of a few orbits. In each, every orbit has a neighbour of lower
// rank, so it is never placed beside nothing.
#include "synthesis/order.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <queue>
#include <set>

namespace stig::synthesis {
namespace {

bool within(const Neighbourhood& n, std::size_t i, Steps steps) {
  if (steps == Steps::faces) return n.is_face[i];
  if (steps == Steps::edges) return n.is_face[i] || n.is_edge[i];
  return true;
}

/// Calls visit(orbit) for the orbits beside an orbit's first cell.
template <class Visit>
void for_each_beside(const Frame& frame, std::size_t orbit, const Visit& visit) {
  for (int i = 0; i < frame.neighbours().size; ++i) {
    const int other = frame.sites[orbit].beside[static_cast<std::size_t>(i)];
    if (other >= 0) visit(static_cast<std::size_t>(other));
  }
}

/// An orbit is sorted by the least key of its cells, so the order has the group's symmetry.
std::vector<std::vector<std::int32_t>> keys_of_orbits(const Frame& frame, const SortKey& key) {
  std::vector<std::vector<std::int32_t>> least(frame.orbits.size());
  for (std::size_t i = 0; i < frame.cells.size(); ++i) {
    auto& of = least[static_cast<std::size_t>(frame.orbit_of[i])];
    std::vector<std::int32_t> own = key(frame.cells[i]);
    if (of.empty() || own < of) of = std::move(own);
  }
  return least;
}

}  // namespace

std::vector<std::int32_t> distances(const Frame& frame, Steps steps) {
  const Neighbourhood& n = frame.neighbours();
  std::vector<std::int32_t> distance(frame.orbits.size(), -1);
  std::vector<std::size_t> queue;
  for (std::size_t i = 0; i < frame.orbits.size(); ++i) {
    if (!frame.orbits[i].start) continue;
    distance[i] = 0;
    queue.push_back(i);
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const Site& site = frame.sites[queue[next]];
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      if (site.beside[i] < 0 || !within(n, i, steps)) continue;
      const auto other = static_cast<std::size_t>(site.beside[i]);
      if (distance[other] >= 0) continue;
      distance[other] = distance[queue[next]] + 1;
      queue.push_back(other);
    }
  }
  return distance;
}

/// Neighbours at one distance are ties: each may come first, and rules must do in every
/// case.
Order breadth_first(const Frame& frame, Steps steps) {
  static constexpr std::array<const char*, 3> kNames = {"faces", "edges", "corners"};
  return {fmt::format("breadth-first by {}, ties free", kNames[static_cast<std::size_t>(steps)]),
          distances(frame, steps)};
}

Order listed(const Frame& frame, const std::string& name, const std::vector<int>& orbits) {
  assert(orbits.size() <= frame.orbits.size());
  Order order{name, std::vector<std::int32_t>(frame.orbits.size(), 0)};
  std::int32_t rank = 0;
  for (const int orbit : orbits) {
    if (!frame.orbits[static_cast<std::size_t>(orbit)].start) {
      order.rank[static_cast<std::size_t>(orbit)] = ++rank;
    }
  }
  return order;
}

Order grown(const Frame& frame, const std::string& name, const SortKey& key) {
  const auto keys = keys_of_orbits(frame, key);
  // A set serves as a priority queue: O(n log n), and equal keys are resolved by the
  // orbit's number.
  std::set<std::pair<std::vector<std::int32_t>, std::size_t>> frontier;
  std::vector<bool> known(frame.orbits.size(), false);
  const auto reach = [&](std::size_t orbit) {
    if (known[orbit]) return;
    known[orbit] = true;
    frontier.emplace(keys[orbit], orbit);
  };
  for (std::size_t i = 0; i < frame.orbits.size(); ++i) known[i] = frame.orbits[i].start;
  for (std::size_t i = 0; i < frame.orbits.size(); ++i) {
    if (frame.orbits[i].start) for_each_beside(frame, i, reach);
  }
  std::vector<int> list;
  while (!frontier.empty()) {
    const std::size_t next = frontier.begin()->second;
    frontier.erase(frontier.begin());
    list.push_back(static_cast<int>(next));
    for_each_beside(frame, next, reach);
  }
  assert(std::find(known.begin(), known.end(), false) == known.end());
  return listed(frame, name, list);
}

namespace {

/// All orders of some orbits, each with one before it.
class Lister {
 public:
  Lister(const Frame& frame, std::size_t most, Ties ties)
      : frame_(frame), most_(most), ties_(ties), rank_(frame.orbits.size(), -1) {
    for (std::size_t i = 0; i < frame.orbits.size(); ++i) {
      if (frame.orbits[i].start) rank_[i] = 0;
    }
  }
  std::vector<Order> list() {
    extend(1);
    if (orders_.size() > most_) orders_.clear();
    return std::move(orders_);
  }

 private:
  bool has_beside(std::size_t orbit, const auto& wanted) const {
    bool found = false;
    for_each_beside(frame_, orbit, [&](std::size_t other) { found |= wanted(other); });
    return found;
  }

  /// Orbits that may come next.
  std::vector<std::size_t> frontier() const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < rank_.size(); ++i) {
      if (rank_[i] < 0 && has_beside(i, [&](std::size_t other) { return rank_[other] >= 0; })) {
        out.push_back(i);
      }
    }
    return out;
  }

  /// Those of a few orbits that have a bit in `chosen`, when they hang together. Ties
  /// matter only within a connected set of orbits: orbits that do not touch see nothing of
  /// each other's order.
  std::vector<std::size_t> connected(const std::vector<std::size_t>& of, std::size_t chosen) const {
    std::vector<std::size_t> level, reached;
    for (std::size_t i = 0; i < of.size(); ++i) {
      if ((chosen >> i) & 1U) level.push_back(of[i]);
    }
    reached.push_back(level.front());
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for_each_beside(frame_, reached[next], [&](std::size_t other) {
        const auto among = [&](const auto& list) {
          return std::find(list.begin(), list.end(), other) != list.end();
        };
        if (among(level) && !among(reached)) reached.push_back(other);
      });
    }
    if (reached.size() < level.size()) level.clear();
    return level;
  }

  /// The enumeration is depth first over levels; `rank_` is shared and undone on the way
  /// back.
  void place(const std::vector<std::size_t>& level, std::int32_t rank) {
    for (const std::size_t orbit : level) rank_[orbit] = rank;
    extend(rank + 1);
    for (const std::size_t orbit : level) rank_[orbit] = -1;
  }

  void extend(std::int32_t rank) {
    const std::vector<std::size_t> next = frontier();
    if (next.empty()) {
      orders_.push_back({fmt::format("order {}", orders_.size() + 1), rank_});
      return;
    }
    if (ties_ == Ties::none) {
      for (std::size_t i = 0; i < next.size() && orders_.size() <= most_; ++i) {
        place({next[i]}, rank);
      }
      return;
    }
    const std::size_t all = std::size_t{1} << std::min(next.size(), kMostTied);
    for (std::size_t chosen = 1; chosen < all && orders_.size() <= most_; ++chosen) {
      const std::vector<std::size_t> level = connected(next, chosen);
      if (!level.empty()) place(level, rank);
    }
  }

  /// A frontier of more orbits has more orders than anybody lists.
  static constexpr std::size_t kMostTied = 20;

  const Frame& frame_;
  std::size_t most_;
  Ties ties_;
  std::vector<std::int32_t> rank_;  ///< -1: not placed yet
  std::vector<Order> orders_;
};

}  // namespace

/// More than `most` orders give none at all: an incomplete list would be of no use to a
/// claim.
std::vector<Order> all_orders(const Frame& frame, std::size_t most, Ties ties) {
  return Lister(frame, most, ties).list();
}

}  // namespace stig::synthesis
