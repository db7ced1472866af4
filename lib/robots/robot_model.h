// SPDX-License-Identifier: MIT
// A robot as its file says it (robots/*.yaml): bodies, joints, sensors and devices with their
// places. Data, not code: a user describes a new robot without compiling anything.
//
// Frames: R is the robot's, on the floor under it, x ahead, y left, z up. Poses are those with
// every joint at zero. Lengths in m, masses in kg, angles in rad.
//
// Devices name the joints and bodies they use; indices here are places in the lists below.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/rgb.h"
#include "base/source.h"
#include "base/vec.h"
#include "sensing/camera.h"

namespace stig {

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
  SourceRange place;  ///< where the file says so
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

/// One axis of one joint.
struct AxisRef {
  std::size_t joint = 0, axis = 0;
};

struct DriveModel {
  std::vector<AxisRef> left, right;  ///< wheels, positive forwards
  double wheel_radius = 0, track = 0;
  double most_speed = 0, most_acceleration = 0;  ///< of the rims, m/s and m/s²
};

struct LiftModel {
  AxisRef axis;
  double low = 0, high = 0;   ///< m: where the limit switches close
  double tolerance = 0;       ///< error at which it rests
  double inactive_below = 0;  ///< error under which it reports that it has arrived
  /// Speed by error: the first entry whose error is exceeded; in falling order of errors.
  std::vector<std::pair<double, double>> speeds;
};

/// Electromagnets of the end-effector, one circuit: charge follows its own dynamics, the
/// current is the charge while discharging, with the mode's sign.
struct MagnetCircuitModel {
  struct Pole {
    std::size_t body = 0;
    Vec3 p_B;        ///< of the dipole, body frame
    Vec3 direction;  ///< unit, body frame
  };
  std::vector<Pole> poles;
  double passive = 0, active = 0;  ///< field = passive + active · current, the paper's unit
  // How the charge changes: robot_devices.h, for both generations.
  double charge_limit = 0;
  double charge_per_second = 0;          ///< linear charging (G17)
  double discharge_per_second = 0;       ///< exponential: charge' = -rate · charge (G17)
  double relax_rate = 0;                 ///< exponential charging towards the limit (G21)
  double sink_rate = 0, sink_level = 0;  ///< while discharging: -sink_rate (charge - level) (G21)
};

struct CameraDevice {
  std::string name;
  std::size_t body = 0;
  Pose X_BC;  ///< optical frame: z ahead, x right, y down
  CameraIntrinsics intrinsics;
  double near = 0.05, far = 0.5;
};

struct RangeDevice {
  std::string name;  ///< '1' … '12', 'left', …
  std::size_t body = 0;
  Vec3 p_B, direction;
  double range = 0.2;
  /// Counts = a · v^b or c0 + c1 v + c2 v², v = exp(-distance); metres: the distance itself.
  enum class Calibration : std::uint8_t { metres, power, quadratic };
  Calibration calibration = Calibration::metres;
  std::array<double, 3> coefficients{};
};

/// What it reads when nothing is in reach: its range, or no counts.
double without_hit(const RangeDevice& device);

struct RadioDevice {
  std::string name;
  std::size_t body = 0;
  Vec3 p_B;
  double range = 0.02;
};

struct LedDevice {
  std::string name;
  std::size_t body = 0;
  Vec3 p_B;
};

/// A joint's axis that the controller drives itself, under a name.
struct ActuatorDevice {
  std::string name;
  AxisRef axis;
};

struct RobotModel {
  std::string name, title, source;
  double control_period = 0.2;  ///< s
  std::vector<BodyModel> bodies;
  std::vector<JointModel> joints;
  std::optional<DriveModel> drive;
  std::optional<LiftModel> lift;
  std::optional<MagnetCircuitModel> magnets;
  std::vector<CameraDevice> cameras;
  std::vector<RangeDevice> rangefinders;
  std::vector<RadioDevice> radios;
  std::vector<LedDevice> leds;
  std::vector<ActuatorDevice> actuators;
  std::string program;  ///< path of its Lua program as the file says it, or empty

  double mass() const;
  /// In frame R, with every joint at zero.
  Vec3 centre_of_mass() const;
  /// The body that no joint carries.
  std::size_t root() const;
};

/// A solid's moments about its centre and the body's axes, or those that the file gives, kg·m².
/// Principal moments; products of inertia of a hull that is askew are left out.
Vec3 moments_of(const BodyModel& body);

}  // namespace stig
