// SPDX-License-Identifier: MIT
#include "robots/robot_model.h"

#include <cassert>
#include <numbers>

#include "base/hull.h"

namespace stig::robots {

double RobotModel::mass() const {
  double sum = 0;
  for (const BodyModel& body : bodies) sum += body.mass;
  return sum;
}

Vec3 RobotModel::centre_of_mass() const {
  assert(mass() > 0);
  Vec3 sum;
  for (const BodyModel& body : bodies) sum += body.mass * body.X_RB.p;
  // Every mass is positive, by the form of the file.
  return sum * (1 / mass());
}

// In a sound model exactly one body is carried by no joint. In one with errors there may be none,
// then this is the number of bodies, and callers that report errors bear with it.
std::size_t RobotModel::root() const {
  std::vector<bool> carried(bodies.size());
  for (const JointModel& joint : joints) {
    if (joint.child < bodies.size()) carried[joint.child] = true;
  }
  std::size_t root = 0;
  while (root < bodies.size() && carried[root]) ++root;
  return root;
}

double volume_of(const BodyModel& body) {
  const double box = body.size.x * body.size.y * body.size.z;
  switch (body.shape) {
    case ShapeType::cylinder:
      return box * std::numbers::pi / 4;
    case ShapeType::sphere:
      return box * std::numbers::pi / 6;
    case ShapeType::hull:
      return hull_mass(body.points).volume;
    case ShapeType::box:
      break;
  }
  return box;
}

Vec3 moments_of(const BodyModel& body) {
  assert(body.mass > 0);
  // A file's own moments win: real robots are not solid.
  if (body.inertia) return *body.inertia;
  const Vec3 s = scaled(body.size, body.size) * body.mass;
  switch (body.shape) {
    case ShapeType::cylinder: {
      // A solid cylinder of diameter d and height h: m (d²/16 + h²/12) across, m d²/8 about z.
      const double across = s.x / 16 + s.z / 12;
      return {across, across, s.x / 8};
    }
    case ShapeType::sphere:
      // 2/5 m r² by the diameter.
      return Vec3{1, 1, 1} * (s.x / 10);
    case ShapeType::hull: {
      // The hull's own integrals of x², y² and z², scaled from volume to mass.
      const HullMass solid = hull_mass(body.points);
      const Vec3& q = solid.squares;
      return Vec3{q.y + q.z, q.x + q.z, q.x + q.y} * (body.mass / solid.volume);
    }
    case ShapeType::box:
      break;
  }
  return Vec3{s.y + s.z, s.x + s.z, s.x + s.y} * (1.0 / 12);
}

}  // namespace stig::robots
