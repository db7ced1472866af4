// SPDX-License-Identifier: MIT
#include "synthesis/order.h"

#include <algorithm>
#include <numeric>

namespace stig {
namespace {

bool within(const Neighbourhood& n, std::size_t i, Steps steps) {
  if (steps == Steps::faces) return n.is_face[i];
  if (steps == Steps::edges) return n.is_face[i] || n.is_edge[i];
  return true;
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
  static constexpr const char* kNames[] = {"faces", "edges", "corners"};
  return {std::string("breadth-first by ") + kNames[static_cast<std::size_t>(steps)],
          distances(frame, steps)};
}

Order sorted_by(const Frame& frame, const std::string& name,
                const std::function<std::vector<std::int32_t>(Cell)>& key) {
  std::vector<std::vector<std::int32_t>> least(frame.orbits.size());
  for (std::size_t i = 0; i < frame.cells.size(); ++i) {
    auto& of = least[static_cast<std::size_t>(frame.orbit_of[i])];
    std::vector<std::int32_t> own = key(frame.cells[i]);
    if (of.empty() || own < of) of = std::move(own);
  }
  std::vector<std::size_t> sorted(frame.orbits.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
    if (frame.orbits[a].start != frame.orbits[b].start) return frame.orbits[a].start;
    return least[a] < least[b];
  });
  Order order{name, std::vector<std::int32_t>(frame.orbits.size())};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    order.rank[sorted[i]] = static_cast<std::int32_t>(i);
  }
  return order;
}

}  // namespace stig
