// SPDX-License-Identifier: MIT
#include "lattice/box_cells.h"

#include <algorithm>
#include <utility>

namespace stig::lattice {
namespace {

/// With the margin. Larger boxes take more memory than is kept for a next run.
constexpr std::int64_t kMostCells = std::int64_t{1} << 21;

thread_local std::unique_ptr<BoxCells> spare;

bool same(const Box& a, const Box& b) { return a.low == b.low && a.size == b.size; }

}  // namespace

bool BoxCells::fit(const std::optional<Box>& box) {
  if (!box || box->periodic) return false;
  const Offset size = box->size;
  if (std::max({size.x, size.y, size.z}) >= kMostCells) return false;
  const std::int64_t slice = (std::int64_t{size.y} + 2) * (std::int64_t{size.z} + 2);
  return slice <= kMostCells && slice * (std::int64_t{size.x} + 2) <= kMostCells;
}

BoxCells::BoxCells(const Box& box, std::optional<std::size_t> floor_code)
    : box_(box),
      floor_code_(floor_code),
      corner_(box.low - Offset{1, 1, 1}),
      row_(box.size.z + 2),
      slice_(row_ * (box.size.y + 2)),
      cells_(static_cast<std::size_t>(slice_) * static_cast<std::size_t>(box.size.x + 2),
             CodedCell{0, kClosedCell}),
      // Not make_unique, which would fill them.
      records_(new Record[cells_.size()]) {
  for (CellNumber n = 0; n < cells_.size(); ++n) {
    const Cell at = cell(n);
    if (floor_code && at.z < 0) {
      cells_[n].code = static_cast<std::uint8_t>(*floor_code);
    } else if (box.contains(at)) {
      cells_[n].marks = 0;
    }
  }
}

std::unique_ptr<BoxCells> BoxCells::take(const Box& box, std::optional<std::size_t> floor_code) {
  std::unique_ptr<BoxCells> cells = std::move(spare);
  if (cells && same(cells->box_, box) && cells->floor_code_ == floor_code) return cells;
  cells.reset();
  return std::unique_ptr<BoxCells>(new BoxCells(box, floor_code));
}

void BoxCells::give_back(std::unique_ptr<BoxCells> cells) {
  cells->clear();
  spare = std::move(cells);
}

void BoxCells::clear() {
  for (const CellNumber number : seen_) cells_[number] = CodedCell{};
  seen_.clear();
  open_.clear();
}

Cell BoxCells::cell(CellNumber number) const {
  const auto slice = static_cast<CellNumber>(slice_), row = static_cast<CellNumber>(row_);
  const CellNumber x = number / slice, in_slice = number - x * slice, y = in_slice / row;
  return corner_ + Offset{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                          static_cast<std::int32_t>(in_slice - y * row)};
}

void BoxCells::with_stages() {
  if (!stages_) stages_.reset(new std::uint64_t[cells_.size()]);
}

}  // namespace stig::lattice
