// SPDX-License-Identifier: MIT
// What robots read, and the states of their devices: the members of each, for bytes and back.
#pragma once

#include <vector>

#include "base/byte_members.h"
#include "physical/robots/robot_body.h"
#include "robots/robot_devices.h"
#include "robots/robot_io.h"

namespace stig {

void each_member(auto& each, EitherWay<ImagePoint> auto& p) { each(p.x), each(p.y); }
void each_member(auto& each, EitherWay<std::vector<Message>> auto& messages) {
  each.list(messages);
}
void each_member(auto& each, EitherWay<TagReading> auto& tag) {
  each(tag.id), each_member(each, tag.p_CT), each_member(each, tag.q_CT),
      each_member(each, tag.centre);
  for (auto& corner : tag.corners) each_member(each, corner);
}
void each_member(auto& each, EitherWay<LedReading> auto& led) {
  each_member(each, led.centre), each(led.y), each(led.u), each(led.v);
}
void each_member(auto& each, EitherWay<CameraReading> auto& camera) {
  each(camera.enabled), each(camera.timestamp), each.list(camera.tags), each.list(camera.leds);
  each_member(each, camera.X_RC.p), each_member(each, camera.X_RC.q);
}
void each_member(auto& each, EitherWay<RangeReading> auto& range) {
  each(range.proximity), each(range.illuminance);
}
void each_member(auto& each, EitherWay<std::vector<RangeReading>> auto& ranges) {
  each.list(ranges);
}
void each_member(auto& each, EitherWay<JointReading> auto& joint) {
  each(joint.position), each(joint.velocity);
}
void each_member(auto& each, EitherWay<RobotReadings> auto& r) {
  each(r.tick), each(r.time), each(r.temperature);
  each.list(r.cameras), each.list(r.rangefinders), each.list(r.radios);
  each(r.left_encoder), each(r.right_encoder);
  each(r.lift.active), each(r.lift.calibrating), each(r.lift.position);
  each(r.lift.at_top), each(r.lift.at_bottom);
  each(r.magnet_voltage), each.list(r.joints);
}
void each_member(auto& each, EitherWay<RobotDevices> auto& d) {
  each(d.drive.left), each(d.drive.right), each(d.drive.left_target), each(d.drive.right_target);
  each.choice(d.lift.mode, LiftMode::calibrating), each(d.lift.target), each(d.lift.speed);
  each.choice(d.magnets.mode, Discharge::destructive), each(d.magnets.charge);
  each.list(d.joints);
}

}  // namespace stig
