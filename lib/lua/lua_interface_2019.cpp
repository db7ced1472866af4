// SPDX-License-Identifier: MIT
// What programs of 2019 find under `robot` besides: robot.nfc, robot.radios, robot.debug, and
// places told from the anchors of that time. After the plugin for ARGoS of December 2019
// (github.com/allsey87/argos3-srocs, c9e5138).
#include <lua.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "lua/lua_box.h"
#include "lua/lua_devices.h"
#include "lua/lua_libraries.h"
#include "robots/robot_extent.h"

namespace stig::lua {

namespace {

constexpr std::size_t kMostDrawing = 1000;  ///< bytes of a text for robot.debug.draw

/// The radio that programs know as nfc: that of the name, otherwise the first.
std::size_t nfc_radio(const RobotModel& model) {
  const auto& radios = model.radios;
  const auto named = std::find_if(radios.begin(), radios.end(),
                                  [](const auto& radio) { return radio.name == "nfc"; });
  return named == radios.end() ? 0 : static_cast<std::size_t>(named - radios.begin());
}

/// robot.nfc.write(text or list of bytes).
int nfc_write(lua_State* state) {
  RobotSide& side = robot_side(state);
  add_message(state, side.commands->sends, side.model.radios.size());
  return 0;
}

/// One number after spaces and commas, or nothing.
std::optional<double> next_number(const char*& at) {
  while (*at == ' ' || *at == ',') ++at;
  char* end = nullptr;
  const double number = std::strtod(at, &end);
  if (end == at || !std::isfinite(number)) return std::nullopt;
  at = end;
  return number;
}
/// "(1,2,3)"; moves behind it.
std::optional<Vec3> next_vector(const char*& at) {
  if (*at != '(') return std::nullopt;
  ++at;
  const auto x = next_number(at), y = next_number(at), z = next_number(at);
  if (!x || !y || !z || *at != ')') return std::nullopt;
  ++at;
  return Vec3{*x, *y, *z};
}

/// robot.debug.draw('arrow(red)(0,0,0)(1,0,0)'): arrows are shown as those of robot.show, whose
/// limits hold. Other drawings have nothing to show them, and are passed over.
int draw(lua_State* state) {
  const std::string text(text_argument(state, 1, "debug.draw", "drawing"));
  LuaBox::of(state).charge(state, 10 + text.size());
  constexpr std::string_view kArrow = "arrow(";
  const auto close = text.find(')');
  if (!text.starts_with(kArrow) || close == text.npos || text.size() > kMostDrawing) return 0;
  const char* at = text.c_str() + close + 1;
  const auto from = next_vector(at), to = next_vector(at);
  if (!from || !to) return luaL_error(state, "debug.draw: an arrow is arrow(colour)(x,y,z)(x,y,z)");
  // Through the program's own robot.show.arrow it could be replaced; the function is kept instead.
  lua_pushvalue(state, lua_upvalueindex(1));
  push_vector(state, *from);
  push_vector(state, *to);
  const std::string colour = text.substr(kArrow.size(), close - kArrow.size());
  lua_pushlstring(state, colour.data(), colour.size());
  lua_call(state, 3, 0);
  return 0;
}

/// Puts robot.debug into `robot`, which is on top: lines of the log by the global functions, and
/// arrows by robot.show.
void put_debug(lua_State* state) {
  lua_createtable(state, 0, 3);
  for (const char* name : {"log", "logerr"}) {
    lua_getglobal(state, name);
    lua_setfield(state, -2, name);
  }
  lua_getfield(state, -2, "show");
  lua_getfield(state, -1, "arrow");
  lua_remove(state, -2);
  lua_pushcclosure(state, draw, 1);
  lua_setfield(state, -2, "draw");
  put(state, "debug");
}

/// Bodies that go with the lift are anchored to the end effector, which is what bears the magnets,
/// in the middle of its underside; all others to the robot's origin.
struct Anchor {
  std::string_view name = "origin";
  Vec3 origin;  ///< frame R, with the lift down
};
Anchor anchor_of(const RobotModel& model, std::size_t body) {
  // Models that callers make up may have devices without a chassis.
  if (!model.lift || !model.magnets || model.magnets->poles.empty()) return {};
  if (model.joints.empty() || !robots::lifted_bodies(model)[body]) return {};
  const BodyModel& effector = model.bodies[model.magnets->poles.front().body];
  const robots::BodyExtent extent = robots::extent_of(effector);
  return {"end_effector",
          {(extent.low.x + extent.high.x) / 2, (extent.low.y + extent.high.y) / 2, extent.low.z}};
}

/// Puts `transform` anew into the device's table, by its kept reference.
void put_anchored(lua_State* state, const RobotModel& model, int table, std::size_t body,
                  const Pose& X_BD) {
  const Anchor anchor = anchor_of(model, body);
  const Pose X_RD = model.bodies[body].X_RB * X_BD;
  push_kept(state, table);
  put_transform(state, X_RD.p - anchor.origin, X_RD.q, anchor.name);
  lua_pop(state, 1);
}

}  // namespace

bool is_of_2019(lua_State* state) {
  return LuaBox::of(state).program().interface == InterfaceLevel::of_2019;
}

void open_robot_2019(lua_State* state, const RobotSide& side) {
  const RobotModel& model = side.model;
  for (std::size_t i = 0; i < model.rangefinders.size(); ++i) {
    const RangeDevice& finder = model.rangefinders[i];
    put_anchored(state, model, side.tables<RangefinderKind>()[i], finder.body,
                 {finder.p_B, turn_between({0, 0, 1}, finder.direction)});
  }
  for (std::size_t i = 0; i < model.cameras.size(); ++i) {
    const CameraDevice& camera = model.cameras[i];
    put_anchored(state, model, side.tables<CameraKind>()[i], camera.body, camera.X_BC);
  }
  const std::vector<int>& radios = side.tables<RadioKind>();
  if (!radios.empty()) {
    push_kept(state, radios[nfc_radio(model)]);
    put_function(state, "write", nfc_write, nfc_radio(model));
    put(state, "nfc");
  }
  put_debug(state);
}

void put_radios_2019(lua_State* state, const std::vector<int>& radios) {
  lua_getfield(state, -1, "simple_radios");
  put(state, "radios");
  // Their function for sending has another name.
  for (const int radio : radios) {
    push_kept(state, radio);
    lua_pushliteral(state, "send");
    lua_rawget(state, -2);
    put(state, "tx_data");
    lua_pop(state, 1);
  }
  put_received_2019(state, radios);
}

void put_received_2019(lua_State* state, const std::vector<int>& radios) {
  for (const int radio : radios) {
    push_kept(state, radio);
    lua_pushliteral(state, "recv");
    lua_rawget(state, -2);
    put(state, "rx_data");
    lua_pop(state, 1);
  }
}

}  // namespace stig::lua
