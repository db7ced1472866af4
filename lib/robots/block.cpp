// SPDX-License-Identifier: MIT
// A block's figures that follow from others, so that files do not say them twice.
#include "robots/block.h"

namespace stig::robots {

double BlockModel::inertia() const {
  // Two of a point's three coordinates count for an axis.
  const double points = has_magnets() ? 8 * magnet_mass * 2 * magnet_offset * magnet_offset : 0;
  return body_mass * side * side / 6 + points;
}

double BlockModel::magnet_moment() const { return magnet_field * kMomentPerField; }

std::vector<Vec3> BlockModel::magnet_places() const {
  std::vector<Vec3> places;
  for (int i = 0; has_magnets() && i < 8; ++i) {
    const auto sign = [i](int bit) { return (i >> bit & 1) == 1 ? 1.0 : -1.0; };
    places.push_back(Vec3{sign(0), sign(1), sign(2)} * magnet_offset);
  }
  return places;
}

}  // namespace stig::robots
