// SPDX-License-Identifier: MIT
// One run of the compiled decisions, which shows how many robots find work on the way. That every
// run ends at the whole structure is what compile has proved already.
#include "assembly/work.h"

#include <algorithm>
#include <cassert>

#include "compiler/open_work.h"

namespace stig::assembly {

std::vector<WorkStep> work_of(const CompiledRules& compiled, const std::vector<Cell>& liked) {
  assert(compiled.target != nullptr && liked.size() == compiled.target->bricks());
  std::vector<std::uint32_t> rank(compiled.target->bricks(), 0);
  for (std::uint32_t i = 0; i < liked.size(); ++i) rank[compiled.target->brick_at(liked[i])] = i;
  const OpenWork open(compiled);
  BrickSet state = compiled.target->start();
  std::vector<WorkStep> out;
  for (;;) {
    const auto ways = open.in(state);
    // Nobody has anything to do: the structure is whole.
    if (ways.empty()) return out;
    const auto& [brick, side] = *std::min_element(
        ways.begin(), ways.end(),
        [&](const auto& a, const auto& b) { return rank[a.first] < rank[b.first]; });
    out.push_back({compiled.target->cell(brick), side, ways.size()});
    state.add(brick);
  }
}

}  // namespace stig::assembly
