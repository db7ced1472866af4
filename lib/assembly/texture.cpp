// SPDX-License-Identifier: MIT
#include "assembly/texture.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <tuple>

namespace stig::assembly {

namespace {

constexpr int kRepeat = 3;

/// Rows beside a spine, and places along them.
class Rows {
 public:
  Rows(const TargetBricks& target, const Liking& liking)
      : target_(target),
        along_x_(liking.spine == Liking::Spine::along_x),
        spine_(spine_rows(target, liking)) {
    first_ = last_ = along(0);
    for (std::uint32_t i = 0; i < target.bricks(); ++i) {
      first_ = std::min(first_, along(i));
      last_ = std::max(last_, along(i));
      below_ = std::min(below_, row(i));
      above_ = std::max(above_, row(i));
    }
  }

  int along(std::uint32_t i) const { return along_x_ ? target_.cell(i).x : target_.cell(i).y; }
  /// From the spine, signed; 0 for its own.
  int row(std::uint32_t i) const {
    return spine_.beside(along_x_ ? target_.cell(i).y : target_.cell(i).x);
  }
  /// Which of the colours of a row that repeats them.
  int place_in_repeat(std::uint32_t i) const { return ((along(i) % kRepeat) + kRepeat) % kRepeat; }
  /// Which of the colours of rows that are swept.
  int place_in_sweep(std::uint32_t i) const {
    if (along(i) == last_) return 2;
    const int rows_to_come = row(i) < 0 ? row(i) - below_ : above_ - row(i);
    return along(i) - first_ == rows_to_come ? 1 : 0;
  }

 private:
  const TargetBricks& target_;
  bool along_x_ = false;
  SpineRows spine_;
  int first_ = 0, last_ = 0;   ///< places along
  int below_ = 0, above_ = 0;  ///< outermost rows
};

}  // namespace

Texture no_texture(std::size_t bricks) {
  Texture out(bricks);
  std::iota(out.begin(), out.end(), 0U);
  return out;
}

Texture texture_of(const TargetBricks& target, const Liking& liking) {
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
