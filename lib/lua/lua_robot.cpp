// SPDX-License-Identifier: MIT
// The robot's part of `robot`: its devices, kind by kind, and what no device tells.
#include <lua.hpp>
#include <type_traits>

#include "lua/lua_box.h"
#include "lua/lua_devices.h"
#include "lua/lua_libraries.h"
#include "robots/robot_description.h"

namespace stig::lua {

namespace {

/// Puts the figures of a reading into the table on top.
template <class Reading>
void put_fields(lua_State* state, const Reading& reading) {
  const auto put_field = [&](const char* name, const auto& value, const char* /*unit*/) {
    if constexpr (std::is_same_v<decltype(value), const bool&>) {
      put(state, name, value);
    } else {
      put(state, name, static_cast<double>(value));
    }
  };
  Reading::fields(put_field, reading);
}

template <class Kind>
constexpr const char* program_key() {
  if constexpr (requires { Kind::program_key; }) {
    return Kind::program_key;
  } else {
    return Kind::key;
  }
}

// Text that is run as Lua, so that the same text can be written into a program for ARGoS. It comes
// from the robot's file by a printer of our own, so it cannot fail but for memory.
void put_description(lua_State* state, const RobotModel& model) {
  const std::string text = "return " + robot_description(model);
  if (!load_text(state, text, "=description")) lua_error(state);
  lua_call(state, 0, 1);
  put(state, "description");
}

}  // namespace

RobotSide& robot_side(lua_State* state) {
  // See block_commands: the side went into the box as LuaSide.
  return *static_cast<RobotSide*>(static_cast<LuaSide*>(LuaBox::of(state).user()));
}
RobotCommands& robot_commands(lua_State* state) { return *robot_side(state).commands; }

void put_transform(lua_State* state, const Vec3& position, const Quat& orientation,
                   std::string_view anchor) {
  lua_createtable(state, 0, 3);
  push_vector(state, position);
  put(state, "position");
  push_quaternion(state, orientation);
  put(state, "orientation");
  put(state, "anchor", anchor);
  put(state, "transform");
}

void add_to_table(lua_State* state, const RobotSide& side, std::size_t number,
                  RangefinderKind /*kind*/) {
  const RangeDevice& device = side.model.rangefinders[number];
  // Rays go along the device's z axis in ARGoS's transforms.
  put_transform(state, device.p_B, turn_between({0, 0, 1}, device.direction),
                side.model.bodies[device.body].name);
}

template <class Kind>
void LuaDevice<Kind>::open(lua_State* state, RobotSide& side) {
  const auto& devices = Kind::devices(side.model);
  if (devices.empty()) return;
  lua_newtable(state);
  for (std::size_t i = 0; i < devices.size(); ++i) {
    lua_newtable(state);
    // Until the first step a device shows what it shows before anything has been measured.
    put_fields(state, reading_before<Kind>(devices[i]));
    add_to_table(state, side, i, Kind{});
    side.tables<Kind>().push_back(keep_table(state));
    put(state, devices[i].name.c_str());
  }
  put(state, program_key<Kind>());
}

template <class Kind>
void LuaDevice<Kind>::update(lua_State* state, const RobotSide& side,
                             const RobotReadings& readings) {
  const std::vector<int>& tables = side.tables<Kind>();
  const auto& told = Kind::readings(readings);
  // Readings of a caller may be shorter than the robot's lists (tests do so); nobody is given what
  // is not there.
  for (std::size_t i = 0; i < tables.size() && i < told.size(); ++i) {
    push_kept(state, tables[i]);
    put_fields(state, told[i]);
    lua_pop(state, 1);
  }
}

void open_robot(lua_State* state, RobotSide& side) {
  push_robot(state);
  DeviceKinds::each([&](auto kind) { LuaDevice<decltype(kind)>::open(state, side); });
  put_show(state);
  lua_newtable(state);
  put(state, "time", 0.0);
  put(state, "temperature", RobotReadings{}.temperature);
  side.system = keep_table(state);
  put(state, "system");
  put_description(state, side.model);
  if (is_of_2019(state)) {
    open_robot_2019(state, side);
    if (!side.model.radios.empty()) put_radios_2019(state, side.tables<RadioKind>());
  }
  lua_pop(state, 1);
}

void put_readings(lua_State* state, const RobotSide& side, const RobotReadings& readings) {
  push_kept(state, side.system);
  put(state, "time", readings.time);
  put(state, "temperature", readings.temperature);
  lua_pop(state, 1);
  DeviceKinds::each([&](auto kind) { LuaDevice<decltype(kind)>::update(state, side, readings); });
  if (is_of_2019(state)) put_received_2019(state, side.tables<RadioKind>());
}

}  // namespace stig::lua
