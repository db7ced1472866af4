// SPDX-License-Identifier: MIT
// Each key that files of robots and blocks may have is changed, one at a time: what is read must
// be another robot or block. A key that nobody reads would be declared in vain.
#include <doctest/doctest.h>

#include "robots/block.h"
#include "robots/robot_forms.h"
#include "robots/robot_reader.h"
#include "support/golden.h"
#include "support/key_changes.h"
#include "support/shown.h"
#include "support/uses.h"

namespace stig {

template <>
struct MembersOf<BodyModel> {
  static auto of(const BodyModel& o) {
    const auto& [name, shape, size, points, mass, inertia, X_RB, p_BO, material, axle,
                 axle_friction, rolls_as_sphere, rgb, visual, place] = o;
    return std::tie(name, shape, size, points, mass, inertia, X_RB, p_BO, material, axle,
                    axle_friction, rolls_as_sphere, rgb);
  }
};
template <>
struct MembersOf<AxisModel> {
  static auto of(const AxisModel& o) {
    const auto& [angular, axis, lower, upper, actuator, most_force, most_speed, damping] = o;
    return std::tie(angular, axis, lower, upper, actuator, most_force, most_speed, damping);
  }
};
template <>
struct MembersOf<JointModel> {
  static auto of(const JointModel& o) {
    const auto& [name, parent, child, X_RJ, axes, place] = o;
    return std::tie(name, parent, child, X_RJ, axes);
  }
};
template <>
struct MembersOf<AxisRef> {
  static auto of(const AxisRef& o) { return std::tie(o.joint, o.axis); }
};
template <>
struct MembersOf<DriveModel> {
  static auto of(const DriveModel& o) {
    const auto& [left, right, wheel_radius, track, most_speed, most_acceleration] = o;
    return std::tie(left, right, wheel_radius, track, most_speed, most_acceleration);
  }
};
template <>
struct MembersOf<LiftModel> {
  static auto of(const LiftModel& o) {
    const auto& [axis, low, high, tolerance, inactive_below, speeds] = o;
    return std::tie(axis, low, high, tolerance, inactive_below, speeds);
  }
};
template <>
struct MembersOf<MagnetCircuitModel::Pole> {
  static auto of(const MagnetCircuitModel::Pole& o) { return std::tie(o.body, o.p_B, o.direction); }
};
template <>
struct MembersOf<MagnetCircuitModel> {
  static auto of(const MagnetCircuitModel& o) {
    const auto& [poles, passive, active, limit, per_second, discharge, relax, sink, level] = o;
    return std::tie(poles, passive, active, limit, per_second, discharge, relax, sink, level);
  }
};
template <>
struct MembersOf<CameraIntrinsics> {
  static auto of(const CameraIntrinsics& o) {
    const auto& [width, height, fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6, thin_prism] = o;
    return std::tie(width, height, fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6, thin_prism);
  }
};
template <>
struct MembersOf<CameraDevice> {
  static auto of(const CameraDevice& o) {
    const auto& [name, body, X_BC, intrinsics, near, far] = o;
    return std::tie(name, body, X_BC, intrinsics, near, far);
  }
};
template <>
struct MembersOf<RangeDevice> {
  static auto of(const RangeDevice& o) {
    const auto& [name, body, p_B, direction, range, calibration, coefficients] = o;
    return std::tie(name, body, p_B, direction, range, calibration, coefficients);
  }
};
template <>
struct MembersOf<RadioDevice> {
  static auto of(const RadioDevice& o) { return std::tie(o.name, o.body, o.p_B, o.range); }
};
template <>
struct MembersOf<LedDevice> {
  static auto of(const LedDevice& o) { return std::tie(o.name, o.body, o.p_B); }
};
template <>
struct MembersOf<ActuatorDevice> {
  static auto of(const ActuatorDevice& o) { return std::tie(o.name, o.axis); }
};
/// Devices that list their figures themselves.
template <HasFigures Device>
struct MembersOf<Device> {
  static auto of(const Device& o) {
    std::string figures;
    Device::fields([&figures](const char* name, const auto& value,
                              const char* /*unit*/) { figures += name + shown(value); },
                   o);
    return std::tuple(o.name, o.body, figures);
  }
};
template <>
struct MembersOf<BlockTags> {
  static auto of(const BlockTags& o) { return std::tie(o.side, o.proud, o.widest); }
};
template <>
struct MembersOf<BlockLights> {
  static auto of(const BlockLights& o) { return std::tie(o.offset, o.widest); }
};
template <>
struct MembersOf<BlockRadioModel> {
  static auto of(const BlockRadioModel& o) { return std::tie(o.depth, o.range, o.answers); }
};
template <>
struct MembersOf<BlockModel> {
  static auto of(const BlockModel& o) {
    const auto& [name, title, source, side, mass, friction, offset, radius, magnet_mass, field,
                 cutoff, tags, leds, radios, program] = o;
    return std::tie(name, title, source, side, mass, friction, offset, radius, magnet_mass, field,
                    cutoff, tags, leds, radios, program);
  }
};

namespace {

/// A robot with every key. Directions are askew, so that each of their figures counts.
constexpr const char* kRobot = R"(stigc_robot: 1
name: full
title: a title
source: a source
control_period: 0.1
program: full.lua
bodies:
  - {name: deck, box: [0.2, 0.12, 0.02], mass: 0.8, inertia: [0.01, 0.011, 0.012], base: [0.1, 0.2, 0.02], color: "#aabbcc"}
  - {name: left wheel, cylinder: {radius: 0.03, height: 0.012}, mass: 0.08, center: [-0.05, 0.07, 0.03],
     turn: [10, 20, -90], material: wheel, axle: [0.1, 0.2, 1], axle_friction: 0.5, rolls_as_sphere: true}
  - {name: right wheel, cylinder: {radius: 0.03, height: 0.012}, mass: 0.08, center: [-0.05, -0.07, 0.03]}
  - {name: spare wheel, cylinder: {radius: 0.03, height: 0.012}, mass: 0.08, center: [-0.15, -0.07, 0.03]}
  - {name: ball, sphere: {radius: 0.02}, mass: 0.01, base: [0.05, 0, 0]}
  - {name: wedge, mass: 0.02, base: [0.1, 0.01, 0.02],
     hull: [{at: [0.01, 0.02, 0.03]}, {at: [0.05, 0.01, 0.02]}, {at: [0.01, 0.06, 0.01]}, {at: [0.02, 0.01, 0.07]}]}
  - {name: shell, solid: solid.yaml, density: 700, base: [0.1, 0.01, 0.02]}
  - {name: carriage, box: [0.02, 0.02, 0.02], mass: 0.1, base: [0.1, 0, 0.05]}
  - {name: hand, box: [0.02, 0.02, 0.02], mass: 0.1, base: [0.2, 0, 0.05]}
  - {name: tail, box: [0.02, 0.02, 0.02], mass: 0.1, base: [-0.2, 0, 0.05]}
joints:
  - {parent: deck, child: left wheel, axes: [{turn: [0.1, 1, 0.2], actuator: velocity, most_force: 1}]}
  - {name: right axle, parent: deck, child: right wheel, axes: [{turn: [0.1, 1, 0.2], actuator: velocity, most_force: 1}]}
  - {name: spare axle, parent: deck, child: spare wheel, axes: [{turn: [0.1, 1, 0.2], actuator: velocity, most_force: 1}]}
  - {parent: deck, child: ball}
  - {name: hood, parent: deck, child: shell}
  - {name: foot, parent: deck, child: wedge, at: [0.1, 0.02, 0.03]}
  - {name: mast, parent: deck, child: carriage, axes: [{slide: [0.1, 0.2, 1], limits: [-0.01, 0.1],
     actuator: velocity, most_force: 20, damping: 0.1}]}
  - name: arm
    parent: carriage
    child: hand
    axes:
      - {turn: [0.1, 0.2, 1], actuator: position, most_force: 1, most_speed: 90}
      - {slide: [0.1, 0.2, 1], actuator: force, most_force: 1}
      - {slide: [1, 0.1, 0.2]}
  - name: spare
    parent: deck
    child: tail
    axes:
      - {slide: [0.1, 0.2, 1], actuator: velocity, most_force: 1}
      - {slide: [0.1, 1, 0.2], actuator: velocity, most_force: 1}
differential_drive: {left: [left wheel], right: [right axle], wheel_radius: 0.03, track: 0.14, most_speed: 0.3,
  most_acceleration: 0.5}
lift: {joint: mast, switches: [0.01, 0.09], inactive_below: 0.004,
  speeds: [{above: 0.01, speed: 0.02}, {above: 0.002, speed: 0.005}]}
electromagnets: {poles: [{body: deck, at: [0.01, 0.02, 0.03], direction: [0.1, 0.2, 1]}], passive: 3, active: 0.02,
  charge_limit: 250, charge_per_second: 50, discharge_per_second: 0.1, relax_rate: 0.3, sink_rate: 1.3,
  sink_level: 6.5}
cameras:
  - {name: eye, body: deck, at: [0.01, 0.02, 0.03], look: [1, 0.1, -0.3], up: [0.1, 0.2, 1], resolution: [640, 480],
     focal_length: [600, 610], principal_point: [319.5, 239.5],
     distortion: [-0.2, 0.05, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001, 0.001], near: 0.03, far: 1}
rangefinders:
  - {name: plain, body: deck, at: [0.1, 0.01, 0.02], look: [1, 0.1, 0.2], range: 0.5}
  - {name: power, body: deck, look: [1, 0.1, 0.2], range: 0.2, calibration: power, coefficients: [1000, 40]}
  - {name: counts, body: deck, look: [1, 0.1, 0.2], range: 0.2, calibration: quadratic, coefficients: [1, 2, 3]}
radios:
  - {name: talk, body: deck, at: [0.01, 0.02, 0.1], range: 0.3}
leds:
  - {name: beacon, body: deck, at: [0.01, 0.02, 0.1]}
actuators:
  - {name: arm, joint: arm, axis: 2}
compasses:
  - {name: north, body: deck, noise: 0.02}
)";

/// Nothing refers to the body of this one, which so can have any name.
constexpr const char* kPlainRobot = R"(stigc_robot: 1
name: plain
bodies: [{name: all, box: [0.1, 0.1, 0.1], mass: 1, base: [0.1, 0.2, 0.3]}]
)";

