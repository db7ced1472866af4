// SPDX-License-Identifier: MIT
// A robot as URDF and SDF have it: links with any mass and any number of shapes, and joints between
// them, all in the model's frame M with every joint at zero. From it robot_text.h makes a robot
// file.
//
// A link without mass is a frame: a name for a place on the link that carries it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"
#include "robots/robot_model.h"
#include "urdf/reading.h"
#include "urdf/uses.h"

namespace stig::urdf {

/// A box, cylinder or sphere.
struct Solid {
  ShapeType shape = ShapeType::box;
  Vec3 size;  ///< as BodyModel has it
  Pose X_LS;
  std::optional<double> friction;
  SourceRange place;
};

struct Link {
  std::string name;
  bool massive = false;
  double mass = 0;
  Vec3 p_LC;                  ///< of the middle of mass
  Mat3 moments;               ///< about it, along the link's axes, kg·m²
  std::vector<Solid> solids;  ///< that touch
  std::optional<Rgb> rgb;
  Pose X_ML;
  SourceRange place;
};

struct Axis {
  bool angular = true;
  Vec3 direction;  ///< unit, model's frame
  std::optional<double> lower, upper, effort, speed;
  double damping = 0;
  ActuatorMode motor = ActuatorMode::none;
};

/// Without axes the child is fixed.
struct Joint {
  std::string name;
  std::size_t parent = 0, child = 0;  ///< links
  Vec3 p_M;
  std::vector<Axis> axes;
  SourceRange place;
};

/// Looks along x of its frame, z is up.
struct Camera {
  std::string name;
  std::size_t link = 0;
  Pose X_LC;
  double width = 320, height = 240, angle = 1.0;  ///< pixels; rad, from side to side
  double near = 0.1, far = 100;
  std::vector<double> intrinsics = {};  ///< fx, fy, cx, cy, or none
  std::vector<double> distortion = {};  ///< k1, k2, p1, p2, k3, or none
};

/// A single ray along x of its frame.
struct SingleRay {
  std::string name;
  std::size_t link = 0;
  Pose X_LR;
  double range = 1;
};

struct Drive {
  std::vector<std::string> left, right;  ///< joints
  std::optional<double> radius, track, speed, acceleration, torque;
  SourceRange place;
};

struct Description {
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Camera> cameras;
  std::vector<SingleRay> rays;
  std::optional<Drive> drive;
  SourceRange place;

  std::optional<std::size_t> link(std::string_view called) const;
  std::optional<std::size_t> joint(std::string_view called) const;
};

/// Moments from the six figures of a tensor along the axes of a frame that is turned by `q`; checks
/// that a body can have them, and its mass.
void set_mass(Link& link, double mass, const Pose& X_LI, const std::vector<double>& six,
              const SourceRange& where, const Reading& reading);

/// Are the joints a tree of all links? What is wrong is said. The order of links from the root on,
/// every parent before its children; empty when they are none.
std::vector<std::size_t> tree_order(const Description& description, const Reading& reading);

/// Frames become places on the links that carry them: what is left has mass. False with an error
/// where that cannot be.
bool fold_frames(Description& description, const Reading& reading);

}  // namespace stig::urdf
