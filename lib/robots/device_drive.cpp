// SPDX-License-Identifier: MIT
#include "robots/device_drive.h"

#include <fmt/format.h>

#include "robots/device_parts.h"
#include "robots/robot_pivot.h"

namespace stig::robots {

namespace {

std::vector<AxisRef> read_wheels(const FormView& view, std::string_view key, DeviceParts& parts) {
  std::vector<AxisRef> out;
  const YamlNode* list = view.find(key);
  if (list == nullptr) return out;
  for (const YamlNode& name : list->items) {
    out.push_back(parts.take_axis(&name, 0, {"a wheel", true, false}));
  }
  if (!list->items.empty()) return out;
  parts.out.add(Code::R107, parts.document.head(*list),
                fmt::format("'{}' names no wheel, it takes at least 1", key));
  return out;
}

}  // namespace

const Form& DriveKind::form() {
  using namespace keys;
  static const Form kForm{
      "differential drive",
      {required(words("left", FormKind::names, "Joints of the wheels on the left.")),
       required(words("right", FormKind::names, "Joints of the wheels on the right.")),
       required(above_zero("wheel_radius", "Metres.", kFar)),
       required(above_zero("track", "Metres between left and right.", kFar)),
       required(above_zero("most_speed", "Of the rims, metres a second.", 100)),
       above_zero("most_acceleration", "Of the rims, metres a second squared (default: 1).",
                  1000)}};
  return kForm;
}

DriveModel DriveKind::read(const FormView& view, DeviceParts& parts) {
  DriveModel drive;
  drive.left = read_wheels(view, "left", parts);
  drive.right = read_wheels(view, "right", parts);
  drive.wheel_radius = view.number("wheel_radius");
  drive.track = view.number("track");
  drive.most_speed = view.number("most_speed");
  drive.most_acceleration = view.number("most_acceleration", 1);
  return drive;
}

std::string DriveKind::description(const RobotModel& robot) {
  if (!robot.drive) return {};
  const DriveModel& drive = *robot.drive;
  return fmt::format(
      "   drive = {{ track = {:.6g}, pivot = {:.6g}, speed = {:.6g}, acceleration = {:.6g} }},\n",
      drive.track, pivot_of(robot), drive.most_speed, drive.most_acceleration);
}

}  // namespace stig::robots
