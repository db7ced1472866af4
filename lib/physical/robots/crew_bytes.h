// SPDX-License-Identifier: MIT
// What robots read, and the states of their devices: the members of each, for bytes and back.
#pragma once

#include <type_traits>
#include <vector>

#include "base/byte_members.h"
#include "physical/robots/robot_body.h"
#include "physical/robots/uses.h"
#include "robots/robot_devices.h"
#include "robots/robot_io.h"
#include "robots/robot_model.h"

// In the namespace of BytesOut and BytesIn, where they are looked up whatever they are handed.
namespace stig {

void each_member(auto& each, EitherWay<sensing::ImagePoint> auto& p) { each(p.x), each(p.y); }
void each_member(auto& each, EitherWay<std::vector<robots::Message>> auto& messages) {
  each.list(messages);
}
void each_member(auto& each, EitherWay<robots::TagReading> auto& tag) {
  each(tag.id), each_member(each, tag.p_CT), each_member(each, tag.q_CT),
      each_member(each, tag.centre);
  for (auto& corner : tag.corners) each_member(each, corner);
}
void each_member(auto& each, EitherWay<robots::LedReading> auto& led) {
  each_member(each, led.centre), each(led.y), each(led.u), each(led.v);
}
void each_member(auto& each, EitherWay<robots::CameraReading> auto& camera) {
  each(camera.enabled), each(camera.timestamp), each.list(camera.tags), each.list(camera.leds);
  each_member(each, camera.X_RC.p), each_member(each, camera.X_RC.q);
}
/// Readings that are a few figures.
template <class Each, class Reading>
requires robots::HasFigures<Reading>
void each_member(Each& each, Reading& reading) {
  std::remove_const_t<Reading>::fields(
      [&each](const char* /*name*/, auto& value, const char* /*unit*/) { each(value); }, reading);
}
void each_member(auto& each, EitherWay<std::vector<robots::RangeReading>> auto& ranges) {
  each.list(ranges);
}

}  // namespace stig

namespace stig::physics {

/// Kinds of devices whose readings are in every record, in the order in which they have been there
/// from the beginning. Those of other kinds follow in the order of the list, where the robot has
/// such devices: so records of robots that have none stay the same bytes.
using FirstInRecords = KindList<CameraKind, RangefinderKind, RadioKind, DriveKind, LiftKind,
                                ElectromagnetsKind, ActuatorKind>;

template <class Kind>
void readings_of_kind(auto& each, auto& readings) {
  if constexpr (ReadKind<Kind>) {
    each.list(Kind::readings(readings));
  } else if constexpr (requires { Kind::reading_members(each, readings); }) {
    Kind::reading_members(each, readings);
  }
}
void reading_members(auto& each, EitherWay<RobotReadings> auto& r, const RobotModel& model) {
  each(r.tick), each(r.time), each(r.temperature);
  FirstInRecords::each([&](auto kind) { readings_of_kind<decltype(kind)>(each, r); });
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (ReadKind<Kind> && !FirstInRecords::has<Kind>) {
      if (!Kind::devices(model).empty()) readings_of_kind<Kind>(each, r);
    }
  });
}
void each_member(auto& each, EitherWay<RobotDevices> auto& d) {
  each(d.drive.left), each(d.drive.right), each(d.drive.left_target), each(d.drive.right_target);
  each.choice(d.lift.mode, LiftMode::calibrating), each(d.lift.target), each(d.lift.speed);
  each.choice(d.magnets.mode, Discharge::destructive), each(d.magnets.charge);
  each.list(d.joints);
}

}  // namespace stig::physics
