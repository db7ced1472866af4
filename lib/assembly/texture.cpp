// SPDX-License-Identifier: MIT
#include "assembly/texture.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace stig {

namespace {

constexpr int kRepeat = 3;

/// Rows from the two of the spine, signed; 0 for these.
int row_beside(int at, int low, int high) {
  const int lower = low + (high - low) / 2;
  return at <= lower ? at - lower : at - lower - 1;
}

}  // namespace

Texture no_texture(std::size_t bricks) {
  Texture out(bricks);
  std::iota(out.begin(), out.end(), 0U);
  return out;
}

Texture texture_of(const TargetBricks& target, const Liking& liking) {
  Texture out = no_texture(target.bricks());
  if (liking.spine == Liking::Spine::none) return out;
  const bool along_x = liking.spine == Liking::Spine::along_x;
  const auto across = [&](std::uint32_t i) {
    return along_x ? target.cell(i).y : target.cell(i).x;
  };
  const auto along = [&](std::uint32_t i) { return along_x ? target.cell(i).x : target.cell(i).y; };
  const auto [low, high] =
      std::minmax_element(out.begin(), out.end(),
                          [&](std::uint32_t a, std::uint32_t b) { return across(a) < across(b); });
  const int lowest = across(*low), highest = across(*high);
  std::map<std::tuple<int, int, int>, std::uint32_t>
      first;  // by row, level and place in the repeat
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const int row = row_beside(across(i), lowest, highest);
    if (row == 0) continue;
    const int place = ((along(i) % kRepeat) + kRepeat) % kRepeat;
    out[i] = first.emplace(std::tuple(row, target.cell(i).z, place), i).first->second;
  }
  return out;
}

}  // namespace stig
