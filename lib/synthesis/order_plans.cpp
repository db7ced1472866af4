// SPDX-License-Identifier: MIT
// The families of orders that are tried, each in all 48 ways to read coordinates (3! axes,
// 2^3 directions). Why these: docs/synthesis.md, "Orders, and counting". Plans are recipes;
// orders of large targets are made when their turn comes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "synthesis/order.h"

namespace stig::synthesis {
namespace {

/// A way to read coordinates: which axis comes first, and in which direction.
struct Axes {
  std::array<int, 3> axis;  ///< 0: x, 1: y, 2: z
  std::array<int, 3> sign;
};

std::int32_t along(const Axes& axes, std::size_t i, Cell c) {
  const std::array<std::int32_t, 3> at{c.x, c.y, c.z};
  return axes.sign[i] * at[static_cast<std::size_t>(axes.axis[i])];
}

std::string words(const Axes& axes) {
  std::string out;
  for (std::size_t i = 0; i < 3; ++i) {
    out +=
        fmt::format("{}{}{}", i == 0 ? "" : " ", axes.sign[i] > 0 ? '+' : '-', "xyz"[axes.axis[i]]);
  }
  return out;
}

std::vector<Axes> all_axes() {
  std::vector<Axes> all;
  std::array<int, 3> axis{2, 1, 0};
  // Sorted first, so that next_permutation goes through all.
  std::sort(axis.begin(), axis.end());
  do {
    for (int signs = 0; signs < 8; ++signs) {
      all.push_back({axis, {(signs & 1) ? -1 : 1, (signs & 2) ? -1 : 1, (signs & 4) ? -1 : 1}});
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return all;
}

/// Rounds towards minus infinity.
std::int32_t quotient(std::int32_t a, std::int32_t b) {
  assert(b > 0);
  return (a - (((a % b) + b) % b)) / b;
}

/// Distance first, so shells are completed one after another; coordinates only break ties
/// within a shell.
Order by_distance(const Frame& frame, Steps steps, const Axes& axes, const std::string& name) {
  const std::vector<std::int32_t> distance = distances(frame, steps);
  return grown(frame, name, [&](Cell c) {
    const int cell = index_in(frame.cells, c);
    const int orbit = frame.orbit_of[static_cast<std::size_t>(cell)];
    return std::vector<std::int32_t>{distance[static_cast<std::size_t>(orbit)], along(axes, 0, c),
                                     along(axes, 1, c), along(axes, 2, c)};
  });
}

/// Cells with the most neighbours there come first; ties by distance, then coordinates. A
/// priority queue with stale entries: an orbit is pushed again whenever its crowd grows,
/// and entries with an old crowd are skipped. O(n x neighbours x log n).
Order by_crowd(const Frame& frame, const Axes& axes, const std::string& name) {
  const std::vector<std::int32_t> distance = distances(frame, Steps::corners);
  const Neighbourhood& n = frame.neighbours();
  const auto key = [&](std::size_t orbit, int crowd) {
    const Cell c = frame.orbits[orbit].at;
    return std::array<std::int32_t, 6>{-crowd,
                                       distance[orbit],
                                       along(axes, 0, c),
                                       along(axes, 1, c),
                                       along(axes, 2, c),
                                       static_cast<std::int32_t>(orbit)};
  };
  std::vector<int> crowd(frame.orbits.size(), 0), list;
  std::vector<bool> placed(frame.orbits.size(), false);
  std::vector<std::array<std::int32_t, 6>> heap;
  const auto place = [&](std::size_t orbit) {
    placed[orbit] = true;
    for (int i = 0; i < n.size; ++i) {
      const int other = frame.sites[orbit].beside[static_cast<std::size_t>(i)];
      if (other < 0 || placed[static_cast<std::size_t>(other)]) continue;
      const auto o = static_cast<std::size_t>(other);
      heap.push_back(key(o, ++crowd[o]));
      std::push_heap(heap.begin(), heap.end(), std::greater<>());
    }
  };
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (frame.orbits[i].start) place(i);
  }
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    const auto entry = heap.back();
    heap.pop_back();
    const auto orbit = static_cast<std::size_t>(entry[5]);
    if (placed[orbit] || crowd[orbit] != -entry[0]) continue;
    list.push_back(static_cast<int>(orbit));
    place(orbit);
  }
  return listed(frame, name, list);
}

void add_breadth_first(std::vector<OrderPlan>& plans) {
  static constexpr std::array<const char*, 3> kNames = {"faces", "edges", "corners"};
  for (const Axes& axes : all_axes()) {
    for (const Steps steps : {Steps::corners, Steps::faces, Steps::edges}) {
      const std::string name = fmt::format("breadth-first by {}, then {}",
                                           kNames[static_cast<std::size_t>(steps)], words(axes));
      plans.push_back({name, OrderFamily::breadth_first,
                       [=](const Frame& frame) { return by_distance(frame, steps, axes, name); }});
    }
  }
}

void add_rasters(std::vector<OrderPlan>& plans) {
  for (const Axes& axes : all_axes()) {
    const std::string name = "raster " + words(axes);
    plans.push_back({name, OrderFamily::raster, [=](const Frame& frame) {
                       return grown(frame, name, [&](Cell c) {
                         return std::vector<std::int32_t>{along(axes, 0, c), along(axes, 1, c),
                                                          along(axes, 2, c)};
                       });
                     }});
  }
}

/// Slabs `high` thick along the first axis, in them ribbons `wide` along the second, which
/// grow along the third. Rows within a ribbon advance together, which lets them count in
/// digits.
void add_ribbons(std::vector<OrderPlan>& plans) {
  struct Size {
    std::int32_t high, wide;
  };
  static constexpr std::array<Size, 4> kSizes = {{{1, 2}, {2, 2}, {1, 3}, {2, 3}}};
  for (const Axes& axes : all_axes()) {
    for (const Size size : kSizes) {
      // Named variables: clang 14 lets no lambda capture a structured binding.
      const std::int32_t high = size.high, wide = size.wide;
      const std::string name = fmt::format("ribbons {}x{} {}", high, wide, words(axes));
      plans.push_back({name, OrderFamily::ribbons, [=](const Frame& frame) {
                         return grown(frame, name, [&](Cell c) {
                           const std::int32_t a = along(axes, 0, c), b = along(axes, 1, c);
                           return std::vector<std::int32_t>{quotient(a, high), quotient(b, wide),
                                                            along(axes, 2, c), a, b};
                         });
                       }});
    }
  }
}

void add_crowded(std::vector<OrderPlan>& plans) {
  for (const Axes& axes : all_axes()) {
    const std::string name = "crowded first, then " + words(axes);
    plans.push_back({name, OrderFamily::crowded,
                     [=](const Frame& frame) { return by_crowd(frame, axes, name); }});
  }
}

}  // namespace

/// The order of plans decides what a small effort gets to see, and with it results: it is
/// part of the definition of `--effort`.
std::vector<OrderPlan> order_plans() {
  std::vector<OrderPlan> plans;
  add_breadth_first(plans);
  add_crowded(plans);
  add_rasters(plans);
  add_ribbons(plans);
  // Ties leave a cell many states to be recognised in: last.
  for (const Steps steps : {Steps::corners, Steps::faces, Steps::edges}) {
    plans.push_back({"", OrderFamily::breadth_first,
                     [=](const Frame& frame) { return breadth_first(frame, steps); }});
  }
  return plans;
}

}  // namespace stig::synthesis
