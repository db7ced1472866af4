// SPDX-License-Identifier: MIT
#include "assembly/targets.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/hash.h"
#include "support/uses.h"

namespace stig {

namespace {

/// Numbers by chance, the same on every machine.
class Dice {
 public:
  Dice(std::string_view kind, std::uint64_t seed) : seed_(combine(hash_text(kind), seed)) {}
  /// From low to high, both included.
  int from(int low, int high) {
    return low +
           static_cast<int>(combine(seed_, rolls_++) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t seed_, rolls_ = 0;
};

using Heights = std::map<std::pair<int, int>, int>;

std::vector<Cell> columns(const Heights& heights) {
  std::vector<Cell> out;
  for (const auto& [at, height] : heights) {
    for (int z = 0; z < height; ++z) out.push_back({at.first, at.second, z});
  }
  return out;
}

/// The largest part of the ground plan that hangs together.
Heights connected(Heights heights) {
  std::erase_if(heights, [](const auto& column) { return column.second <= 0; });
  Heights best;
  while (!heights.empty()) {
    Heights part = {*heights.begin()};
    std::vector<std::pair<int, int>> edge = {heights.begin()->first};
    heights.erase(heights.begin());
    while (!edge.empty()) {
      const auto [x, y] = edge.back();
      edge.pop_back();
      for (const auto& next : {std::pair(x + 1, y), {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
        const auto found = heights.find(next);
        if (found == heights.end()) continue;
        part.insert(*found);
        edge.push_back(next);
        heights.erase(found);
      }
    }
    if (part.size() > best.size()) best = std::move(part);
  }
  return best;
}

std::vector<Cell> height_map(Dice& dice) {
  const int wide = dice.from(3, 6), deep = dice.from(3, 6), levels = dice.from(1, 3);
  Heights heights;
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) heights[{x, y}] = dice.from(dice.from(0, 1), levels);
  }
  return columns(connected(std::move(heights)));
}

std::vector<Cell> wall(Dice& dice) {
  Heights heights;
  const int length = dice.from(3, 8), height = dice.from(1, 3);
  for (int x = 0; x < length; ++x) heights[{x, 0}] = height;
  return columns(heights);
}

std::vector<Cell> ring(Dice& dice) {
  Heights heights;
  const int wide = dice.from(3, 6), deep = dice.from(3, 6), height = dice.from(1, 2);
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) {
      if (x == 0 || y == 0 || x == wide - 1 || y == deep - 1) heights[{x, y}] = height;
    }
  }
  return columns(heights);
}

std::vector<Cell> tower(Dice& dice) {
  Heights heights;
  const int wide = dice.from(1, 2), deep = dice.from(1, 3), height = dice.from(2, 3);
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) heights[{x, y}] = height;
  }
  return columns(heights);
}

std::vector<Cell> stairs(Dice& dice) {
  Heights heights;
  const int top = dice.from(2, 3), wide = dice.from(1, 3), tread = dice.from(1, 2);
  for (int x = 0; x < top * tread; ++x) {
    for (int y = 0; y < wide; ++y) heights[{x, y}] = top - x / tread;
  }
  return columns(heights);
}

std::vector<Cell> letter(Dice& dice) {
  static const std::vector<std::string> kLetters = {
      "111/101/111/101/101", "110/101/110/101/110", "111/100/100/100/111", "110/101/101/101/110",
      "111/100/110/100/111", "111/100/110/100/100", "101/101/111/101/101", "111/010/010/010/111",
      "100/100/100/100/111", "111/101/101/101/111", "111/101/111/100/100", "111/010/010/010/010",
      "101/101/101/101/111", "111/001/111/100/111", "101/101/111/001/111", "010/111/010"};
  const std::string& form =
      kLetters[static_cast<std::size_t>(dice.from(0, static_cast<int>(kLetters.size()) - 1))];
  const int height = dice.from(1, 2);
  Heights heights;
  int x = 0, y = 0;
  for (const char c : form) {
    if (c == '/') {
      --y;
      x = 0;
      continue;
    }
    heights[{x++, y}] = c == '1' ? height : 0;
  }
  return columns(connected(std::move(heights)));
}

std::vector<Cell> gate(Dice& dice) {
  const int wide = dice.from(3, 5), height = dice.from(2, 3), deep = dice.from(1, 2);
  std::vector<Cell> out;
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) {
      for (int z = 0; z < height; ++z) {
        if (x == 0 || x == wide - 1 || z == height - 1) out.push_back({x, y, z});
      }
    }
  }
  return out;
}

std::vector<Cell> blob(Dice& dice) {
  const int bricks = dice.from(4, 16);
  std::set<Cell> cells = {{0, 0, 0}};
  while (static_cast<int>(cells.size()) < bricks) {
    std::vector<Cell> beside;
    for (const Cell c : cells) {
      for (const Offset step : {Offset{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}) {
        const Cell next = c + step;
        const bool held = next.z == 0 || cells.contains(next + Offset{0, 0, -1});
        if (held && next.z < 3 && !cells.contains(next)) beside.push_back(next);
      }
    }
    cells.insert(
        beside[static_cast<std::size_t>(dice.from(0, static_cast<int>(beside.size()) - 1))]);
  }
  return {cells.begin(), cells.end()};
}

/// Columns under a lid that juts out by a brick here and there.
std::vector<Cell> overhang(Dice& dice) {
  const int wide = dice.from(1, 3), deep = dice.from(1, 2), height = dice.from(1, 2);
  std::set<Cell> cells;
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) {
      for (int z = 0; z <= height; ++z) cells.insert({x, y, z});
    }
  }
  for (int arms = dice.from(1, 3); arms > 0; --arms) {
    const int x = dice.from(0, wide - 1), y = dice.from(0, deep - 1);
    const std::array<Cell, 4> beyond = {
        {{-1, y, height}, {wide, y, height}, {x, -1, height}, {x, deep, height}}};
    cells.insert(beyond[static_cast<std::size_t>(dice.from(0, 3))]);
  }
  return {cells.begin(), cells.end()};
}

}  // namespace

Target drawn_target(std::string_view kind, std::uint64_t seed) {
  using Draw = std::vector<Cell> (*)(Dice&);
  constexpr std::array<Draw, kTargetKinds.size()> kDraw = {height_map, wall, ring, tower,   stairs,
                                                           letter,     gate, blob, overhang};
  const auto at = std::find(kTargetKinds.begin(), kTargetKinds.end(), kind) - kTargetKinds.begin();
  Dice dice(kind, seed);
  Target out;
  out.cells = kDraw.at(static_cast<std::size_t>(at))(dice);
  std::sort(out.cells.begin(), out.cells.end());
  out.colours.assign(out.cells.size(), StateSet::anything());
  return out;
}

}  // namespace stig
