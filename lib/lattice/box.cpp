// SPDX-License-Identifier: MIT
// Boxes are laid in one of two ways: at the origin that a file names, or around the start.
// The rounding is part of the format: certificates speak of absolute cells, and the checker
// has the same convention of its own (certify/space.cpp).
#include "lattice/box.h"

#include <algorithm>
#include <cassert>

namespace stig::lattice {
namespace {

/// C++'s remainder takes the sign of the dividend; a cell's image has to lie within the
/// box.
std::int32_t wrap_one(std::int32_t value, std::int32_t low, std::int32_t size) {
  assert(size >= 1);
  const std::int32_t rest = (value - low) % size;
  return low + (rest < 0 ? rest + size : rest);
}

/// Lowest coordinate of a side of `size` with [low, high] in its middle.
std::int32_t centred(std::int32_t low, std::int32_t high, std::int32_t size) {
  const std::int32_t spare = size - (high - low + 1);
  // Rounds down for a negative spare as well, that is, for a start larger than the box;
  // such a box is refused later, but by a message that needs its place.
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

}  // namespace stig::lattice
