// SPDX-License-Identifier: MIT
// RapidCheck generators of cells and brick lists.
#pragma once

#include <rapidcheck.h>

#include <map>
#include <vector>

#include "rules/rule_set.h"
#include "support/uses.h"

namespace stig {

/// Coordinates in [-reach, reach].
inline rc::Gen<Cell> random_cell(int reach) {
  return rc::gen::apply(
      [](int x, int y, int z) {
        return Cell{x, y, z};
      },
      rc::gen::inRange(-reach, reach + 1), rc::gen::inRange(-reach, reach + 1),
      rc::gen::inRange(-reach, reach + 1));
}

/// Up to `most` bricks of colours 1-4 in distinct cells.
inline rc::Gen<std::vector<PlacedBrick>> random_bricks(int most, int reach) {
  const auto one = rc::gen::pair(random_cell(reach), rc::gen::inRange(1, 5));
  return rc::gen::map(
      rc::gen::resize(most, rc::gen::container<std::vector<std::pair<Cell, int>>>(one)),
      [](const std::vector<std::pair<Cell, int>>& pairs) {
        std::map<Cell, int> distinct(pairs.begin(), pairs.end());
        std::vector<PlacedBrick> list;
        for (const auto& [at, colour] : distinct) list.push_back({at, static_cast<Colour>(colour)});
        return list;
      });
}

}  // namespace stig
