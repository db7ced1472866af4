// SPDX-License-Identifier: MIT
#include "assembly/texture.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "assembly/counted.h"
#include "assembly/span.h"

namespace stig::assembly {

namespace {

constexpr int kRepeat = 3;

/// Rows beside a spine, and places along them.
class Rows {
 public:
  Rows(const TargetBricks& target, const Liking& liking)
      : target_(target),
        along_(liking.spine == Liking::Spine::along_x ? &Cell::x : &Cell::y),
        across_(liking.spine == Liking::Spine::along_x ? &Cell::y : &Cell::x),
        spine_(spine_rows(target, liking)),
        places_(span_of(target, along_)),
        rows_(span_of(target, across_)) {}

  /// From the spine, signed; 0 for its own.
  int row(std::uint32_t i) const { return spine_.beside(target_.cell(i).*across_); }
  /// Which of the colours of a row that repeats them.
  int place_in_repeat(std::uint32_t i) const {
    return ((target_.cell(i).*along_ % kRepeat) + kRepeat) % kRepeat;
  }
  /// Which of the colours of rows that are swept.
  int place_in_sweep(std::uint32_t i) const {
    const Cell at = target_.cell(i);
    if (at.*along_ == places_.high) return 2;
    const int rows_to_come = row(i) < 0 ? at.*across_ - rows_.low : rows_.high - at.*across_;
    return at.*along_ - places_.low == rows_to_come ? 1 : 0;
  }

 private:
  const TargetBricks& target_;
  std::int32_t Cell::*along_;
  std::int32_t Cell::*across_;
  SpineRows spine_;
  Span places_, rows_;
};

}  // namespace

Texture no_texture(std::size_t bricks) {
  Texture out(bricks);
  std::iota(out.begin(), out.end(), 0U);
  return out;
}

Texture texture_of(const TargetBricks& target, const Liking& liking) {
  if (liking.counting_rows > 0) return counted_texture(target, liking.counting_rows);
  Texture out = no_texture(target.bricks());
  if (liking.spine == Liking::Spine::none) return out;
  const Rows rows(target, liking);
  // By row (or side of the spine), level and place.
  std::map<std::tuple<int, int, int>, std::uint32_t> first;
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const int row = rows.row(i), level = target.cell(i).z;
    if (row == 0) continue;
    const auto key = liking.swept ? std::tuple(row < 0 ? -1 : 1, level, rows.place_in_sweep(i))
                                  : std::tuple(row, level, rows.place_in_repeat(i));
    out[i] = first.emplace(key, i).first->second;
  }
  return out;
}

}  // namespace stig::assembly
