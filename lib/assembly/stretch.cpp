// SPDX-License-Identifier: MIT
#include "assembly/stretch.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>
#include <vector>

namespace stig::assembly {

namespace {

/// A natural number that stays at the highest there is once it would be beyond.
class Capped {
 public:
  constexpr Capped(std::uint64_t value) : value_(value) {}  // NOLINT: numbers are meant
  Capped operator+(Capped other) const {
    std::uint64_t out = 0;
    return __builtin_add_overflow(value_, other.value_, &out) ? Capped(kMost) : Capped(out);
  }
  Capped operator*(Capped other) const {
    std::uint64_t out = 0;
    return __builtin_mul_overflow(value_, other.value_, &out) ? Capped(kMost) : Capped(out);
  }
  std::uint64_t value() const { return value_; }

 private:
  static constexpr std::uint64_t kMost = ~std::uint64_t{0};
  std::uint64_t value_;
};

/// A slice's places as (across, level), rising.
using Slice = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Heights of its piles: bricks one on the other.
std::vector<std::size_t> piles_of(const Slice& slice) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < slice.size(); ++i) {
    const bool on_top = i > 0 && slice[i - 1] == std::pair(slice[i].first, slice[i].second - 1);
    if (!on_top) out.push_back(0);
    ++out.back();
  }
  return out;
}

/// n choose k, by Pascal's rule.
Capped choose(std::size_t n, std::size_t k) {
  std::vector<Capped> row(k + 1, 0);
  row[0] = 1;
  for (std::size_t i = 1; i <= n; ++i) {
    for (std::size_t j = std::min(i, k); j > 0; --j) row[j] = row[j] + row[j - 1];
  }
  return row[k];
}

/// By number, in how many orders so many bricks of the piles can come.
std::vector<Capped> orders_of(const std::vector<std::size_t>& piles) {
  std::vector<Capped> out = {1};
  for (const std::size_t height : piles) {
    std::vector<Capped> more(out.size() + height, 0);
    for (std::size_t i = 0; i < out.size(); ++i) {
      for (std::size_t k = 0; k <= height; ++k) {
        more[i + k] = more[i + k] + out[i] * choose(i + k, k);
      }
    }
    out = std::move(more);
  }
  return out;
}

std::uint64_t crossings_of(const Slice& slice, int colours) {
  // Beyond, there are more than any target has slices.
  constexpr std::size_t kMostBricks = 32;
  const std::size_t m = slice.size();
  if (m > kMostBricks) return ~std::uint64_t{0};
  const std::vector<Capped> orders = orders_of(piles_of(slice));
  Capped out = 0, power = 1;
  for (std::size_t i = 0; i < m; ++i) power = power * static_cast<std::uint64_t>(colours);
  for (std::size_t j = 0; j < m; ++j) {
    out = out + orders[m] * orders[j] * choose(m - 1 + j, j) * power;
    power = power * static_cast<std::uint64_t>(colours);
  }
  return (out * 2).value();
}

/// Cuts of the stretch on that side of the start that has more of them.
std::uint64_t most_cuts(const Stretch& stretch, std::optional<std::int32_t> start) {
  const auto cuts = static_cast<std::uint64_t>(stretch.last - stretch.first);
  if (!start) return (cuts + 1) / 2;
  const std::int32_t before = std::clamp(*start, stretch.first, stretch.last) - stretch.first;
  return std::max(static_cast<std::uint64_t>(before), cuts - static_cast<std::uint64_t>(before));
}

std::optional<Stretch> stretch_along(const TargetBricks& target, bool along_x,
                                     std::optional<std::uint32_t> start, int colours) {
  std::map<std::int32_t, Slice> slices;
  for (std::size_t i = 0; i < target.bricks(); ++i) {
    const Cell c = target.cell(i);
    slices[along_x ? c.x : c.y].emplace_back(along_x ? c.y : c.x, c.z);
  }
  for (auto& [at, slice] : slices) std::sort(slice.begin(), slice.end());
  std::optional<std::int32_t> from;
  if (start) from = along_x ? target.cell(*start).x : target.cell(*start).y;
  for (auto first = slices.begin(); first != slices.end();) {
    Stretch out{along_x, first->first, first->first, first->second.size(), 0};
    auto next = std::next(first);
    while (next != slices.end() && next->first == out.last + 1 && next->second == first->second) {
      out.last = next->first;
      ++next;
    }
    if (out.last > out.first) {
      out.crossings = crossings_of(first->second, colours);
      if (most_cuts(out, from) > out.crossings) return out;
    }
    first = next;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Stretch> stretch_too_long(const TargetBricks& target,
                                        std::optional<std::uint32_t> start, int colours) {
  assert(colours > 0);
  auto out = stretch_along(target, true, start, colours);
  return out ? out : stretch_along(target, false, start, colours);
}

}  // namespace stig::assembly
