// SPDX-License-Identifier: MIT
#include "synthesis/order.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <queue>
#include <set>

namespace stig {
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

Order breadth_first(const Frame& frame, Steps steps) {
  static constexpr std::array<const char*, 3> kNames = {"faces", "edges", "corners"};
  return {fmt::format("breadth-first by {}, ties free", kNames[static_cast<std::size_t>(steps)]),
          distances(frame, steps)};
}

Order listed(const Frame& frame, const std::string& name, const std::vector<int>& orbits) {
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
  Lister(const Frame& frame, std::size_t most) : frame_(frame), most_(most) {
    for (std::size_t i = 0; i < frame.orbits.size(); ++i) {
      placed_.push_back(frame.orbits[i].start);
      left_ += frame.orbits[i].start ? 0 : 1;
    }
  }
  std::vector<Order> list() {
    extend();
    if (orders_.size() > most_) orders_.clear();
    return std::move(orders_);
  }

 private:
  bool has_placed_beside(std::size_t orbit) const {
    bool found = false;
    for_each_beside(frame_, orbit, [&](std::size_t other) { found |= placed_[other]; });
    return found;
  }
  void extend() {
    if (chosen_.size() == left_) {
      orders_.push_back(listed(frame_, fmt::format("order {}", orders_.size() + 1), chosen_));
      return;
    }
    for (std::size_t i = 0; i < placed_.size() && orders_.size() <= most_; ++i) {
      if (placed_[i] || !has_placed_beside(i)) continue;
      placed_[i] = true;
      chosen_.push_back(static_cast<int>(i));
      extend();
      chosen_.pop_back();
      placed_[i] = false;
    }
  }

  const Frame& frame_;
  std::size_t most_, left_ = 0;
  std::vector<bool> placed_;
  std::vector<int> chosen_;
  std::vector<Order> orders_;
};

}  // namespace

std::vector<Order> all_orders(const Frame& frame, std::size_t most) {
  return Lister(frame, most).list();
}

}  // namespace stig
