// SPDX-License-Identifier: MIT
#include "assembly/work.h"

#include <algorithm>
#include <map>

namespace stig {

namespace {

struct Way {
  ApproachSide side{};
  std::uint32_t to = 0;
};

/// By brick: how robots that come to the structure put it.
std::map<std::uint32_t, Way> ways_on(const CompiledRules& compiled, std::uint32_t s) {
  const Policy& policy = compiled.policy;
  std::map<std::uint32_t, Way> out;
  for (std::size_t i = policy.first[s]; i < policy.first[s + 1]; ++i) {
    const Situation& at = policy.situations[i];
    const auto wish = decide(*compiled.decision, policy.observations[at.observation]);
    for (const auto& [placement, to] : at.placements) {
      if (!wish || placement != *wish) continue;
      out.emplace(brick_added(policy.states[s], policy.states[to], compiled.target->bricks()),
                  Way{at.side, to});
    }
  }
  return out;
}

}  // namespace

std::vector<WorkStep> work_of(const CompiledRules& compiled, const std::vector<Cell>& liked) {
  std::vector<std::uint32_t> rank(compiled.target->bricks(), 0);
  for (std::uint32_t i = 0; i < liked.size(); ++i) rank[compiled.target->brick_at(liked[i])] = i;
  std::vector<WorkStep> out;
  for (std::uint32_t s = 0;;) {
    const auto ways = ways_on(compiled, s);
    if (ways.empty()) return out;
    const auto& [brick, way] = *std::min_element(
        ways.begin(), ways.end(),
        [&](const auto& a, const auto& b) { return rank[a.first] < rank[b.first]; });
    out.push_back({compiled.target->cell(brick), way.side, ways.size()});
    s = way.to;
  }
}

}  // namespace stig
