// SPDX-License-Identifier: MIT
// Wheels, lift, electromagnets and other joints: what a program can tell them to do, and what
// they tell.
#include <cassert>
#include <lua.hpp>
#include <string_view>

#include "lua/lua_devices.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

/// The motors are mirror images of each other: ahead is (+v, -v). What goes on to the robot is
/// ahead for both, in m/s of the rims.
int set_velocity(lua_State* state) {
  constexpr const char* kName = "differential_drive.set_target_velocity";
  const double left = number_argument(state, 1, kName, "left");
  const double right = number_argument(state, 2, kName, "right");
  robot_commands(state).wheels = {left, -right};
  return 0;
}

int set_lift(lua_State* state) {
  const double position = number_argument(state, 1, "lift_system.set_position", "position");
  robot_commands(state).lift = {LiftCommand::Kind::position, position};
  return 0;
}
int stop_lift(lua_State* state) {
  robot_commands(state).lift = {LiftCommand::Kind::stop, 0};
  return 0;
}
int calibrate_lift(lua_State* state) {
  robot_commands(state).lift = {LiftCommand::Kind::calibrate, 0};
  return 0;
}

int set_discharge(lua_State* state) {
  constexpr const char* kName = "electromagnet_system.set_discharge_mode";
  const std::string_view mode = text_argument(state, 1, kName, "mode");
  auto& discharge = robot_commands(state).discharge;
  if (mode == "constructive") {
    discharge = Discharge::constructive;
  } else if (mode == "destructive") {
    discharge = Discharge::destructive;
  } else if (mode == "disable" || mode == "disabled") {
    // Both words are in use in published programs.
    discharge = Discharge::disable;
  } else {
    bad_argument(state, 1, kName, "mode", "'constructive', 'destructive' or 'disable'");
  }
  return 0;
}

int set_joint(lua_State* state) {
  RobotSide& side = robot_side(state);
  const double target = number_argument(state, 1, "joint.set_target", "target");
  // Entries that are not set stay as they were: nullopt is no command.
  side.commands->joints.resize(side.model.actuators.size());
  side.commands->joints[device_of(state)] = target;
  return 0;
}

}  // namespace

template <>
void LuaDevice<DriveKind>::open(lua_State* state, RobotSide& side) {
  if (!side.model.drive) return;
  lua_newtable(state);
  put_function(state, "set_target_velocity", set_velocity);
  lua_newtable(state);
  put(state, "left", 0.0);
  put(state, "right", 0.0);
  side.tables<DriveKind>() = {keep_table(state)};
  put(state, "encoders");
  put(state, DriveKind::key);
}

template <>
void LuaDevice<DriveKind>::update(lua_State* state, const RobotSide& side,
                                  const RobotReadings& readings) {
  if (!side.model.drive) return;
  assert(!side.tables<DriveKind>().empty());
  push_kept(state, side.tables<DriveKind>().front());
  put(state, "left", readings.left_encoder);
  put(state, "right", -readings.right_encoder);  // mirrored, as the commands are
  lua_pop(state, 1);
}

template <>
void LuaDevice<LiftKind>::open(lua_State* state, RobotSide& side) {
  if (!side.model.lift) return;
  lua_newtable(state);
  put_function(state, "set_position", set_lift);
  put_function(state, "stop", stop_lift);
  put_function(state, "calibrate", calibrate_lift);
  put(state, "state", "inactive");
  put(state, "position", 0.0);
  lua_newtable(state);
  put(state, "top", false);
  put(state, "bottom", false);
  const int limits = keep_table(state);
  put(state, "limit_switches");
  side.tables<LiftKind>() = {keep_table(state), limits};
  put(state, "lift_system");
}

template <>
void LuaDevice<LiftKind>::update(lua_State* state, const RobotSide& side,
                                 const RobotReadings& readings) {
  if (!side.model.lift) return;
  assert(side.tables<LiftKind>().size() == 2);
  const LiftReading& lift = readings.lift;
  push_kept(state, side.tables<LiftKind>()[0]);
  put(state, "position", lift.position);
  // The real robot tells the search for the top from that for the bottom; readings do not.
  put(state, "state",
      std::string_view(lift.calibrating ? "calibration_search_bottom"
                       : lift.active    ? "position_control"
                                        : "inactive"));
  push_kept(state, side.tables<LiftKind>()[1]);
  put(state, "top", lift.at_top);
  put(state, "bottom", lift.at_bottom);
  lua_pop(state, 2);
}

template <>
void LuaDevice<ElectromagnetsKind>::open(lua_State* state, RobotSide& side) {
  if (!side.model.magnets) return;
  lua_newtable(state);
  put_function(state, "set_discharge_mode", set_discharge);
  put(state, "voltage", 0.0);
  side.tables<ElectromagnetsKind>() = {keep_table(state)};
  put(state, "electromagnet_system");
}

template <>
void LuaDevice<ElectromagnetsKind>::update(lua_State* state, const RobotSide& side,
                                           const RobotReadings& readings) {
  if (!side.model.magnets) return;
  assert(!side.tables<ElectromagnetsKind>().empty());
  push_kept(state, side.tables<ElectromagnetsKind>().front());
  put(state, "voltage", readings.magnet_voltage);
  lua_pop(state, 1);
}

void add_to_table(lua_State* state, const RobotSide& /*side*/, std::size_t number,
                  ActuatorKind /*kind*/) {
  put_function(state, "set_target", set_joint, number);
}

}  // namespace stig::lua
