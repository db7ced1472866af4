// SPDX-License-Identifier: MIT
// What robots read, and the states of their devices, as bytes and back: for crew_state.cpp. One
// list of members serves both ways. Bytes from outside may be anything; the reader is bad after
// whatever is no value.
#pragma once

#include <array>
#include <bit>
#include <deque>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "physical/robots/led.h"
#include "physical/robots/robot_body.h"
#include "robots/robot_devices.h"
#include "robots/robot_io.h"

namespace stig {

/// Appends values.
class BytesOut {
 public:
  void operator()(bool value) { out_.push_back(value ? '\1' : '\0'); }
  void operator()(double value) { put(out_, std::bit_cast<std::uint64_t>(value)); }
  void operator()(int value) { put_zigzag(out_, value); }
  void operator()(std::uint64_t value) { put_varint(out_, value); }
  void operator()(const std::string& value) { put_block(out_, value); }
  template <class Enum>
  void choice(const Enum& value, Enum) {
    out_.push_back(static_cast<char>(value));
  }
  template <class List>
  void list(const List& values) {
    put_varint(out_, values.size());
    for (const auto& value : values) each_member(*this, value);
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

/// Takes them again.
class BytesIn {
 public:
  explicit BytesIn(ByteReader& in) : in_(in) {}
  void operator()(bool& value) {
    const std::uint8_t byte = in_.u8();
    if (byte > 1) in_.fail();
    value = byte == 1;
  }
  void operator()(double& value) { value = std::bit_cast<double>(in_.u64()); }
  void operator()(int& value) { value = static_cast<int>(in_.zigzag()); }
  void operator()(std::uint64_t& value) { value = in_.varint(); }
  void operator()(std::string& value) { value = in_.block(); }
  template <class Enum>
  void choice(Enum& value, Enum last) {
    const std::uint8_t byte = in_.u8();
    if (byte > static_cast<std::uint8_t>(last)) return in_.fail();
    value = static_cast<Enum>(byte);
  }
  template <class List>
  void list(List& values) {
    values.clear();
    const std::uint64_t size = in_.varint();
    // Each takes a byte at least.
    for (std::uint64_t i = 0; i < size && in_.good(); ++i) {
      typename List::value_type value{};
      each_member(*this, value);
      values.push_back(std::move(value));
    }
  }
  bool good() const { return in_.good(); }

 private:
  ByteReader& in_;
};

// Of each kind of value: its members. Value is the type itself or its const.

template <class Each, class Value>
requires requires(Each each, Value& value) { each(value); }
void each_member(Each& each, Value& value) { each(value); }
template <class Each, class V>
requires std::is_same_v<std::remove_const_t<V>, Vec3>
void each_member(Each& each, V& v) { each(v.x), each(v.y), each(v.z); }
template <class Each, class Q>
requires std::is_same_v<std::remove_const_t<Q>, Quat>
void each_member(Each& each, Q& q) { each(q.w), each(q.x), each(q.y), each(q.z); }
template <class Each, class P>
requires std::is_same_v<std::remove_const_t<P>, ImagePoint>
void each_member(Each& each, P& p) { each(p.x), each(p.y); }
template <class Each, class M>
requires std::is_same_v<std::remove_const_t<M>, std::vector<Message>>
void each_member(Each& each, M& messages) { each.list(messages); }
template <class Each, class Tag>
requires std::is_same_v<std::remove_const_t<Tag>, TagReading>
void each_member(Each& each, Tag& tag) {
  each(tag.id), each_member(each, tag.p_CT), each_member(each, tag.q_CT),
      each_member(each, tag.centre);
  for (auto& corner : tag.corners) each_member(each, corner);
}
template <class Each, class L>
requires std::is_same_v<std::remove_const_t<L>, LedReading>
void each_member(Each& each, L& led) {
  each_member(each, led.centre), each(led.y), each(led.u), each(led.v);
}
template <class Each, class Camera>
requires std::is_same_v<std::remove_const_t<Camera>, CameraReading>
void each_member(Each& each, Camera& camera) {
  each(camera.enabled), each(camera.timestamp), each.list(camera.tags), each.list(camera.leds);
  each_member(each, camera.X_RC.p), each_member(each, camera.X_RC.q);
}
template <class Each, class Range>
requires std::is_same_v<std::remove_const_t<Range>, RangeReading>
void each_member(Each& each, Range& range) { each(range.proximity), each(range.illuminance); }
template <class Each, class Ranges>
requires std::is_same_v<std::remove_const_t<Ranges>, std::vector<RangeReading>>
void each_member(Each& each, Ranges& ranges) { each.list(ranges); }
template <class Each, class Joint>
requires std::is_same_v<std::remove_const_t<Joint>, JointReading>
void each_member(Each& each, Joint& joint) { each(joint.position), each(joint.velocity); }
template <class Each, class Readings>
requires std::is_same_v<std::remove_const_t<Readings>, RobotReadings>
void each_member(Each& each, Readings& r) {
  each(r.tick), each(r.time), each(r.temperature);
  each.list(r.cameras), each.list(r.rangefinders), each.list(r.radios);
  each(r.left_encoder), each(r.right_encoder);
  each(r.lift.active), each(r.lift.calibrating), each(r.lift.position);
  each(r.lift.at_top), each(r.lift.at_bottom);
  each(r.magnet_voltage), each.list(r.joints);
}
template <class Each, class Devices>
requires std::is_same_v<std::remove_const_t<Devices>, RobotDevices>
void each_member(Each& each, Devices& d) {
  each(d.drive.left), each(d.drive.right), each(d.drive.left_target), each(d.drive.right_target);
  each.choice(d.lift.mode, LiftMode::calibrating), each(d.lift.target), each(d.lift.speed);
  each.choice(d.magnets.mode, Discharge::destructive), each(d.magnets.charge);
  each.list(d.joints);
}

}  // namespace stig
