// SPDX-License-Identifier: MIT
// A hand can do what a script can, by the script's own functions, and mend besides. What comes from
// a trace is checked as what comes from a page: numbers may be anybody's.
#include "physical/simulation/hand_work.h"

#include <algorithm>

#include "physical/simulation/run_state.h"
#include "physical/simulation/scene_script.h"

namespace stig::physics {

namespace {

/// The block's place among blocks; nothing when the body is none, or has not come.
std::optional<std::size_t> block_place(const RunState& run, std::uint32_t body) {
  if (body >= run.world.size() || !run.placed.bodies[body].block) return std::nullopt;
  const auto begin = run.placed.bodies.begin();
  return static_cast<std::size_t>(
      std::count_if(begin, begin + body, [](const SceneBody& one) { return one.block; }));
}

std::string place_thing(RunState& run, const HandAction& action) {
  SceneScript script(run);
  if (action.robot) {
    return script.place(ScriptThing{true, action.number}, action.at, action.turn);
  }
  const auto place = block_place(run, action.number);
  if (!place) return "there is no such block";
  if (run.world.state(BodyId{action.number}).left) return "the block has left the arena";
  return script.place(ScriptThing{false, *place}, action.at, action.turn);
}

std::string drop_block(RunState& run, const HandAction& action) {
  std::string problem;
  const Pose X_WB{action.at, action.turn.value_or(Quat{})};
  if (SceneScript(run).drop(X_WB, problem)) return {};
  return problem;
}

}  // namespace

std::string work_by_hand(RunState& run, const HandAction& action) {
  if (action.robot && action.number >= run.scene->robots.size()) return "there is no such robot";
  switch (action.kind) {
    case HandKind::place:
      return place_thing(run, action);
    case HandKind::drop:
      return drop_block(run, action);
    case HandKind::halt:
      if (!action.robot) return "only robots break down";
      if (run.agents.crew()->failed(action.number)) return "it stands still already";
      run.agents.crew()->halt(action.number, run.world.tick());
      return {};
    case HandKind::mend:
      if (!action.robot) return "only robots are mended";
      if (run.agents.crew()->mend(action.number, run.world.tick())) return {};
      return run.agents.crew()->failed(action.number)
                 ? "its program has failed, which no hand can mend"
                 : "nothing is wrong with it";
  }
  return "there is no such work";
}

}  // namespace stig::physics
