// SPDX-License-Identifier: MIT
// The robot's devices and what a program can tell them to do. Names and units are those of the
// real BuilderBot's interface in ARGoS; docs/controllers.md lists them.
#include <algorithm>
#include <array>
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_interface.h"
#include "lua/lua_libraries.h"
#include "robots/robot_description.h"
#include "sensing/led_colour.h"

namespace stig {

namespace {

// Shown values go into each frame of a trace: bounded, so that programs do not decide its size.
constexpr std::size_t kMostShown = 256;  ///< of each kind in a step
constexpr std::size_t kMostShownText = 1000;

RobotSide& robot_side(lua_State* state) {
  // See block_commands: the side went into the box as LuaSide.
  return *static_cast<RobotSide*>(static_cast<LuaSide*>(LuaBox::of(state).user()));
}
RobotCommands& robot_commands(lua_State* state) { return *robot_side(state).commands; }

// ---- Camera ----

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

// As the real camera's program does it: the mean chroma about a pixel, not the nearest LED. The
// place is where the program believes the LED to be, so an error of its estimate shows.
/// detect_led(vector3 in the camera's frame): 0 to 4.
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

// ---- Wheels, lift, magnets, joints ----

/// The motors are mirror images of each other: ahead is (+v, -v).
// What goes on to the robot is ahead for both, in m/s of the rims.
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
  // Both words are in use in published programs.
  if (mode == "constructive") {
    discharge = Discharge::constructive;
  } else if (mode == "destructive") {
    discharge = Discharge::destructive;
  } else if (mode == "disable" || mode == "disabled") {
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

int robot_send(lua_State* state) {
  RobotSide& side = robot_side(state);
  add_message(state, side.commands->sends, side.model.radios.size());
  return 0;
}

// ---- Lights, and what is shown ----

struct NamedColour {
  std::string_view name;
  Rgb rgb;
};
// ARGoS's names of colours and their values (CColor), as far as programs use them.
constexpr std::array<NamedColour, 12> kColours{{{"black", {0, 0, 0}},
                                                {"white", {255, 255, 255}},
                                                {"red", {255, 0, 0}},
                                                {"green", {0, 255, 0}},
                                                {"blue", {0, 0, 255}},
                                                {"magenta", {255, 0, 255}},
                                                {"cyan", {0, 255, 255}},
                                                {"yellow", {255, 255, 0}},
                                                {"orange", {255, 140, 0}},
                                                {"brown", {165, 42, 42}},
                                                {"purple", {160, 32, 240}},
                                                {"gray", {128, 128, 128}}}};

/// A name, "#rrggbb", or three numbers from 0 to 255, from `index` on.
Rgb rgb_argument(lua_State* state, int index, const char* function) {
  if (lua_type(state, index) == LUA_TNUMBER) {
    std::array<std::uint8_t, 3> parts{};
    for (int i = 0; i < 3; ++i) {
      parts[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
          integer_argument(state, index + i, function, "red, green or blue", 0, 255));
    }
    return {parts[0], parts[1], parts[2]};
  }
  const std::string_view text = text_argument(state, index, function, "color");
  const auto named = std::find_if(kColours.begin(), kColours.end(),
                                  [&](const NamedColour& c) { return c.name == text; });
  if (named != kColours.end()) return named->rgb;
  const auto rgb = parse_color(text);
  if (!rgb) bad_argument(state, index, function, "color", "the name of a colour or \"#rrggbb\"");
  return *rgb;
}

// The last command of a step holds.
void set_led(RobotCommands& commands, std::size_t led, Rgb rgb) {
  const auto set = std::find_if(commands.leds.begin(), commands.leds.end(),
                                [&](const auto& entry) { return entry.first == led; });
  if (set == commands.leds.end()) {
    commands.leds.emplace_back(led, rgb);
  } else {
    set->second = rgb;
  }
}
int set_leds(lua_State* state) {
  const Rgb rgb = rgb_argument(state, 1, "leds.set_leds");
  RobotSide& side = robot_side(state);
  for (std::size_t i = 0; i < side.model.leds.size(); ++i) set_led(*side.commands, i, rgb);
  return 0;
}
int set_led_index(lua_State* state) {
  RobotSide& side = robot_side(state);
  const auto count = static_cast<std::int64_t>(side.model.leds.size());
  const std::int64_t led = integer_argument(state, 1, "leds.set_led_index", "index", 1, count);
  const Rgb rgb = rgb_argument(state, 2, "leds.set_led_index");
  set_led(*side.commands, static_cast<std::size_t>(led - 1), rgb);
  return 0;
}

// Linear search: the list has at most kMostShown entries, and searching it is charged.
/// Sets the value of a name in a list that stays short.
template <class List, class Value>
void show(lua_State* state, List& list, std::string_view name, Value value) {
  if (name.size() > kMostShownText) luaL_error(state, "robot.show: the name is too long");
  LuaBox::of(state).charge(state, 10 + list.size());
  const auto old = std::find_if(list.begin(), list.end(),
                                [&](const auto& entry) { return entry.first == name; });
  if (old != list.end()) {
    old->second = std::move(value);
    return;
  }
  if (list.size() >= kMostShown) luaL_error(state, "robot.show: too much in one step");
  list.emplace_back(name, std::move(value));
}
int show_number(lua_State* state) {
  const std::string_view name = text_argument(state, 1, "show.number", "name");
  const double number = number_argument(state, 2, "show.number", "value");
  show(state, robot_commands(state).user.numbers, name, number);
  return 0;
}
int show_text(lua_State* state) {
  const std::string_view name = text_argument(state, 1, "show.text", "name");
  luaL_checkany(state, 2);
  std::string text(push_text(state, 2).substr(0, kMostShownText));
  show(state, robot_commands(state).user.texts, name, std::move(text));
  return 0;
}
int show_arrow(lua_State* state) {
  const Vec3 from = vector_argument(state, 1, "show.arrow", "from");
  const Vec3 to = vector_argument(state, 2, "show.arrow", "to");
  const Rgb rgb = lua_isnoneornil(state, 3) ? Rgb{} : rgb_argument(state, 3, "show.arrow");
  auto& arrows = robot_commands(state).user.arrows;
  if (arrows.size() >= kMostShown) return luaL_error(state, "robot.show: too much in one step");
  arrows.push_back({from, to, rgb});
  return 0;
}

// ---- The tables ----

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
  side.cameras.push_back(keep_table(state));
  // The first camera has a name of its own in ARGoS, for robots that have one.
  if (place == 0) {
    lua_pushvalue(state, -1);
    lua_setfield(state, -4, "camera_system");
  }
  put(state, camera.name.c_str());
}

void put_cameras(lua_State* state, RobotSide& side) {
  if (side.model.cameras.empty()) return;
  lua_newtable(state);
  for (std::size_t i = 0; i < side.model.cameras.size(); ++i) put_camera(state, side, i);
  put(state, "cameras");
}

void put_drive(lua_State* state, RobotSide& side) {
  if (!side.model.drive) return;
  lua_newtable(state);
  put_function(state, "set_target_velocity", set_velocity);
  lua_newtable(state);
  put(state, "left", 0.0);
  put(state, "right", 0.0);
  side.encoders = keep_table(state);
  put(state, "encoders");
  put(state, "differential_drive");
}

void put_lift(lua_State* state, RobotSide& side) {
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
  side.limits = keep_table(state);
  put(state, "limit_switches");
  side.lift = keep_table(state);
  put(state, "lift_system");
}

void put_magnets(lua_State* state, RobotSide& side) {
  if (!side.model.magnets) return;
  lua_newtable(state);
  put_function(state, "set_discharge_mode", set_discharge);
  put(state, "voltage", 0.0);
  side.magnets = keep_table(state);
  put(state, "electromagnet_system");
}

void put_rangefinders(lua_State* state, RobotSide& side) {
  if (side.model.rangefinders.empty()) return;
  lua_newtable(state);
  // Until the first step a rangefinder shows what it shows when nothing is near.
  for (const RangeDevice& device : side.model.rangefinders) {
    lua_newtable(state);
    put(state, "proximity", without_hit(device));
    put(state, "illuminance", 0.0);
    // Rays go along the device's z axis in ARGoS's transforms.
    put_transform(state, device.p_B, turn_between({0, 0, 1}, device.direction),
                  side.model.bodies[device.body].name);
    side.rangefinders.push_back(keep_table(state));
    put(state, device.name.c_str());
  }
  put(state, "rangefinders");
}

void put_radios(lua_State* state, RobotSide& side) {
  if (side.model.radios.empty()) return;
  lua_newtable(state);
  for (std::size_t i = 0; i < side.model.radios.size(); ++i) {
    push_radio(state, i, robot_send);
    side.radios.push_back(keep_table(state));
    put(state, side.model.radios[i].name.c_str());
  }
  put(state, "simple_radios");
}

void put_joints(lua_State* state, RobotSide& side) {
  if (side.model.actuators.empty()) return;
  lua_newtable(state);
  for (std::size_t i = 0; i < side.model.actuators.size(); ++i) {
    lua_newtable(state);
    put_function(state, "set_target", set_joint, i);
    put(state, "position", 0.0);
    put(state, "velocity", 0.0);
    side.joints.push_back(keep_table(state));
    put(state, side.model.actuators[i].name.c_str());
  }
  put(state, "joints");
}

void put_lights_and_show(lua_State* state, const RobotSide& side) {
  if (!side.model.leds.empty()) {
    lua_newtable(state);
    set_functions(state, {{"set_leds", set_leds}, {"set_led_index", set_led_index}});
    put(state, "leds");
  }
  lua_newtable(state);
  set_functions(state, {{"number", show_number}, {"text", show_text}, {"arrow", show_arrow}});
  put(state, "show");
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

void open_robot(lua_State* state, RobotSide& side) {
  push_robot(state);
  put_cameras(state, side);
  put_drive(state, side);
  put_lift(state, side);
  put_magnets(state, side);
  put_rangefinders(state, side);
  put_radios(state, side);
  put_joints(state, side);
  put_lights_and_show(state, side);
  lua_newtable(state);
  put(state, "time", 0.0);
  put(state, "temperature", RobotReadings{}.temperature);
  side.system = keep_table(state);
  put(state, "system");
  put_description(state, side.model);
  lua_pop(state, 1);
}

}  // namespace stig
