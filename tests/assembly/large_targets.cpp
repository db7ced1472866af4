// SPDX-License-Identifier: MIT
#include "assembly/large_targets.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "support/uses.h"

namespace stig {

namespace {

using Cells = std::set<Cell>;

Target target_of(const Cells& cells) {
  Target out;
  out.cells.assign(cells.begin(), cells.end());
  out.colours.assign(out.cells.size(), StateSet::anything());
  return out;
}

/// The first of growing sizes that is large enough.
Target grown(std::size_t bricks, const std::function<Cells(int size)>& of_size) {
  for (int size = 2;; ++size) {
    const Cells cells = of_size(size);
    if (cells.size() >= bricks) return target_of(cells);
  }
}

/// A number below `most`, by chance, the same on every machine.
int roll(std::uint64_t seed, std::uint64_t which, int most) {
  return static_cast<int>(combine(seed, which) % static_cast<std::uint64_t>(most));
}

using Room = std::pair<int, int>;
/// From the room with the smaller numbers.
using Doors = std::set<std::pair<Room, Room>>;

/// Rooms of a square, joined depth first by chance: one way from each to each other.
Doors doors_of(int size, std::uint64_t seed) {
  Doors out;
  std::set<Room> met = {{0, 0}};
  std::vector<Room> way = {{0, 0}};
  for (std::uint64_t rolls = 0; !way.empty(); ++rolls) {
    const auto [x, y] = way.back();
    std::vector<Room> beside;
    for (const Room& next : {Room{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
      const bool inside =
          std::min(next.first, next.second) >= 0 && std::max(next.first, next.second) < size;
      if (inside && !met.contains(next)) beside.push_back(next);
    }
    if (beside.empty()) {
      way.pop_back();
      continue;
    }
    const Room next =
        beside[static_cast<std::size_t>(roll(seed, rolls, static_cast<int>(beside.size())))];
    out.insert(std::minmax(way.back(), next));
    met.insert(next);
    way.push_back(next);
  }
  return out;
}

Cells maze(int size, int corridor, std::uint64_t seed) {
  const int pitch = corridor + 1;
  const Doors doors = doors_of(size, seed);
  Cells out;
  for (int i = 0; i <= size; ++i) {
    for (int j = 0; j <= size; ++j) {
      // Between the rooms on either side of the wall; the way in is at the origin.
      const bool along_x = i < size && !doors.contains({{i, j - 1}, {i, j}}) && i + j > 0;
      const bool along_y = j < size && !doors.contains({{i - 1, j}, {i, j}});
      out.insert({i * pitch, j * pitch, 0});
      for (int k = 1; k < pitch; ++k) {
        if (along_x) out.insert({i * pitch + k, j * pitch, 0});
        if (along_y) out.insert({i * pitch, j * pitch + k, 0});
      }
    }
  }
  return out;
}

Cells paved_town(int size, std::uint64_t seed) {
  constexpr int kLot = 5;
  Cells out;
  for (int lot = 0; lot < size * size; ++lot) {
    const auto of_lot = static_cast<std::uint64_t>(lot) * 3;
    const int x0 = lot % size * kLot, y0 = lot / size * kLot;
    for (int k = 0; k < kLot * kLot; ++k) out.insert({x0 + k % kLot, y0 + k / kLot, 0});
    const int wide = 1 + roll(seed, of_lot, 3), deep = 1 + roll(seed, of_lot + 1, 3);
    const int height = roll(seed, of_lot + 2, 3);
    for (int k = 0; k < wide * deep * height; ++k) {
      out.insert({x0 + 1 + k % wide, y0 + 1 + k / wide % deep, 1 + k / wide / deep});
    }
  }
  return out;
}

Cells terraced_town(int size, std::uint64_t seed) {
  constexpr int kHouse = 4, kRow = 5;
  Cells out;
  for (int house = 0; house < size * size; ++house) {
    const int x0 = house % size * kHouse, y0 = house / size * kRow;
    const int height = 1 + roll(seed, static_cast<std::uint64_t>(house), 3);
    for (int k = 0; k < (kHouse - 1) * height; ++k) {
      out.insert({x0 + 1 + k % (kHouse - 1), y0, k / (kHouse - 1)});
    }
    out.insert({x0, y0, 0});
  }
  for (int y = 0; y < (size - 1) * kRow; ++y) out.insert({0, y, 0});
  return out;
}

}  // namespace

Target maze_target(std::size_t bricks, int corridor, std::uint64_t seed) {
  return grown(bricks, [&](int size) { return maze(size, corridor, seed); });
}

Target paved_town_target(std::size_t bricks, std::uint64_t seed) {
  return grown(bricks, [&](int size) { return paved_town(size, seed); });
}

Target terraced_town_target(std::size_t bricks, std::uint64_t seed) {
  return grown(bricks, [&](int size) { return terraced_town(size, seed); });
}

}  // namespace stig
