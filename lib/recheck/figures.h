// SPDX-License-Identifier: MIT
// What the checker asks of a robot and of a block, worked out from their files anew. Lengths in m,
// angles in rad; frame R is the robot's, x ahead.
#pragma once

#include <vector>

#include "base/vec.h"
#include "recheck/uses.h"
#include "robots/block.h"
#include "robots/robot_model.h"
#include "sensing/camera.h"

namespace stig::recheck {

struct Eye {
  CameraIntrinsics intrinsics;
  Pose X_RC;  ///< with the lift at its lowest
  double near = 0, far = 0;
  bool lifted = false;
};

struct Figures {
  double side = 0;      ///< of a block
  double tag_side = 0;  ///< of the tag in the middle of each face
  double tag_proud = 0;
  double led_place = 0;      ///< from a face's middle, four ways
  double widest = 0;         ///< angle at which tag and LEDs are seen
  int leds_needed = 1;       ///< of a face, for its brick's kind to be known
  double lift_travel = 0;    ///< m
  double lowest_bottom = 0;  ///< of a carried block, with the lift down
  double carried_x = 0;      ///< of its middle
  double body_front = 0, body_back = 0, body_half_width = 0;
  double effector_front = 0, effector_half_width = 0;
  double magnets_close = 0;  ///< widest gap between faces that the magnets close
  std::vector<Eye> eyes;

  /// Can a block be put on this level?
  bool reaches(int level) const;
  /// Levels that can be reached.
  int levels() const;
  /// Rows to either side of its own that the body reaches into.
  int rows_beside() const;
};

/// Of a robot with lift, magnets and a camera.
Figures figures_of(const RobotModel& robot, const BlockModel& block);

}  // namespace stig::recheck