constexpr const char* kBlock = R"(stigc_block: 1
name: full
title: a title
source: a source
body: {side: 0.055, mass: 0.102, friction: 0.5}
magnets: {offset: 0.022, radius: 0.003, mass: 0.001, field: 75, cutoff: 0.04}
tags: {side: 0.024, proud: 0.001, widest: 75}
leds: {offset: 0.02, widest: 75}
radios: {depth: 0.005, range: 0.02, answers: true}
program: full.lua
)";

std::string solid_of_size(double a) {
  return fmt::format(
      "stigc_solid: 1\nname: corner\nvolume: 0.01\ncenter: [0, 0, 0]\ninertia: [1, 1, 1]\npieces:\n"
      "  - corners: [0, 0, 0, {0}, 0, 0, 0, {0}, 0, 0, 0, {0}]\n",
      a);
}

std::optional<std::string> shown_robot(const std::string& text) {
  Diagnostics diagnostics;
  const FileLoader load = [](const std::string& name, std::size_t, FileError&) {
    return name == "solid.yaml"   ? std::optional(solid_of_size(0.1))
           : name == "other.yaml" ? std::optional(solid_of_size(0.2))
                                  : std::nullopt;
  };
  const auto robot = read_robot(std::make_shared<SourceFile>("r.yaml", text), diagnostics, load);
  if (!robot) return std::nullopt;
  std::string out = shown_all(robot->name, robot->title, robot->source, robot->control_period,
                              robot->bodies, robot->joints, robot->program);
  DeviceKinds::each([&](auto kind) { out += shown(decltype(kind)::devices(*robot)); });
  return out;
}

