// SPDX-License-Identifier: MIT
// What several tests of the compiler share.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "compiler/compile.h"
#include "rules/rule_reader.h"
#include "support/uses.h"

namespace stig {

/// The paper's robot, by its published figures.
inline Abilities paper_robot() {
  Abilities robot;
  CarriedCamera camera;
  camera.intrinsics.fx = camera.intrinsics.fy = 883.961;
  camera.intrinsics.cx = 319.5;
  camera.intrinsics.cy = 179.5;
  // z ahead and 45° down, x to the robot's right.
  const Quat level = rotation({-M_PI / 2, 0, 0});  // z of C along y of R
  const Quat ahead = rotation({0, 0, -M_PI / 2}) * level;
  camera.X_RC = {{0.055755 + 0.0565, 0, 0.01975 + 0.09528}, ahead * rotation({-M_PI / 4, 0, 0})};
  robot.cameras = {camera};
  return robot;
}

inline RuleSet rule_set(const std::string& path) {
  Diagnostics diagnostics;
  auto rules = read_rule_set_file(path, diagnostics);
  REQUIRE_MESSAGE(rules, to_text(diagnostics));
  return *rules;
}
inline RuleSet shipped(const std::string& name) {
  return rule_set(STIG_SOURCE_DIR "/rulesets/" + name + ".yaml");
}

}  // namespace stig
