// SPDX-License-Identifier: MIT
// What robots would do in a given structure, from the compiled decision alone. Used by
// simulations and reports; it has to agree with what the emitted program does. After a walk
// the structure is looked up; after a local proof the view is computed anew.
#include "compiler/open_work.h"

#include <algorithm>
#include <cassert>

#include "compiler/columns.h"

namespace stig::compiler {

OpenWork::OpenWork(const CompiledRules& compiled) : compiled_(compiled) {
  assert(compiled.decision != nullptr);
  if (compiled.local_situations > 0) {
    sight_.emplace(*compiled.target, compiled.visibility);
    return;
  }
  const std::vector<BrickSet>& states = compiled.policy.states;
  for (std::uint32_t i = 0; i < states.size(); ++i) numbers_.emplace(states[i], i);
}

std::map<std::uint32_t, ApproachSide> OpenWork::in(const BrickSet& state) const {
  return in(state, compiled_.sides);
}

std::map<std::uint32_t, ApproachSide> OpenWork::in(const BrickSet& state,
                                                   const std::vector<ApproachSide>& sides) const {
  return sight_ ? by_looking(state, sides) : by_the_walk(state, sides);
}

bool OpenWork::knows(const BrickSet& state) const { return sight_ || numbers_.contains(state); }

std::map<std::uint32_t, ApproachSide> OpenWork::by_the_walk(
    const BrickSet& state, const std::vector<ApproachSide>& sides) const {
  std::map<std::uint32_t, ApproachSide> out;
  const auto found = numbers_.find(state);
  if (found == numbers_.end()) return out;
  const Policy& policy = compiled_.policy;
  for (std::size_t i = policy.first[found->second]; i < policy.first[found->second + 1]; ++i) {
    const Situation& here = policy.situations[i];
    if (std::find(sides.begin(), sides.end(), here.side) == sides.end()) continue;
    const auto wish = decide(*compiled_.decision, policy.observations[here.observation]);
    for (const auto& [placement, to] : here.placements) {
      if (wish != placement) continue;
      out.emplace(brick_added(state, policy.states[to], compiled_.target->bricks()), here.side);
    }
  }
  return out;
}

/// A column may offer several bricks; a robot's decision picks one.
std::map<std::uint32_t, ApproachSide> OpenWork::by_looking(
    const BrickSet& state, const std::vector<ApproachSide>& sides) const {
  std::map<std::uint32_t, ApproachSide> out;
  for (const ApproachSide side : sides) {
    for (const auto& [v, u] : columns_before(*compiled_.target, state, side)) {
      if (const auto brick = decided(state, side, u, v)) out.emplace(*brick, side);
    }
  }
  return out;
}

std::optional<std::uint32_t> OpenWork::decided(const BrickSet& state, ApproachSide side, int u,
                                               int v) const {
  Observation seen = sight_->look(state, side, u, v);
  seen.side = side;
  const auto wish = decide(*compiled_.decision, seen);
  if (!wish) return std::nullopt;
  const TargetStates& target = *compiled_.target;
  for (const std::uint32_t brick : bricks_about(target, side, u, v)) {
    // The decision names a place and a colour; the brick is the one that the target has
    // there.
    if (state.has(brick) || target.colour(brick) != wish->colour) continue;
    auto where = next_to_column(target, state, side, u, v, brick);
    if (where && where->du == 0 && where->dv == 0) where->z = 0;
    if (where == wish->at && target.rule_for(state, brick)) return brick;
  }
  return std::nullopt;
}

}  // namespace stig::compiler
