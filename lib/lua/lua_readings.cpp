// SPDX-License-Identifier: MIT
// Readings into the tables of `robot`, before each step.
#include <algorithm>
#include <lua.hpp>

#include "lua/lua_interface.h"
#include "lua/lua_libraries.h"

namespace stig {

namespace {

// New tables and vectors each step: a program may keep what it was given, and a later step must not
// change it under its hands.
void push_tag(lua_State* state, const TagReading& tag) {
  lua_createtable(state, 0, 5);
  lua_pushinteger(state, tag.id);
  put(state, "id");
  push_vector(state, tag.p_CT);
  put(state, "position");
  push_quaternion(state, tag.q_CT);
  put(state, "orientation");
  push_vector(state, tag.centre);
  put(state, "center");
  lua_createtable(state, 4, 0);
  for (std::size_t i = 0; i < tag.corners.size(); ++i) {
    push_vector(state, tag.corners[i]);
    lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
  }
  put(state, "corners");
}

// LEDs are not listed: the real camera is asked about a place of the image (detect_led).
void put_camera(lua_State* state, int table, const CameraReading& reading) {
  push_kept(state, table);
  put(state, "timestamp", reading.timestamp);
  lua_createtable(state, static_cast<int>(reading.tags.size()), 0);
  for (std::size_t i = 0; i < reading.tags.size(); ++i) {
    push_tag(state, reading.tags[i]);
    lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
  }
  put(state, "tags");
  lua_pop(state, 1);
}

void put_pair(lua_State* state, int table, const char* first, double a, const char* second,
              double b) {
  push_kept(state, table);
  put(state, first, a);
  put(state, second, b);
  lua_pop(state, 1);
}

void put_lift(lua_State* state, const RobotSide& side, const LiftReading& lift) {
  push_kept(state, side.lift);
  put(state, "position", lift.position);
  // The real robot tells the search for the top from that for the bottom; readings do not.
  put(state, "state",
      std::string_view(lift.calibrating ? "calibration_search_bottom"
                       : lift.active    ? "position_control"
                                        : "inactive"));
  push_kept(state, side.limits);
  put(state, "top", lift.at_top);
  put(state, "bottom", lift.at_bottom);
  lua_pop(state, 2);
}

}  // namespace

void put_readings(lua_State* state, const RobotSide& side, const RobotReadings& readings) {
  // Readings of a caller may be shorter than the robot's lists (tests do so); nobody is given what
  // is not there.
  const auto both = [](const auto& a, const auto& b) { return std::min(a.size(), b.size()); };
  put_pair(state, side.system, "time", readings.time, "temperature", readings.temperature);
  for (std::size_t i = 0; i < both(side.cameras, readings.cameras); ++i) {
    put_camera(state, side.cameras[i], readings.cameras[i]);
  }
  for (std::size_t i = 0; i < both(side.rangefinders, readings.rangefinders); ++i) {
    const RangeReading& range = readings.rangefinders[i];
    put_pair(state, side.rangefinders[i], "proximity", range.proximity, "illuminance",
             range.illuminance);
  }
  for (std::size_t i = 0; i < both(side.radios, readings.radios); ++i) {
    put_received(state, side.radios[i], readings.radios[i]);
  }
  for (std::size_t i = 0; i < both(side.joints, readings.joints); ++i) {
    const JointReading& joint = readings.joints[i];
    put_pair(state, side.joints[i], "position", joint.position, "velocity", joint.velocity);
  }
  if (side.model.drive) {  // mirrored, as the commands are
    put_pair(state, side.encoders, "left", readings.left_encoder, "right", -readings.right_encoder);
  }
  if (side.model.magnets) {
    push_kept(state, side.magnets);
    put(state, "voltage", readings.magnet_voltage);
    lua_pop(state, 1);
  }
  if (side.model.lift) put_lift(state, side, readings.lift);
}

void put_readings(lua_State* state, const BlockSide& side, const BlockReadings& readings) {
  push_kept(state, side.system);
  put(state, "time", readings.time);
  lua_pop(state, 1);
  const std::size_t count = std::min(side.radios.size(), readings.radios.size());
  for (std::size_t i = 0; i < count; ++i) put_received(state, side.radios[i], readings.radios[i]);
}

}  // namespace stig
