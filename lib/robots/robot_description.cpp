// SPDX-License-Identifier: MIT
#include "robots/robot_description.h"

#include <fmt/format.h>

#include <algorithm>

#include "robots/robot_extent.h"

namespace stig {

namespace {

std::string drive_text(const DriveModel& drive) {
  return fmt::format("   drive = {{ track = {:.6g}, speed = {:.6g}, acceleration = {:.6g} }},\n",
                     drive.track, drive.most_speed, drive.most_acceleration);
}

std::string lift_text(const LiftModel& lift) {
  return fmt::format("   lift = {{ top = {:.6g}, tolerance = {:.6g} }},\n", lift.high,
                     lift.tolerance);
}

/// `neutral` is the charge at which the field of a destructive current takes away the passive one.
std::string magnets_text(const RobotModel& robot) {
  const MagnetCircuitModel& magnets = *robot.magnets;
  std::string out = fmt::format("   magnets = {{ ahead = {:.6g}", middle_of_poles(robot).x);
  if (magnets.active > 0) {
    out += fmt::format(", neutral = {:.6g}", magnets.passive / magnets.active);
  }
  return out + " },\n";
}

/// The foremost of what goes up and down.
std::string effector_text(const RobotModel& robot) {
  const std::vector<bool> lifted = lifted_bodies(robot);
  double front = -1e9;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    if (lifted[i]) front = std::max(front, extent_of(robot.bodies[i]).high.x);
  }
  return fmt::format("   effector = {{ front = {:.6g} }},\n", front);
}

std::string place_text(const Vec3& p) {
  return fmt::format("x = {:.6g}, y = {:.6g}, z = {:.6g}", p.x, p.y, p.z);
}

std::string camera_text(const RobotModel& robot) {
  const CameraDevice& camera = robot.cameras.front();
  return fmt::format("   camera = {{ anchor = {{ {} }}, focal = {:.6g} }},\n",
                     place_text(robot.bodies[camera.body].X_RB.p), camera.intrinsics.fx);
}

std::string rangefinder_text(const RobotModel& robot, const RangeDevice& finder) {
  constexpr const char* kCalibrations[] = {"metres", "power", "quadratic"};
  std::string out =
      fmt::format("      [{}] = {{ {}, range = {:.6g}, calibration = '{}'", lua_quoted(finder.name),
                  place_text(robot.bodies[finder.body].X_RB * finder.p_B), finder.range,
                  kCalibrations[static_cast<std::size_t>(finder.calibration)]);
  if (finder.calibration != RangeDevice::Calibration::metres) {
    const auto& c = finder.coefficients;
    const bool power = finder.calibration == RangeDevice::Calibration::power;
    out += fmt::format(", coefficients = {{ {}, {}", c[0], c[1]);
    out += power ? " }" : fmt::format(", {} }}", c[2]);
  }
  return out + " },\n";
}

}  // namespace

std::string lua_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\{:03}", static_cast<int>(static_cast<unsigned char>(c)));
    } else {
      out += c;
    }
  }
  return out + "'";
}

std::string robot_description(const RobotModel& robot) {
  std::string out = fmt::format("{{\n   name = {},\n", lua_quoted(robot.name));
  if (robot.drive) out += drive_text(*robot.drive);
  if (robot.lift) out += lift_text(*robot.lift);
  if (robot.lift && robot.lift->axis.joint < robot.joints.size()) out += effector_text(robot);
  if (robot.magnets && !robot.magnets->poles.empty()) out += magnets_text(robot);
  if (!robot.cameras.empty()) out += camera_text(robot);
  out += "   rangefinders = {\n";
  for (const RangeDevice& finder : robot.rangefinders) out += rangefinder_text(robot, finder);
  return out + "   },\n}";
}

}  // namespace stig
