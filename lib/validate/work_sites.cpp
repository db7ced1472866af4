// SPDX-License-Identifier: MIT
#include "validate/work_sites.h"

#include <set>

#include "validate/build_site.h"

namespace stig {

WorkSites::WorkSites(const CompiledRules& compiled) : compiled_(compiled) {
  const std::vector<BrickSet>& states = compiled.policy.states;
  for (std::uint32_t i = 0; i < states.size(); ++i) numbers_.emplace(states[i], i);
}

int WorkSites::in(const BrickSet& state) const {
  const auto found = numbers_.find(state);
  if (found == numbers_.end()) return 0;
  const Policy& policy = compiled_.policy;
  // Every placement adds one brick, so the structures that follow are as many as the sites.
  std::set<std::uint32_t> next;
  for (std::size_t i = policy.first[found->second]; i < policy.first[found->second + 1]; ++i) {
    const Situation& here = policy.situations[i];
    const auto wish = decide(*compiled_.decision, policy.observations[here.observation]);
    for (const auto& [placement, to] : here.placements) {
      if (wish == placement) next.insert(to);
    }
  }
  return static_cast<int>(next.size());
}

std::vector<std::pair<double, int>> WorkSites::over(const std::vector<BrickEvent>& events,
                                                    const RuleSet& rules) const {
  const TargetStates& target = *compiled_.target;
  std::vector<bool> stands(target.bricks());
  for (std::size_t i = 0; i < target.start_bricks(); ++i) stands[i] = true;
  const auto open = [&] {
    BrickSet state(target.bricks());
    for (std::size_t i = 0; i < stands.size(); ++i) {
      if (stands[i]) state.add(i);
    }
    return in(state);
  };
  std::vector<std::pair<double, int>> out{{0, open()}};
  for (const BrickEvent& event : events) {
    const std::uint32_t brick = target.brick_at(event.cell);
    if (brick == TargetStates::kNone || led_of(rules, target.colour(brick)) != event.led) continue;
    stands[brick] = event.kind == BrickEvent::Kind::placed;
    out.emplace_back(event.time, open());
  }
  return out;
}

}  // namespace stig
