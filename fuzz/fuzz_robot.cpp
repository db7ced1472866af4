// SPDX-License-Identifier: MIT
// Any bytes as a robot file: diagnostics, or a robot whose parts all refer to what is there.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "robots/robot_reader.h"
#include "support/uses.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  stig::Diagnostics diagnostics;
  // A file that the robot names is the input once more, so that solids are read too.
  const auto robot = stig::read_robot(
      std::make_shared<stig::SourceFile>("input", text), diagnostics,
      [&text](const std::string&, std::size_t, stig::FileError&) { return std::optional(text); });
  require(robot.has_value() != diagnostics.has_errors());
  stig::to_text(diagnostics);
  if (!robot) return 0;

  const std::size_t bodies = robot->bodies.size();
  require(robot->joints.size() + 1 == bodies && robot->root() < bodies);
  require(robot->mass() > 0 && stig::is_finite(robot->centre_of_mass()));
  for (const auto& body : robot->bodies) {
    require(body.mass > 0 && stig::is_finite(stig::moments_of(body)));
  }
  for (const auto& joint : robot->joints) require(joint.parent < bodies && joint.child < bodies);
  for (const auto& camera : robot->cameras) {
    require(camera.near < camera.far);
    require(std::abs(stig::length(stig::rotate(camera.X_BC.q, {0, 0, 1})) - 1) < 1e-9);
  }
  stig::DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (stig::ListedKind<Kind>) {
      for (const auto& device : Kind::devices(*robot)) {
        if constexpr (requires { device.body; }) require(device.body < bodies);
      }
    }
  });
  for (const auto& actuator : robot->actuators) {
    require(actuator.axis.axis < robot->joints.at(actuator.axis.joint).axes.size());
  }
  return 0;
}
