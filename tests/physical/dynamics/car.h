// SPDX-License-Identifier: MIT
// A robot by the figures of Allwright et al. 2017 (TR/IRIDIA/2017-003): four driven wheels,
// a lift, fifteen bodies, 2.295 kg. Lifts carry a plate in place of magnets.
#pragma once

#include "physical/support.h"
#include "support/uses.h"

namespace stig {

inline constexpr double kWheelRadius = 0.01575, kTrack = 0.057;
inline constexpr Material kWheelMaterial = 2;

/// Numbers of a car's parts in its configuration.
struct Car {
  std::uint32_t chassis = 0, plate = 0;
  std::array<JointId, 4> wheels;  ///< front left, front right, rear left, rear right
  JointId lift{};
};

/// A box whose base is centred at `base`, fixed to `parent`, which stands at X_RP there.
inline std::uint32_t add_fixed(WorldConfig& config, std::uint32_t parent, const Vec3& parent_at,
                               const Vec3& edges, double mass, const Vec3& base) {
  const Vec3 at = base + Vec3{0, 0, edges.z / 2};
  JointDef joint;
  joint.parent = parent;
  joint.child = static_cast<std::uint32_t>(config.bodies.size());
  joint.X_PJ.p = at - parent_at;
  config.bodies.push_back(solid_body(Shape::box(edges), mass));
  config.joints.push_back(joint);
  return joint.child;
}

inline JointId add_wheel(WorldConfig& config, std::uint32_t chassis, const Vec3& chassis_at,
                         const Vec3& at, double axle_friction) {
  BodyDef wheel = solid_body(Shape::sphere(kWheelRadius), 0.1);
  const double across = 0.1 * (3 * kWheelRadius * kWheelRadius + 0.014 * 0.014) / 12;
  wheel.inertia = {across, 0.05 * kWheelRadius * kWheelRadius, across};
  wheel.material = kWheelMaterial;
  wheel.axle = {0, 1, 0};
  wheel.axle_friction = axle_friction;
  JointDef joint;
  joint.parent = chassis;
  joint.child = static_cast<std::uint32_t>(config.bodies.size());
  joint.X_PJ.p = at - chassis_at;
  joint.dofs = {{.axis = {0, 1, 0}, .actuator = Actuator::velocity, .effort = 15}};
  config.bodies.push_back(wheel);
  config.joints.push_back(joint);
  return JointId{static_cast<std::uint32_t>(config.joints.size() - 1)};
}

/// The lift: a slide with its plate; four magnets' bodies are on the plate.
inline void add_lift(WorldConfig& config, const Vec3& chassis_at, Car& car) {
  const Vec3 link_at{0.055755, 0, 0.01975 + 0.1185 / 2};
  JointDef lift;
  lift.parent = car.chassis;
  lift.child = static_cast<std::uint32_t>(config.bodies.size());
  lift.X_PJ.p = link_at - chassis_at;
  lift.dofs = {{.linear = true,
                .lower = -0.0005,
                .upper = 0.1375,
                .actuator = Actuator::velocity,
                .effort = 20}};
  config.bodies.push_back(solid_body(Shape::box({0.004, 0.060, 0.1185}), 0.250));
  config.joints.push_back(lift);
  car.lift = JointId{static_cast<std::uint32_t>(config.joints.size() - 1)};
  car.plate =
      add_fixed(config, lift.child, link_at, {0.072, 0.060, 0.010}, 0.150, {0.093755, 0, 0.05575});
  add_fixed(config, lift.child, link_at, {0.0285, 0.060, 0.025}, 0.005, {0.072, 0, 0.0658});
  for (const double x : {-0.023, 0.023}) {
    for (const double y : {-0.023, 0.023}) {
      add_fixed(config, lift.child, link_at, {0.02, 0.02, 0.0235}, 0.010,
                {0.093755 + x, y, 0.05575});
    }
  }
}

/// Adds a car with its wheels on the floor.
inline Car add_car(WorldConfig& config, const Pose& X_WR = {}, double axle_friction = 0.2) {
  Car car;
  const Vec3 edges{0.08951, 0.057, 0.030}, at{0, 0, 0.00575 + 0.015};
  car.chassis = static_cast<std::uint32_t>(config.bodies.size());
  config.bodies.push_back(solid_body(Shape::box(edges), 0.250));
  config.bodies.back().X_WB = X_WR * Pose{at, {}};
  std::size_t number = 0;
  for (const double x : {0.03175, -0.03175}) {
    for (const double y : {0.0285, -0.0285}) {
      car.wheels[number++] =
          add_wheel(config, car.chassis, at, {x, y, kWheelRadius - 1e-5}, axle_friction);
    }
  }
  add_fixed(config, car.chassis, at, {0.08951, 0.0875, 0.0345}, 0.2, {0, 0, 0.03575});
  add_fixed(config, car.chassis, at, {0.1186, 0.0875, 0.010}, 0.5, {-0.014545, 0, 0.07025});
  add_fixed(config, car.chassis, at, {0.0585, 0.0875, 0.28775}, 0.5, {0, 0, 0.08025});
  add_lift(config, at, car);
  place_links(config);
  return car;
}

/// Wheel speeds of the two sides, m/s at the rim.
inline void drive(World& world, const Car& car, double left, double right) {
  for (std::size_t i = 0; i < 4; ++i) {
    world.drive(car.wheels[i], 0, (i % 2 == 0 ? left : right) / kWheelRadius);
  }
}

inline WorldConfig car_settings() {
  WorldConfig config = scene_settings();
  config.frictions.push_back({kWheelMaterial, kFloorMaterial, 0.9});
  return config;
}

}  // namespace stig
