// SPDX-License-Identifier: MIT
// Sides are quarter turns: what is ahead of one is to the left of the next.
#include "recheck/whole.h"

#include <algorithm>
#include <cassert>

namespace stig::recheck {

namespace {

/// Outwards from a side, and to the left of a robot that looks the other way.
constexpr std::array<Offset, 4> kOutwards = {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}};
constexpr std::array<Offset, 4> kLeft = {{{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}};

}  // namespace

Whole::Whole(const WorkCertificate& certificate) : start_(certificate.start) {
  assert(!certificate.bricks.empty());
  for (const WorkBrick& one : certificate.bricks) {
    numbers_.emplace(one.brick.at, static_cast<std::uint32_t>(cells_.size()));
    cells_.push_back(one.brick.at);
    colours_.push_back(one.brick.brick);
  }
  const auto lower = [](const Cell& a, const Cell& b) { return a.z < b.z; };
  const auto [low, high] = std::minmax_element(cells_.begin(), cells_.end(), lower);
  floor_ = low->z;
  levels_ = high->z - low->z + 1;
  for (const Cell& c : cells_) {
    std::array<Seen, 4>& from = seen_.emplace_back();
    for (std::size_t side = 0; side < 4; ++side) {
      const Offset &out = kOutwards[side], &left = kLeft[side];
      from[side] = {c.x * out.x + c.y * out.y, c.x * left.x + c.y * left.y, c.z - floor_};
    }
  }
}

std::uint32_t Whole::at(Cell cell) const {
  const auto found = numbers_.find(cell);
  return found == numbers_.end() ? kNoBrick : found->second;
}

std::uint32_t Whole::at(int side, Seen place) const {
  const Offset &out = kOutwards[static_cast<std::size_t>(side)],
               &left = kLeft[static_cast<std::size_t>(side)];
  return at(Cell{place.u * out.x + place.v * left.x, place.u * out.y + place.v * left.y,
                 place.z + floor_});
}

Bricks Whole::start() const {
  Bricks out(size());
  for (std::size_t i = 0; i < start_; ++i) out.add(i);
  return out;
}

}  // namespace stig::recheck
