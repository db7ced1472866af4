// SPDX-License-Identifier: MIT
// A scene of blocks that only fall needs no crew, and runs without its costs. Whether one is needed
// is asked before: of robots, of a script, of programs of blocks, and of blocks that may come.
#include "physical/simulation/run_agents.h"

#include <algorithm>
#include <cassert>

#include "physical/scene/scene_crew.h"
#include "physical/simulation/run_state.h"

namespace stig::physics {

namespace {

/// Whether a block of the scene has a controller, or one that may come will have. The first of
/// those speaks for all, since they are of one kind.
bool blocks_act(const Scene& scene, const PlacedScene& placed, const CrewConfig& crew,
                const ControllerFactory& controllers) {
  const std::size_t first = placed.config.bodies.size();
  return std::any_of(scene.block_programs.begin(), scene.block_programs.end(),
                     [](std::size_t program) { return program != RobotSpawn::kNoProgram; }) ||
         std::any_of(crew.blocks.begin(), crew.blocks.end(),
                     [](const CrewBlock& block) { return block.controller != nullptr; }) ||
         (first < placed.bodies.size() &&
          crew_block(scene, placed, first, controllers).controller != nullptr);
}

/// The number of a body's block; nothing when it is none, or there is no crew.
std::optional<std::size_t> block_at(const Crew* crew, std::size_t body) {
  if (crew == nullptr) return std::nullopt;
  const std::size_t block = crew->block_of(BodyId{static_cast<std::uint32_t>(body)});
  return block < crew->blocks() ? std::optional(block) : std::nullopt;
}

}  // namespace

RunAgents::RunAgents(const Scene& scene, const PlacedScene& placed, bool resumable,
                     const ControllerFactory& controllers) {
  // A script may colour blocks.
  const bool script = scene.script != RobotSpawn::kNoProgram;
  CrewConfig crew = crew_of(scene, placed, controllers);
  if (!script && scene.robots.empty() && !blocks_act(scene, placed, crew, controllers)) return;
  crew.resumable = resumable;
  crew_.emplace(std::move(crew), placed.config);
}

void RunAgents::add(const RunState& run, std::size_t body) {
  if (!crew_) return;
  const BlockModel& model = run.scene->models[run.scene->stock_model];
  crew_->add(crew_block(*run.scene, run.placed, body, run.controllers),
             block_body(model, {}).shape);
}

void RunAgents::before_step(RunState& run, const RunHooks& hooks) {
  if (!crew_) return;
  crew_->before_step(run.world);
  for (const CrewLine& line : crew_->take_log()) {
    if (hooks.on_line) hooks.on_line(line);
    run.recorder.note(run, line);
  }
}

// An empty text where there is no crew.
void RunAgents::save(BytesOut& out) const { out(crew_ ? crew_->checkpoint() : std::string()); }

bool RunAgents::load(BytesIn& in, RunState& run) {
  std::string programs;
  in(programs);
  if (!in.good()) return false;
  if (!crew_) return programs.empty();
  // Blocks that came before the checkpoint come again, in their order, for the crew to know them.
  for (std::size_t i = run.placed.config.bodies.size(); i < run.world.size(); ++i) add(run, i);
  if (!crew_->resume(programs)) return false;
  // Their colours are in the trace already.
  crew_->take_changed();
  return true;
}

Led led_of(const RunState& run, std::size_t body) {
  assert(body < run.placed.bodies.size());
  const Crew* crew = run.agents.crew();
  if (crew == nullptr || body >= run.world.size()) return run.placed.bodies[body].colour;
  const auto block = block_at(crew, body);
  return block ? crew->colour(*block) : Led::off;
}

std::array<int, 6> faces_of(const RunState& run, std::size_t body) {
  // What has no LEDs of its own shows one colour all round.
  std::array<int, 6> out{};
  out.fill(static_cast<int>(led_of(run, body)));
  const auto block = block_at(run.agents.crew(), body);
  if (!block) return out;
  const auto& leds = run.agents.crew()->leds(*block);
  for (std::size_t face = 0; face < out.size(); ++face) {
    std::array<int, 5> shown{};
    // Four LEDs a face, in the order of its radios; among equals the lowest colour.
    for (std::size_t i = 0; i < 4; ++i) ++shown[static_cast<std::size_t>(leds[4 * face + i])];
    out[face] = static_cast<int>(std::max_element(shown.begin(), shown.end()) - shown.begin());
  }
  return out;
}

}  // namespace stig::physics
