// SPDX-License-Identifier: MIT
#include "assembly/path.h"

#include <algorithm>
#include <map>
#include <utility>

namespace stig::assembly {

std::vector<int> steps_from(const TargetBricks& target, Cell first, Cell last) {
  using Column = std::pair<std::int32_t, std::int32_t>;
  std::map<Column, int> steps;  // -1: not come to
  for (std::size_t i = 0; i < target.bricks(); ++i) {
    steps[{target.cell(i).x, target.cell(i).y}] = -1;
  }
  steps.at({first.x, first.y}) = 0;
  std::vector<Column> edge = {{first.x, first.y}};
  int most = 0;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const auto [x, y] = edge[i];
    most = steps.at(edge[i]);
    for (const Column& next : {Column(x + 1, y), {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
      const auto at = steps.find(next);
      if (at == steps.end() || at->second >= 0 || next == Column(last.x, last.y)) continue;
      at->second = most + 1;
      edge.push_back(next);
    }
  }
  std::vector<int> out;
  for (std::size_t i = 0; i < target.bricks(); ++i) {
    const Cell cell = target.cell(i);
    const int here = steps.at({cell.x, cell.y});
    const bool over_first = here == 0 && cell.z > target.floor_level();
    out.push_back(here < 0 || over_first ? most + 1 : here);
  }
  return out;
}

}  // namespace stig::assembly
