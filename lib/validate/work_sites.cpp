// SPDX-License-Identifier: MIT
#include "validate/work_sites.h"

#include <cassert>

#include "validate/build_site.h"

namespace stig::validate {

// Open sites are those of the compiled decisions in the structure as it stands; each event makes a
// new state, and asking is linear in the bricks.
std::vector<std::pair<double, int>> WorkSites::over(const std::vector<BrickEvent>& events,
                                                    const RuleSet& rules) const {
  assert(compiled_.target != nullptr);
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
    // A block that is no brick of the target, or of another colour, does not change what is open.
    if (brick == TargetStates::kNone || led_of(rules, target.colour(brick)) != event.led) continue;
    stands[brick] = event.kind == BrickEvent::Kind::placed;
    out.emplace_back(event.time, open());
  }
  return out;
}

}  // namespace stig::validate
