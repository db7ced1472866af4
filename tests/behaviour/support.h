// SPDX-License-Identifier: MIT
// Scenes with robots, run and measured.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/degree.h"
#include "physical/simulation/loaded_scene.h"
#include "physical/simulation/simulation.h"
#include "support/uses.h"

namespace stig::behaviour {

/// A scene of this text, which finds robots, blocks, programs and the tests' own controllers.
LoadedScene scene_of(const std::string& text, std::uint64_t seed = 1);

/// A scene that runs, with what its programs have said.
class Trial {
 public:
  explicit Trial(const std::string& text, std::uint64_t seed = 1,
                 const ControllerFactory& controllers = lua_controllers());
  /// Until `seconds` have passed, or a program has said a line that holds `words`.
  bool until(double seconds, const std::string& words = "");
  bool said(const std::string& words) const;
  /// Everything said, for messages.
  std::string log() const;
  Pose robot(std::size_t number = 0) const;
  bool failed(std::size_t number = 0) const { return run_.crew()->failed(number); }
  Pose block(const std::string& name) const;
  Led led(const std::string& name) const;
  /// By number, with those that caches have dropped.
  std::size_t blocks() const { return run_.crew()->blocks(); }
  Pose block(std::size_t number) const;
  Led block_led(std::size_t number) const { return run_.crew()->colour(number); }
  const World& world() const { return run_.world(); }

 private:
  std::size_t body(const std::string& name) const;

  LoadedScene loaded_;
  Simulation run_;
  std::vector<CrewLine> lines_;
};

/// Turn about z, rad.
double heading(const Pose& pose);
/// Between the z axis and the body's, rad.
double tilt(const Pose& pose);
/// To the nearest quarter turn, rad, signed.
double off_square(double angle);

}  // namespace stig::behaviour
