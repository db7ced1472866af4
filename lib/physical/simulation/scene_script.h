// SPDX-License-Identifier: MIT
// A run as its scene's script sees it.
#pragma once

#include "lua/lua_script.h"
#include "physical/simulation/run_state.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

/// For one call of the script: blocks' numbers and lattices are read when first asked for.
class SceneScript final : public ScriptWorld {
 public:
  explicit SceneScript(RunState& run);

  double time() const override;
  std::uint64_t seed() const override;
  std::size_t blocks() const override { return bodies_.size(); }
  ScriptBlock block(std::size_t place) const override;
  std::size_t robots() const override;
  ScriptRobot robot(std::size_t place) const override;
  std::optional<ScriptThing> find(std::string_view name) const override;
  bool push(ScriptThing thing, const Vec3& force, double seconds) override;
  std::string place(ScriptThing thing, const Vec3& at, const std::optional<Quat>& turn) override;
  void halt(std::size_t robot) override;
  void set_colour(std::size_t block, int colour) override;
  void set_camera(std::size_t robot, bool alive) override;
  void set_radio(ScriptThing thing, bool alive) override;
  void set_leds(std::size_t block, std::uint32_t which, bool alive) override;
  bool set_friction(std::string_view body, double factor) override;
  std::optional<std::size_t> drop(const Pose& X_WB, std::string& problem) override;
  void stop(std::string reason) override;
  void measure(std::string name, double value) override;

 private:
  void read() const;
  BodyId body_of(ScriptThing thing) const;
  std::size_t block_of(std::size_t place) const;
  std::string name_of(BodyId body) const;

  RunState& run_;
  std::vector<BodyId> bodies_;  ///< of blocks
  mutable std::optional<std::vector<ScriptBlock>> read_;
};

}  // namespace stig::physics