std::optional<std::string> shown_block(const std::string& text) {
  Diagnostics diagnostics;
  const auto block = read_block(std::make_shared<SourceFile>("b.yaml", text), diagnostics);
  return block ? std::optional(shown(*block)) : std::nullopt;
}

std::string lines_of(const std::vector<std::string>& texts) {
  return fmt::format("{}", fmt::join(texts, "\n"));
}

}  // namespace

TEST_CASE("every key of a robot's file is read, and is on the page of robots") {
  // A body is carried once, and a calibration has coefficients of its own number: neither can be
  // changed alone.
  CHECK(lines_of(unread_keys({kRobot, kPlainRobot}, robot_form(), {"other.yaml"}, shown_robot)) ==
        "joints/child takes no other value in the files of this test\n"
        "rangefinders/calibration takes no other value in the files of this test");
  CHECK(lines_of(keys_missing_on(project_file("docs/robots.md"), robot_form())) == "");
}

TEST_CASE("what programs read of each kind of device is on the page of controllers") {
  std::vector<std::string> words;
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (requires { Kind::program_key; }) {
      words.emplace_back(Kind::program_key);
    } else if constexpr (ReadKind<Kind>) {
      words.emplace_back(Kind::key);
    }
    if constexpr (ReadKind<Kind>) {
      if constexpr (HasFigures<typename Kind::Reading>) {
        typename Kind::Reading reading;
        Kind::Reading::fields([&words](const char* name, const auto& /*value*/,
                                       const char* /*unit*/) { words.emplace_back(name); },
                              reading);
      }
    }
  });
  CHECK(lines_of(words_missing_on(project_file("docs/controllers.md"), words)) == "");
}

TEST_CASE("every key of a block's file is read, and is on the page of robots") {
  CHECK(lines_of(unread_keys({kBlock}, block_form(), {}, shown_block)) == "");
  CHECK(lines_of(keys_missing_on(project_file("docs/robots.md"), block_form())) == "");
}

}  // namespace stig
