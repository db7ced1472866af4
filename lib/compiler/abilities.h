// SPDX-License-Identifier: MIT
// What a robot can do and see, in the numbers that the compiler asks for. They are computed
// from the robot's and the block's files, none is a constant of this program.
//
// Frame R: the robot's, on the floor, x ahead. Lengths in m, forces in N.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"
#include "compiler/uses.h"
#include "robots/robot_model.h"
#include "sensing/camera.h"

namespace stig::compiler {

/// The block as cameras see it: a cube with a tag in the middle of every face and four LEDs
/// around it.
struct BlockLook {
  double side = 0.055;
  double tag_side = 0.024;
  double proud = 0.001;       ///< of the tag, before the face
  double led_place = 0.02;    ///< from the face's centre along its axes
  double most_angle = 1.309;  ///< rad, between a face's normal and the line to the camera
  int leds_needed = 1;        ///< of a face, in view, for its brick's kind to be known
};

/// A camera, and whether it rides on the lift.
struct CarriedCamera {
  CameraIntrinsics intrinsics;
  Pose X_RC;  ///< with the lift at its lowest
  double near = 0.05, far = 0.5;
  bool lifted = true;
};

/// What the block's file says of it, and what its magnets do.
struct BlockFigures {
  BlockLook look;
  double mass = 0.110;
  double magnet_offset = 0.0225;  ///< of a magnet from the middle, along each axis
  double magnet_moment = 0.199;   ///< A·m²
  double magnet_cutoff = 0.040;   ///< m, between two magnets; farther apart they ignore each other
  double block_friction = 0.2, floor_friction = 0.4;
  bool answers = false;  ///< what it is told by radio
};

struct Abilities {
  BlockLook block;
  double block_weight = 1.08;
  /// Levels on which it can put down a block: the lift must raise it so far and a little more.
  int levels = 3;
  double lift_travel = 0.1375;
  double lowest = 0.00075;   ///< of a carried block's bottom above the floor, the lift down
  double clearance = 0.003;  ///< over a support, before a block is let down
  /// The carried block's centre ahead of R, and what of the robot stands behind and beside it.
  double carried_x = 0.0938;
  double body_front = 0.058;  ///< x of the foremost part that cannot be above a structure
  double body_back = 0.0738;  ///< how far it goes back behind R
  double body_half_width = 0.0438;
  /// The end-effector over the carried block, which sticks out beyond it.
  double effector_front = 0.1298, effector_half_width = 0.030;
  /// A gap between two blocks that their magnets close by themselves.
  double magnet_reach = 0.010;
  /// What the magnets of one pair of faces hold, pulled straight.
  double face_hold = 9.5;
  double friction = 0.2;  ///< block on block
  bool answers = false;   ///< a block, when the robot's radio tells it a colour
  std::vector<CarriedCamera> cameras;

  /// Height of the lift at which a carried block clears the bricks below a level.
  double lift_for(int level) const { return level * block.side + clearance - lowest; }
};

/// What keeps a robot from building at all, each a sentence; empty: nothing.
std::vector<std::string> lacking(const RobotModel& robot);
/// The abilities of a robot that lacks nothing.
Abilities abilities_of(const RobotModel& robot, const BlockFigures& block);

}  // namespace stig::compiler
