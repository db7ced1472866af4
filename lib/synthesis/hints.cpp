// SPDX-License-Identifier: MIT
// Starting colours for the solver's decisions. Random colours have few clashes from the
// outset and lead to the fewest colours; regular ones (by distance from the start, by depth
// in the solid) repeat themselves, so their solutions need fewer different rules. The
// random numbers are the same on every run.
#include "synthesis/hints.h"

#include <algorithm>
#include <cassert>

#include "base/random.h"

namespace stig::synthesis {
namespace {

/// How deep orbits lie in the target: 0 where a neighbour is missing, and from there breadth
/// first.
std::vector<std::int32_t> depths(const Frame& frame) {
  std::vector<std::int32_t> depth(frame.orbits.size(), -1);
  std::vector<std::size_t> queue;
  const std::uint32_t all = (1U << frame.neighbours().size) - 1;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (frame.sites[i].present == all) continue;
    depth[i] = 0;
    queue.push_back(i);
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (int i = 0; i < frame.neighbours().size; ++i) {
      const std::int32_t beside = frame.sites[queue[next]].beside[static_cast<std::size_t>(i)];
      if (beside < 0 || depth[static_cast<std::size_t>(beside)] >= 0) continue;
      depth[static_cast<std::size_t>(beside)] = depth[queue[next]] + 1;
      queue.push_back(static_cast<std::size_t>(beside));
    }
  }
  return depth;
}

}  // namespace

Colouring hint_of(const Frame& frame, Hint hint, int k) {
  assert(k >= 1);
  Colouring colours(frame.orbits.size(), 1);
  Random random(1, 0, Purpose::order, 0, 0);
  std::vector<std::int32_t> value(frame.orbits.size(), 0);
  if (hint == Hint::distance) value = distances(frame, Steps::corners);
  if (hint == Hint::depth) value = depths(frame);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    int c = 0;
    if (hint == Hint::random) c = static_cast<int>(random.below(static_cast<std::uint64_t>(k)));
    if (hint == Hint::distance) c = value[i] % k;
    if (hint == Hint::depth) c = std::min(value[i], k - 1);
    colours[i] = static_cast<Colour>(1 + c);
  }
  return colours;
}

}  // namespace stig::synthesis
