// SPDX-License-Identifier: MIT
#include "assembly/counted.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace stig::assembly {

namespace {

enum class Shown : std::uint8_t { zero, one, border, end, free };

/// Where along rows of that length the highest digit carries: as late as the line aslant from
/// there takes to come to the lowest row at the last place.
int carry_at(int rows, int length) { return length - 1 - (rows - 2); }

/// Of a brick `at` along rows that count, `row` of them from the edge.
Shown counted(int rows, int length, int at, int row) {
  if (row == rows - 1) return Shown::border;
  const int carry = carry_at(rows, length);
  const int since_end = at - (carry + (rows - 2 - row));
  if (since_end >= 0) return since_end == 0 ? Shown::end : Shown::zero;
  // Below zero before the carry: as two's complement it counts up to all ones.
  return (((at - carry) >> row) & 1) != 0 ? Shown::one : Shown::zero;
}

Shown shown_at(int rows, const Span& x, const Span& y, Cell cell) {
  const int across = cell.x - x.low, up = cell.y - y.low;
  const bool in_corner = across < rows - 1 && up < rows - 1;
  if (in_corner) return Shown::free;
  if (cell.x == x.high) return up < rows - 1 ? Shown::border : Shown::end;
  if (across >= rows - 1 && up < rows) return counted(rows, x.width(), across, up);
  return across < rows ? counted(rows, y.width(), up, across) : Shown::border;
}

}  // namespace

std::optional<int> rows_to_count(const TargetBricks& target) {
  const Span x = span_of(target, &Cell::x), y = span_of(target, &Cell::y);
  const auto full = static_cast<std::int64_t>(x.width()) * y.width();
  if (target.levels() > 1 || full != static_cast<std::int64_t>(target.bricks())) {
    return std::nullopt;
  }
  const int shorter = std::min(x.width(), y.width()), longer = std::max(x.width(), y.width());
  for (int rows = 3; 2 * rows < shorter; ++rows) {
    // The first column beside the corner has a number that the digits hold.
    const int numbers = carry_at(rows, longer) - (rows - 1);
    if (numbers <= std::int64_t{1} << (rows - 1)) return rows;
  }
  return std::nullopt;
}

std::int64_t counted_turn(int rows, const Span& x, const Span& y, Cell cell) {
  const std::int64_t across = cell.x - x.low, up = cell.y - y.low, n = rows;
  const std::int64_t shell = std::max(across, up), corner = 2 * n * n;
  if (shell < n) return 2 * n * shell + (up < shell ? up : shell + across);
  return up < n ? corner + across * n + up : corner + std::int64_t{x.width()} * up + across;
}

std::vector<std::uint32_t> counted_texture(const TargetBricks& target, int rows) {
  const Span x = span_of(target, &Cell::x), y = span_of(target, &Cell::y);
  std::vector<std::uint32_t> out(target.bricks());
  std::iota(out.begin(), out.end(), 0U);
  std::map<Shown, std::uint32_t> first;
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const Shown shown = shown_at(rows, x, y, target.cell(i));
    if (shown != Shown::free) out[i] = first.emplace(shown, i).first->second;
  }
  return out;
}

}  // namespace stig::assembly
