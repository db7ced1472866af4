// SPDX-License-Identifier: MIT
// A run as its scene's script sees it.
#pragma once

#include "controllers/lua_script.h"
#include "physical/lattice_reading.h"
#include "physical/simulation.h"

namespace stig {

/// For one call of the script: blocks' numbers and lattices are read when first asked for.
class SceneScript final : public ScriptWorld {
 public:
  explicit SceneScript(Simulation& run);

  double time() const override;
  std::uint64_t seed() const override;
  std::size_t blocks() const override { return bodies_.size(); }
  ScriptBlock block(std::size_t place) const override;
  std::size_t robots() const override;
  ScriptRobot robot(std::size_t place) const override;
  void push_block(std::size_t place, const Vec3& force) override;
  void push_robot(std::size_t place, const Vec3& force) override;
  std::optional<std::size_t> drop(const Pose& X_WB, std::string& problem) override;
  void stop(std::string reason) override;
  void measure(std::string name, double value) override;

 private:
  void read() const;

  Simulation& run_;
  std::vector<BodyId> bodies_;  ///< of blocks
  mutable std::optional<std::vector<ScriptBlock>> read_;
};

}  // namespace stig
