// SPDX-License-Identifier: MIT
#include "validate/work_sites.h"

#include <cassert>
#include <numeric>

#include "validate/build_site.h"

namespace stig::validate {

// Open sites are those of the compiled decisions in the structures as they stand; each event makes
// a new state of one, and asking is linear in its bricks.
std::vector<std::pair<double, int>> WorkSites::over(const std::vector<BrickEvent>& events,
                                                    const BuildTarget& target) const {
  assert(compiled_.target != nullptr);
  const TargetStates& states = *compiled_.target;
  std::vector<bool> start(states.bricks());
  for (std::size_t i = 0; i < states.start_bricks(); ++i) start[i] = true;
  const auto open = [&](const std::vector<bool>& stands) {
    BrickSet state(states.bricks());
    for (std::size_t i = 0; i < stands.size(); ++i) {
      if (stands[i]) state.add(i);
    }
    return in(state);
  };
  std::vector<std::vector<bool>> standing(target.sites.size(), start);
  std::vector<int> sites(target.sites.size(), open(start));
  const auto sum = [&] { return std::accumulate(sites.begin(), sites.end(), 0); };
  std::vector<std::pair<double, int>> out{{0, sum()}};
  for (const BrickEvent& event : events) {
    const std::uint32_t brick = states.brick_at(event.cell);
    // A block that is no brick of the target, or of another colour, does not change what is open.
    if (brick == TargetStates::kNone || led_of(*target.rules, states.colour(brick)) != event.led) {
      continue;
    }
    std::vector<bool>& stands = standing[event.structure];
    stands[brick] = event.kind == BrickEvent::Kind::placed;
    sites[event.structure] = open(stands);
    out.emplace_back(event.time, sum());
  }
  return out;
}

}  // namespace stig::validate
