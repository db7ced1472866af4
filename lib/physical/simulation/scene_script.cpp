// SPDX-License-Identifier: MIT
// The world as a script finds it. Reading all blocks, with the lattices that they form, is done
// once a call and kept until the script changes something.
#include "physical/simulation/scene_script.h"

#include <cassert>

#include "physical/dynamics/ticks.h"
#include "physical/readout/lattice_reading.h"

namespace stig::physics {

// Blocks are numbered among themselves, robots by the scene.
SceneScript::SceneScript(RunState& run) : run_(run) {
  for (std::uint32_t i = 0; i < run.world.size(); ++i) {
    if (run.placed.bodies[i].block) bodies_.push_back(BodyId{i});
  }
}

double SceneScript::time() const { return run_.world.time(); }
std::uint64_t SceneScript::seed() const { return run_.placed.seed; }
std::size_t SceneScript::robots() const { return run_.scene->robots.size(); }

ScriptBlock SceneScript::block(std::size_t place) const {
  assert(place < bodies_.size());
  if (!read_) read();
  return (*read_)[place];
}

// Blocks that have left are in the list, so that numbers stay, but in no lattice.
void SceneScript::read() const {
  read_.emplace();
  std::vector<PlacedBlock> there;
  std::vector<std::size_t> places;
  for (const BodyId body : bodies_) {
    const auto number = static_cast<std::size_t>(body);
    const BodyState state = run_.world.state(body);
    const auto colour = static_cast<std::uint8_t>(led_of(run_, number));
    if (!state.left) {
      places.push_back(read_->size());
      there.push_back({state.X_WB, colour});
    }
    ScriptBlock one;
    one.name = run_.placed.bodies[number].name;
    one.X_WB = state.X_WB;
    one.colour = colour;
    one.left = state.left;
    one.faces = faces_of(run_, number);
    read_->push_back(std::move(one));
  }
  if (there.empty()) return;
  const auto structure = read_lattices(there, run_.scene->models.front().side);
  for (std::size_t i = 0; i < structure.lattices.size(); ++i) {
    for (const ReadBlock& block : structure.lattices[i].blocks) {
      ScriptBlock& out = (*read_)[places[block.block]];
      // Lattices count from 1: 0 is none.
      out.lattice = static_cast<int>(i) + 1;
      out.x = block.cell.x;
      out.y = block.cell.y;
      out.z = block.cell.z;
    }
  }
}

ScriptRobot SceneScript::robot(std::size_t place) const {
  assert(place < robots());
  const Crew& crew = *run_.agents.crew();
  return {crew.robot_name(place), crew.robot_pose(run_.world, place), crew.failed(place),
          crew.halted(place), run_.odometer.driven(place)};
}

// Blocks first; no name is that of both (place_scene.cpp checks).
std::optional<ScriptThing> SceneScript::find(std::string_view name) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (run_.placed.bodies[static_cast<std::size_t>(bodies_[i])].name == name) {
      return ScriptThing{false, i};
    }
  }
  for (std::size_t i = 0; i < robots(); ++i) {
    if (run_.agents.crew()->robot_name(i) == name) return ScriptThing{true, i};
  }
  return std::nullopt;
}

BodyId SceneScript::body_of(ScriptThing thing) const {
  assert(thing.place < (thing.robot ? robots() : bodies_.size()));
  return thing.robot ? run_.agents.crew()->root_body(thing.place) : bodies_[thing.place];
}

bool SceneScript::push(ScriptThing thing, const Vec3& force, double seconds) {
  return run_.pushes.add(run_, body_of(thing), force, ticks_in(seconds, run_.placed.config.step));
}

/// The name that the scene has for a body; a robot's part is called by robot and part.
std::string SceneScript::name_of(BodyId body) const {
  return "'" + run_.placed.bodies[static_cast<std::size_t>(body)].name + "'";
}

std::string SceneScript::place(ScriptThing thing, const Vec3& at, const std::optional<Quat>& turn) {
  const BodyId body = body_of(thing);
  const auto& bodies = run_.placed.config.bodies;
  const auto number = static_cast<std::size_t>(body);
  // Only the scene's own blocks can be fixed.
  if (number < bodies.size() && bodies[number].fixed) return "it is fixed in the world";
  // A robot is placed by its own frame, the world by its root body's.
  const Pose X_BF = thing.robot ? inverse(run_.agents.crew()->root_pose(thing.place)) : Pose{};
  const Pose now = run_.world.state(body).X_WB * X_BF;
  const PlaceResult placed = run_.world.place(body, Pose{at, turn.value_or(now.q)} * inverse(X_BF));
  if (placed.overlaps) {
    return name_of(placed.body) + " would overlap " + name_of(placed.other);
  }
  if (!placed.problem.empty()) return placed.problem;
  read_.reset();
  // A hand that carries it is no way that it has come.
  if (thing.robot) run_.odometer.put_down(thing.place, at);
  return {};
}

void SceneScript::halt(std::size_t robot) { run_.agents.crew()->halt(robot, run_.world.tick()); }

void SceneScript::set_colour(std::size_t block, int colour) {
  run_.agents.crew()->set_colour(block_of(block), static_cast<Led>(colour));
  read_.reset();
}

/// The crew's number of a block.
std::size_t SceneScript::block_of(std::size_t place) const {
  assert(place < bodies_.size());
  return run_.agents.crew()->block_of(bodies_[place]);
}

void SceneScript::set_camera(std::size_t robot, bool alive) {
  run_.agents.crew()->set_dark(robot, !alive);
}

void SceneScript::set_radio(ScriptThing thing, bool alive) {
  Crew& crew = *run_.agents.crew();
  if (thing.robot) return crew.set_radio(thing.place, alive);
  crew.set_radio_of_block(block_of(thing.place), alive);
}

void SceneScript::set_leds(std::size_t block, std::uint32_t which, bool alive) {
  run_.agents.crew()->set_leds(block_of(block), which, alive);
  read_.reset();
}

// Bodies of blocks, of obstacles, and of robots, whose parts a program does not know by name.
bool SceneScript::set_friction(std::string_view body, double factor) {
  for (std::uint32_t i = 0; i < run_.world.size(); ++i) {
    if (run_.placed.bodies[i].name != body) continue;
    run_.world.set_grip(BodyId{i}, factor);
    return true;
  }
  return false;
}

std::optional<std::size_t> SceneScript::drop(const Pose& X_WB, std::string& problem) {
  bool used_up = false;
  const AddResult added = run_.supply.drop(run_, X_WB, used_up);
  if (used_up) {
    problem = "the scene's stock is used up";
    return std::nullopt;
  }
  problem = added.overlaps ? "it would overlap " + name_of(added.other) : added.problem;
  // The one body of the addition.
  constexpr std::string_view kIs = "body 0 is ";
  // The world names bodies by their numbers; to the script there is only one.
  if (problem.starts_with(kIs)) problem.replace(0, kIs.size(), "it would be ");
  if (!problem.empty()) return std::nullopt;
  bodies_.push_back(added.body);
  read_.reset();
  return bodies_.size() - 1;
}

void SceneScript::stop(std::string reason) {
  run_.stop = true;
  run_.message = std::move(reason);
}
void SceneScript::measure(std::string name, double value) {
  run_.script.measure(std::move(name), value);
}

}  // namespace stig::physics
