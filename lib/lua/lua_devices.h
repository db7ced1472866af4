// SPDX-License-Identifier: MIT
// What a program finds under `robot` of each kind of device (robots/device_kinds.h): tables that
// are made once, and readings that are put into them before each step.
//
// Kinds whose readings are a few figures need nothing here: they get a table for each device,
// robot.compasses.NAME.heading. Those that tell or take more have functions of their own below.
// Names and units are those of the real BuilderBot's interface in ARGoS; docs/controllers.md lists
// them.
#pragma once

#include <string_view>

#include "lua/lua_interface.h"
#include "lua/uses.h"

namespace stig::lua {

RobotSide& robot_side(lua_State* state);
RobotCommands& robot_commands(lua_State* state);

/// Puts where a device is into the table on top; the place is from the middle of the body.
void put_transform(lua_State* state, const Vec3& position, const Quat& orientation,
                   std::string_view anchor);

/// Puts `show` into the table on top.
void put_show(lua_State* state);

/// What the table on top, of a device by its number, holds besides its readings.
inline void add_to_table(lua_State* /*state*/, const RobotSide& /*side*/, std::size_t /*number*/,
                         auto /*kind*/) {}
void add_to_table(lua_State* state, const RobotSide& side, std::size_t number,
                  RangefinderKind kind);
void add_to_table(lua_State* state, const RobotSide& side, std::size_t number, ActuatorKind kind);

/// For kinds without functions of their own; where these are instantiated is lua_robot.cpp.
template <class Kind>
struct LuaDevice {
  /// Adds what the robot has of this kind to `robot`, which is on top.
  static void open(lua_State* state, RobotSide& side);
  static void update(lua_State* state, const RobotSide& side, const RobotReadings& readings);
};

// Kinds with functions of their own.
template <>
void LuaDevice<CameraKind>::open(lua_State* state, RobotSide& side);
template <>
void LuaDevice<CameraKind>::update(lua_State* state, const RobotSide& side,
                                   const RobotReadings& readings);
template <>
void LuaDevice<DriveKind>::open(lua_State* state, RobotSide& side);
template <>
void LuaDevice<DriveKind>::update(lua_State* state, const RobotSide& side,
                                  const RobotReadings& readings);
template <>
void LuaDevice<LiftKind>::open(lua_State* state, RobotSide& side);
template <>
void LuaDevice<LiftKind>::update(lua_State* state, const RobotSide& side,
                                 const RobotReadings& readings);
template <>
void LuaDevice<ElectromagnetsKind>::open(lua_State* state, RobotSide& side);
template <>
void LuaDevice<ElectromagnetsKind>::update(lua_State* state, const RobotSide& side,
                                           const RobotReadings& readings);
template <>
void LuaDevice<RadioKind>::open(lua_State* state, RobotSide& side);
template <>
void LuaDevice<RadioKind>::update(lua_State* state, const RobotSide& side,
                                  const RobotReadings& readings);
template <>
void LuaDevice<LedKind>::open(lua_State* state, RobotSide& side);
template <>
void LuaDevice<LedKind>::update(lua_State* state, const RobotSide& side,
                                const RobotReadings& readings);

}  // namespace stig::lua
