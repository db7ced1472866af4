// SPDX-License-Identifier: MIT
// Cameras: tags in their tables, and detect_led.
#include <algorithm>
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_devices.h"
#include "lua/lua_libraries.h"
#include "sensing/led_colour.h"

namespace stig::lua {

namespace {

int set_camera(lua_State* state, bool enabled) {
  RobotSide& side = robot_side(state);
  // The list grows to one entry a camera when a command is given, so that no command and "no
  // change" are the same: an empty list.
  side.commands->camera_enabled.resize(side.model.cameras.size());
  side.commands->camera_enabled[device_of(state)] = enabled;
  return 0;
}
int enable_camera(lua_State* state) { return set_camera(state, true); }
int disable_camera(lua_State* state) { return set_camera(state, false); }

/// detect_led(vector3 in the camera's frame): 0 to 4. As the real camera's program does it: the
/// mean chroma about a pixel, not the nearest LED. The place is where the program believes the LED
/// to be, so an error of its estimate shows.
int detect_led(lua_State* state) {
  const Vec3 p_C = vector_argument(state, 1, "camera_system.detect_led", "position");
  const RobotSide& side = robot_side(state);
  const std::size_t place = device_of(state);
  // A program that asks in init, or with the camera off, sees nothing: 0.
  const bool sees = side.readings != nullptr && place < side.readings->cameras.size() &&
                    side.readings->cameras[place].enabled;
  const auto pixel = sees ? project(side.model.cameras[place].intrinsics, p_C) : std::nullopt;
  std::uint8_t colour = 0;
  if (pixel) {
    LedWindow window(*pixel);
    const auto& leds = side.readings->cameras[place].leds;
    LuaBox::of(state).charge(state, leds.size());
    for (const LedReading& led : leds) window.add(led.centre, {led.y, led.u, led.v});
    colour = window.colour();
  }
  lua_pushinteger(state, colour);
  return 1;
}

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

/// Puts the camera into the list on top, and the first one as camera_system into the table under
/// it.
void put_camera(lua_State* state, RobotSide& side, std::size_t place) {
  const CameraDevice& camera = side.model.cameras[place];
  lua_newtable(state);
  put_function(state, "enable", enable_camera, place);
  put_function(state, "disable", disable_camera, place);
  put_function(state, "detect_led", detect_led, place);
  push_vector(state, ImagePoint{static_cast<double>(camera.intrinsics.width),
                                static_cast<double>(camera.intrinsics.height)});
  put(state, "resolution");
  put_transform(state, camera.X_BC.p, camera.X_BC.q, side.model.bodies[camera.body].name);
  put(state, "timestamp", 0.0);
  lua_newtable(state);
  put(state, "tags");
  side.tables<CameraKind>().push_back(keep_table(state));
  // The first camera has a name of its own in ARGoS, for robots that have one.
  if (place == 0) {
    lua_pushvalue(state, -1);
    lua_setfield(state, -4, "camera_system");
  }
  put(state, camera.name.c_str());
}

// LEDs are not listed: the real camera is asked about a place of the image (detect_led).
void put_picture(lua_State* state, int table, const CameraReading& reading) {
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

}  // namespace

template <>
void LuaDevice<CameraKind>::open(lua_State* state, RobotSide& side) {
  if (side.model.cameras.empty()) return;
  lua_newtable(state);
  for (std::size_t i = 0; i < side.model.cameras.size(); ++i) put_camera(state, side, i);
  put(state, CameraKind::key);
}

template <>
void LuaDevice<CameraKind>::update(lua_State* state, const RobotSide& side,
                                   const RobotReadings& readings) {
  const std::vector<int>& tables = side.tables<CameraKind>();
  for (std::size_t i = 0; i < std::min(tables.size(), readings.cameras.size()); ++i) {
    put_picture(state, tables[i], readings.cameras[i]);
  }
}

}  // namespace stig::lua
