// SPDX-License-Identifier: MIT
// A robot as its file says it (robots/*.yaml): bodies, joints, sensors and devices with their
// places. Data, not code: a user describes a new robot without compiling anything.
//
// Frames: R is the robot's, on the floor under it, x ahead, y left, z up. Poses are those with
// every joint at zero. Lengths in m, masses in kg, angles in rad.
//
// Devices name the joints and bodies they use; indices are places in the lists below. Lists of
// devices are members that each kind brings (device_kinds.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/rgb.h"
#include "base/source.h"
#include "base/vec.h"
#include "robots/device_kinds.h"
#include "robots/solid.h"
#include "robots/uses.h"

namespace stig::robots {

enum class ShapeType : std::uint8_t { box, cylinder, sphere, hull };

/// The place of a body or joint that is not there; only while a file with errors is read.
inline constexpr std::size_t kNoBody = SIZE_MAX;

struct BodyModel {
  std::string name;
  ShapeType shape = ShapeType::box;
  Vec3 size;  ///< edges of a box; of a cylinder (along z): diameter, diameter, height;
              ///< of a sphere: its diameter, thrice
  std::vector<Vec3> points;  ///< of a hull, body frame
  double mass = 0;
  std::optional<Vec3> inertia;   ///< principal moments, kg·m²; otherwise those of the solid
  Pose X_RB;                     ///< of the shape's centre, which is that of its mass
  Vec3 p_BO;                     ///< the origin that the file measures devices from: its base
  std::string material;          ///< of the scene's friction table
  Vec3 axle;                     ///< unit, body frame, of a wheel that slides along it; or 0
  double axle_friction = 1;      ///< part of the friction that acts along the axle
  bool rolls_as_sphere = false;  ///< a cylinder that touches others as a ball of its radius
  Rgb rgb{0xb0, 0xb0, 0xb0};
  std::shared_ptr<const VisualMesh> visual;  ///< what is looked at in place of the shape; or null
  SourceRange place;                         ///< where the file says so
};

enum class ActuatorMode : std::uint8_t { none, velocity, position, force };

struct AxisModel {
  bool angular = true;
  Vec3 axis{0, 0, 1};  ///< unit, joint frame
  std::optional<double> lower, upper;
  ActuatorMode actuator = ActuatorMode::none;
  double most_force = 0;  ///< N or N·m
  double most_speed = 0;  ///< of position mode, m/s or rad/s; 0: what the step allows
  double damping = 0;     ///< N·s/m or N·m·s/rad
};

/// Without axes the child is fixed to the parent.
struct JointModel {
  std::string name;
  std::size_t parent = 0, child = 0;
  Pose X_RJ;  ///< the joint's frame
  std::vector<AxisModel> axes;
  SourceRange place;
};

struct RobotModel : DeviceKinds::Devices {
  std::string name, title, source;
  double control_period = 0.2;  ///< s
  std::vector<BodyModel> bodies;
  std::vector<JointModel> joints;
  std::string program;  ///< path of its Lua program as the file says it, or empty

  double mass() const;
  /// In frame R, with every joint at zero.
  Vec3 centre_of_mass() const;
  /// The body that no joint carries.
  std::size_t root() const;
};

/// Of the shape, m³.
double volume_of(const BodyModel& body);

/// A solid's moments about its centre and the body's axes, or those that the file gives, kg·m².
/// Principal moments; products of inertia of a hull that is askew are left out.
Vec3 moments_of(const BodyModel& body);

}  // namespace stig::robots
