// SPDX-License-Identifier: MIT
// From a robot's description to bodies, joints and electromagnets of a world, and from devices'
// commands to motors. Bodies and joints of one robot are numbered in one piece, in the order of its
// file, so that places in the model are places in RobotBody.
#include "physical/robots/robot_body.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "robots/block.h"

namespace stig::physics {

namespace {

// Wheels of rubber and casters of steel, on the floor.
constexpr double kWheelGrip = 0.9, kCasterGrip = 0.02;

Shape shape_of(const BodyModel& body) {
  // A wheel that rolls as a ball touches at one point, where friction along its axle and across it
  // differ.
  if (body.shape == ShapeType::sphere || body.rolls_as_sphere) {
    return Shape::sphere(body.size.x / 2);
  }
  if (body.shape == ShapeType::cylinder) return Shape::cylinder(body.size.x / 2, body.size.z);
  return body.shape == ShapeType::hull ? Shape::hull(body.points) : Shape::box(body.size);
}

BodyDef body_def(const BodyModel& body, const Pose& X_WR, Materials& materials) {
  BodyDef def;
  def.shape = shape_of(body);
  def.mass = body.mass;
  def.inertia = moments_of(body);
  def.X_WB = X_WR * body.X_RB;
  def.material = materials.number(body.material);
  def.axle = body.axle;
  def.axle_friction = body.axle_friction;
  return def;
}

DofDef dof_def(const AxisModel& axis) {
  // In the order of the model's own enumeration.
  constexpr Actuator kModes[] = {Actuator::none, Actuator::velocity, Actuator::position,
                                 Actuator::force};
  DofDef dof;
  dof.linear = !axis.angular;
  dof.axis = axis.axis;
  if (axis.lower) dof.lower = *axis.lower;
  if (axis.upper) dof.upper = *axis.upper;
  dof.actuator = kModes[static_cast<std::size_t>(axis.actuator)];
  if (axis.most_force > 0) dof.effort = axis.most_force;
  if (axis.most_speed > 0) dof.speed = axis.most_speed;
  dof.damping = axis.damping;
  return dof;
}

// The world numbers bodies across robots: `first` is this robot's first.
JointDef joint_def(const JointModel& joint, const RobotModel& robot, std::uint32_t first) {
  JointDef def;
  def.parent = first + static_cast<std::uint32_t>(joint.parent);
  def.child = first + static_cast<std::uint32_t>(joint.child);
  // Both frames of a joint are at the joint, as the robot stands in its file.
  def.X_PJ = inverse(robot.bodies[joint.parent].X_RB) * joint.X_RJ;
  def.X_CJ = inverse(robot.bodies[joint.child].X_RB) * joint.X_RJ;
  for (const AxisModel& axis : joint.axes) def.dofs.push_back(dof_def(axis));
  return def;
}

// A pole's number is its place among the magnets of its body, which has others before it if several
// poles are on one body.
void add_poles(WorldConfig& config, const MagnetCircuitModel& magnets, std::uint32_t first,
               RobotBody& out) {
  for (const MagnetCircuitModel::Pole& pole : magnets.poles) {
    // Fixed poles of iron: passive moments pull blocks, the current adds to them or takes away.
    auto& on = config.bodies[first + pole.body].magnets;
    MagnetDef def;
    def.p_B = pole.p_B;
    def.direction = pole.direction;
    def.free = false;
    def.moment = magnets.passive * kMomentPerField;
    def.active = magnets.active * kMomentPerField;
    out.poles.push_back(on.size());
    on.push_back(def);
  }
}

// Linear, as a world has few materials and this is done once for each robot.
void add_friction(WorldConfig& config, Material a, Material b, double coefficient) {
  // What a scene says of two materials is not overruled.
  const bool known = std::any_of(
      config.frictions.begin(), config.frictions.end(), [a, b](const FrictionPair& pair) {
        return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
      });
  if (!known) config.frictions.push_back({a, b, coefficient});
}

void drive_wheels(World& world, const RobotBody& body, const std::vector<AxisRef>& wheels,
                  double speed) {
  for (const AxisRef& wheel : wheels) world.drive(body.joints[wheel.joint], wheel.axis, speed);
}

DofState state_of(const World& world, const RobotBody& body, const AxisRef& axis) {
  return world.joint(body.joints[axis.joint])[axis.axis];
}

/// The speed of the rims, the mean over the wheels of a side.
double encoder(const World& world, const RobotBody& body, const std::vector<AxisRef>& wheels,
               double radius) {
  assert(!wheels.empty());
  double sum = 0;
  for (const AxisRef& wheel : wheels) sum += state_of(world, body, wheel).velocity * radius;
  return sum / static_cast<double>(wheels.size());
}

}  // namespace

Material Materials::number(const std::string& name) {
  const auto known = std::find(names.begin(), names.end(), name);
  const auto number = static_cast<Material>(known - names.begin());
  // A new name gets the next number.
  if (known == names.end()) names.push_back(name);
  return number;
}

RobotBody add_robot(WorldConfig& config, const RobotModel& robot, const Pose& X_WR,
                    Materials& materials) {
  assert(!robot.bodies.empty());
  RobotBody out;
  const auto first = static_cast<std::uint32_t>(config.bodies.size());
  for (const BodyModel& body : robot.bodies) {
    out.bodies.push_back(BodyId{static_cast<std::uint32_t>(config.bodies.size())});
    config.bodies.push_back(body_def(body, X_WR, materials));
  }
  for (const JointModel& joint : robot.joints) {
    out.joints.push_back(JointId{static_cast<std::uint32_t>(config.joints.size())});
    config.joints.push_back(joint_def(joint, robot, first));
  }
  if (robot.magnets) add_poles(config, *robot.magnets, first, out);
  // Every world with a robot knows these two pairs, whether it has such wheels or not.
  add_friction(config, materials.number("wheel"), kFloorMaterial, kWheelGrip);
  add_friction(config, materials.number("caster"), kFloorMaterial, kCasterGrip);
  return out;
}

void add_fixed_together(WorldConfig& config, const std::vector<BodyModel>& bodies, bool to_world,
                        Materials& materials) {
  assert(!bodies.empty());
  const auto first = static_cast<std::uint32_t>(config.bodies.size());
  for (const BodyModel& body : bodies) {
    if (!to_world && &body != &bodies.front()) {
      JointDef joint;
      joint.parent = first;
      joint.child = static_cast<std::uint32_t>(config.bodies.size());
      joint.X_PJ = inverse(bodies.front().X_RB) * Pose{body.X_RB.p, {}};
      joint.X_CJ = inverse(body.X_RB) * Pose{body.X_RB.p, {}};
      config.joints.push_back(joint);
    }
    config.bodies.push_back(body_def(body, {}, materials));
    config.bodies.back().fixed = to_world;
  }
}

void command(RobotDevices& devices, const RobotModel& robot, const RobotCommands& commands) {
  if (robot.drive && commands.wheels) {
    command(devices.drive, *robot.drive, commands.wheels->first, commands.wheels->second);
  }
  if (robot.lift) command(devices.lift, *robot.lift, commands.lift);
  if (robot.magnets && commands.discharge) devices.magnets.mode = *commands.discharge;
  devices.joints.resize(robot.actuators.size());
  const std::size_t count = std::min(devices.joints.size(), commands.joints.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& target = commands.joints[i];
    // NaN is no command.
    if (target && std::isfinite(*target)) devices.joints[i] = *target;
  }
}

// Joints keep their targets: an arm that let go would fall.
void make_safe(RobotDevices& devices) {
  devices.drive.left_target = devices.drive.right_target = 0;
  devices.lift.mode = LiftMode::rest;
  devices.magnets.mode = Discharge::disable;
}

// Devices first move by their own dynamics (ramps, charge), then motors get targets.
void act(World& world, const RobotModel& robot, const RobotBody& body, RobotDevices& devices,
         double dt) {
  if (robot.drive) {
    step(devices.drive, *robot.drive, dt);
    // Rim speeds in m/s become angular speeds, rad/s.
    drive_wheels(world, body, robot.drive->left, devices.drive.left / robot.drive->wheel_radius);
    drive_wheels(world, body, robot.drive->right, devices.drive.right / robot.drive->wheel_radius);
  }
  if (robot.lift) {
    const AxisRef& axis = robot.lift->axis;
    step(devices.lift, *robot.lift, state_of(world, body, axis).position);
    world.drive(body.joints[axis.joint], axis.axis, devices.lift.speed);
  }
  if (robot.magnets) {
    step(devices.magnets, *robot.magnets, dt);
    for (std::size_t i = 0; i < body.poles.size(); ++i) {
      world.set_current(body.bodies[robot.magnets->poles[i].body], body.poles[i],
                        current_of(devices.magnets));
    }
  }
  for (std::size_t i = 0; i < devices.joints.size(); ++i) {
    const AxisRef& axis = robot.actuators[i].axis;
    world.drive(body.joints[axis.joint], axis.axis, devices.joints[i]);
  }
}

// Read off the true state; what encoders make of it is the caller's business.
void read(const World& world, const RobotModel& robot, const RobotBody& body,
          const RobotDevices& devices, RobotReadings& readings) {
  if (robot.drive) {
    const DriveModel& drive = *robot.drive;
    readings.left_encoder = encoder(world, body, drive.left, drive.wheel_radius);
    readings.right_encoder = encoder(world, body, drive.right, drive.wheel_radius);
  }
  if (robot.lift) {
    const double position = state_of(world, body, robot.lift->axis).position;
    readings.lift = reading_of(devices.lift, *robot.lift, position);
  }
  readings.magnet_voltage = devices.magnets.charge;
  readings.joints.clear();
  for (const ActuatorDevice& actuator : robot.actuators) {
    const DofState state = state_of(world, body, actuator.axis);
    readings.joints.push_back({state.position, state.velocity});
  }
}

Pose pose_of(const World& world, const RobotBody& body, std::size_t place) {
  assert(place < body.bodies.size());
  return world.state(body.bodies[place]).X_WB;
}

// The robot's frame from its root body's pose, which is the one that moves.
Pose pose_of(const World& world, const RobotModel& robot, const RobotBody& body) {
  const std::size_t root = robot.root();
  return pose_of(world, body, root) * inverse(robot.bodies[root].X_RB);
}

}  // namespace stig::physics
