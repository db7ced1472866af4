// SPDX-License-Identifier: MIT
#include "lattice/box.h"

#include <algorithm>

namespace stig {
namespace {

std::int32_t wrap_one(std::int32_t value, std::int32_t low, std::int32_t size) {
  const std::int32_t rest = (value - low) % size;
  return low + (rest < 0 ? rest + size : rest);
}

/// Lowest coordinate of a side of `size` with [low, high] in its middle.
std::int32_t centred(std::int32_t low, std::int32_t high, std::int32_t size) {
  const std::int32_t spare = size - (high - low + 1);
  return low - (spare >= 0 ? spare / 2 : -((1 - spare) / 2));
}

}  // namespace

Cell Box::wrap(Cell c) const {
  if (!periodic) return c;
  return {wrap_one(c.x, low.x, size.x), wrap_one(c.y, low.y, size.y),
          floor ? c.z : wrap_one(c.z, low.z, size.z)};
}

Box lay_box(const BoxSpec& spec, const std::vector<PlacedBrick>& start, bool floor) {
  Box box{{}, spec.size, spec.periodic, floor};
  if (spec.origin) {
    box.low = *spec.origin;
    return box;
  }
  Cell low{}, high{};
  if (!start.empty()) low = high = start.front().at;
  for (const PlacedBrick& brick : start) {
    low = {std::min(low.x, brick.at.x), std::min(low.y, brick.at.y), std::min(low.z, brick.at.z)};
    high = {std::max(high.x, brick.at.x), std::max(high.y, brick.at.y),
            std::max(high.z, brick.at.z)};
  }
  box.low = {centred(low.x, high.x, box.size.x), centred(low.y, high.y, box.size.y),
             floor ? 0 : centred(low.z, high.z, box.size.z)};
  return box;
}

}  // namespace stig
