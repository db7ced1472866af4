// SPDX-License-Identifier: MIT
#include "physical/simulation/scene_script.h"

#include <algorithm>
#include <cmath>

namespace stig {

namespace {

constexpr std::size_t kMostPushes = 1000;  ///< at a time

}  // namespace

SceneScript::SceneScript(Simulation& run) : run_(run) {
  for (std::uint32_t i = 0; i < run.world_.size(); ++i) {
    if (run.placed_.bodies[i].block) bodies_.push_back(BodyId{i});
  }
}

double SceneScript::time() const { return run_.world_.time(); }
std::uint64_t SceneScript::seed() const { return run_.placed_.seed; }
std::size_t SceneScript::robots() const { return run_.crew_ ? run_.crew_->robots() : 0; }

ScriptBlock SceneScript::block(std::size_t place) const {
  if (!read_) read();
  return (*read_)[place];
}

void SceneScript::read() const {
  read_.emplace();
  std::vector<PlacedBlock> there;
  std::vector<std::size_t> places;
  for (const BodyId body : bodies_) {
    const auto number = static_cast<std::size_t>(body);
    const BodyState state = run_.world_.state(body);
    const auto colour = static_cast<std::uint8_t>(run_.led(number));
    if (!state.left) {
      places.push_back(read_->size());
      there.push_back({state.X_WB, colour});
    }
    ScriptBlock one;
    one.name = run_.placed_.bodies[number].name;
    one.X_WB = state.X_WB;
    one.colour = colour;
    one.left = state.left;
    one.faces = run_.faces(number);
    read_->push_back(std::move(one));
  }
  if (there.empty()) return;
  const auto structure = read_lattices(there, run_.scene_->models.front().side);
  for (std::size_t i = 0; i < structure.lattices.size(); ++i) {
    for (const ReadBlock& block : structure.lattices[i].blocks) {
      ScriptBlock& out = (*read_)[places[block.block]];
      out.lattice = static_cast<int>(i) + 1;
      out.x = block.cell.x;
      out.y = block.cell.y;
      out.z = block.cell.z;
    }
  }
}

ScriptRobot SceneScript::robot(std::size_t place) const {
  const Crew& crew = *run_.crew_;
  return {crew.robot_name(place), crew.robot_pose(run_.world_, place), crew.failed(place),
          crew.halted(place), run_.driven_[place]};
}

std::optional<ScriptThing> SceneScript::find(std::string_view name) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (run_.placed_.bodies[static_cast<std::size_t>(bodies_[i])].name == name) {
      return ScriptThing{false, i};
    }
  }
  for (std::size_t i = 0; i < robots(); ++i) {
    if (run_.crew_->robot_name(i) == name) return ScriptThing{true, i};
  }
  return std::nullopt;
}

BodyId SceneScript::body_of(ScriptThing thing) const {
  return thing.robot ? run_.crew_->root_body(thing.place) : bodies_[thing.place];
}

bool SceneScript::push(ScriptThing thing, const Vec3& force, double seconds) {
  if (run_.pushes_.size() >= kMostPushes) return false;
  const double ticks = std::max(1.0, std::round(seconds / run_.placed_.config.step));
  run_.pushes_.push_back({static_cast<std::uint32_t>(body_of(thing)), force,
                          run_.world_.tick() + static_cast<std::uint64_t>(ticks)});
  return true;
}

/// Of robots' parts: robot and part.
std::string SceneScript::name_of(BodyId body) const {
  return "'" + run_.placed_.bodies[static_cast<std::size_t>(body)].name + "'";
}

std::string SceneScript::place(ScriptThing thing, const Vec3& at, const std::optional<Quat>& turn) {
  const BodyId body = body_of(thing);
  const auto& bodies = run_.placed_.config.bodies;
  const auto number = static_cast<std::size_t>(body);
  if (number < bodies.size() && bodies[number].fixed) return "it is fixed in the world";
  const Pose X_BF = thing.robot ? inverse(run_.crew_->root_pose(thing.place)) : Pose{};
  const Pose now = run_.world_.state(body).X_WB * X_BF;
  const PlaceResult placed =
      run_.world_.place(body, Pose{at, turn.value_or(now.q)} * inverse(X_BF));
  if (placed.overlaps) {
    return name_of(placed.body) + " would overlap " + name_of(placed.other);
  }
  if (!placed.problem.empty()) return placed.problem;
  read_.reset();
  // A hand that carries it is no way that it has come.
  if (thing.robot) run_.last_places_[thing.place] = {at.x, at.y, 0};
  return {};
}

void SceneScript::halt(std::size_t robot) { run_.crew_->halt(robot, run_.world_.tick()); }

void SceneScript::set_colour(std::size_t block, int colour) {
  run_.crew_->set_colour(run_.crew_->block_of(bodies_[block]), static_cast<Led>(colour));
  read_.reset();
}

std::optional<std::size_t> SceneScript::drop(const Pose& X_WB, std::string& problem) {
  std::size_t& dropped = run_.dropped_.back();
  if (dropped == run_.scene_->stock) {
    problem = "the scene's stock is used up";
    return std::nullopt;
  }
  const AddResult added = run_.add_block(X_WB);
  problem = added.overlaps ? "it would overlap " + name_of(added.other) : added.problem;
  // The one body of the addition.
  constexpr std::string_view kIs = "body 0 is ";
  if (problem.starts_with(kIs)) problem.replace(0, kIs.size(), "it would be ");
  if (!problem.empty()) return std::nullopt;
  ++dropped;
  bodies_.push_back(added.body);
  read_.reset();
  return bodies_.size() - 1;
}

void SceneScript::stop(std::string reason) {
  run_.stop_ = true;
  run_.message_ = std::move(reason);
}
void SceneScript::measure(std::string name, double value) {
  run_.measures_[std::move(name)] = value;
}

}  // namespace stig
