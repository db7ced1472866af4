// SPDX-License-Identifier: MIT
// Scripts of experiments: a box without `robot`, whose functions are handed the world as an
// argument, so that a script's helper functions can be tried with a world of tables. Unlike a
// robot's program a script knows every pose: nothing that it answers reaches robots but what it
// does to the world.
#include "lua/lua_script.h"

#include <cassert>

#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_callbacks.h"
#include "lua/lua_interface.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

// What a call costs the program; a look reads a pose, placing a body tests it against all others.
constexpr std::uint64_t kLookCost = 20;  ///< instructions
constexpr std::uint64_t kNameCost = 1, kPlaceCost = 10'000;
constexpr std::size_t kMostName = 64;
constexpr double kMostSeconds = 1e6;   ///< of a push
constexpr double kMostGrip = 10;       ///< times the friction of the materials
constexpr std::uint64_t kBodies = 20;  ///< of a robot, about: what a search by name passes
constexpr std::int64_t kFaces = 6, kLedsOfFace = 4;

struct ScriptSide : LuaSide {
  ScriptWorld* world = nullptr;
};

ScriptWorld& world_of(lua_State* state) {
  // Every access to the world goes through here, so none is free.
  LuaBox::of(state).charge(state, kLookCost);
  auto* side = static_cast<LuaSide*>(LuaBox::of(state).user());
  return *static_cast<ScriptSide*>(side)->world;
}

std::size_t place_argument(lua_State* state, const char* function, std::size_t count) {
  // Numbers in Lua count from 1, places here from 0.
  return static_cast<std::size_t>(
      integer_argument(state, 1, function, "number", 1, static_cast<std::int64_t>(count)) - 1);
}

void put_pose(lua_State* state, const Pose& pose) {
  push_vector(state, pose.p);
  put(state, "position");
  push_quaternion(state, pose.q);
  put(state, "orientation");
}

int time(lua_State* state) {
  lua_pushnumber(state, world_of(state).time());
  return 1;
}
int seed(lua_State* state) {
  lua_pushinteger(state, static_cast<lua_Integer>(world_of(state).seed()));
  return 1;
}
int blocks(lua_State* state) {
  lua_pushinteger(state, static_cast<lua_Integer>(world_of(state).blocks()));
  return 1;
}
int robots(lua_State* state) {
  lua_pushinteger(state, static_cast<lua_Integer>(world_of(state).robots()));
  return 1;
}

int block(lua_State* state) {
  const ScriptWorld& world = world_of(state);
  const ScriptBlock one = world.block(place_argument(state, "world.block", world.blocks()));
  lua_newtable(state);
  put(state, "name", one.name);
  put_pose(state, one.X_WB);
  put(state, "color", double(one.colour));
  put(state, "left", one.left);
  lua_newtable(state);
  for (std::size_t face = 0; face < one.faces.size(); ++face) {
    lua_pushinteger(state, one.faces[face]);
    lua_rawseti(state, -2, static_cast<lua_Integer>(face) + 1);
  }
  put(state, "faces");
  // A block that is part of no lattice has no cell; 0 is "none" and others count from 1.
  if (one.lattice == 0) return 1;
  put(state, "lattice", double(one.lattice));
  put(state, "x", double(one.x));
  put(state, "y", double(one.y));
  put(state, "z", double(one.z));
  return 1;
}

int robot(lua_State* state) {
  const ScriptWorld& world = world_of(state);
  const ScriptRobot one = world.robot(place_argument(state, "world.robot", world.robots()));
  lua_newtable(state);
  put(state, "name", one.name);
  put_pose(state, one.X_WR);
  put(state, "failed", one.failed);
  put(state, "halted", one.halted);
  put(state, "driven", one.driven);
  return 1;
}

ScriptThing named(lua_State* state, const ScriptWorld& world, const char* function) {
  const std::string_view name = text_argument(state, 1, function, "name");
  // A linear search among names, charged by their number.
  LuaBox::of(state).charge(state, kNameCost * (world.blocks() + world.robots()));
  const auto thing = world.find(name);
  if (!thing) luaL_error(state, "%s: nothing is called '%s'", function, lua_tostring(state, 1));
  return *thing;
}

/// Likewise, of one kind.
ScriptThing block_named(lua_State* state, const ScriptWorld& world, const char* function) {
  const ScriptThing thing = named(state, world, function);
  if (thing.robot) luaL_error(state, "%s: '%s' is no block", function, lua_tostring(state, 1));
  return thing;
}
ScriptThing robot_named(lua_State* state, const ScriptWorld& world, const char* function) {
  const ScriptThing thing = named(state, world, function);
  if (!thing.robot) luaL_error(state, "%s: '%s' is no robot", function, lua_tostring(state, 1));
  return thing;
}

int push_thing(lua_State* state, ScriptThing thing, const char* function) {
  const Vec3 force = vector_argument(state, 2, function, "force");
  // Without a time the push acts in the next step of physics alone.
  const double seconds =
      lua_isnoneornil(state, 3) ? 0 : number_argument(state, 3, function, "seconds");
  if (seconds < 0 || seconds > kMostSeconds) {
    luaL_error(state, "%s: seconds must be from 0 to a million", function);
  }
  if (!world_of(state).push(thing, force, seconds)) {
    luaL_error(state, "%s: too many pushes at a time", function);
  }
  return 0;
}

int push_block(lua_State* state) {
  const ScriptThing thing = named(state, world_of(state), "world.push");
  return push_thing(state, thing, "world.push");
}
// By number, for loops over all blocks: without a search by name each.
int block_push(lua_State* state) {
  const std::size_t place = place_argument(state, "world.push_block", world_of(state).blocks());
  return push_thing(state, {false, place}, "world.push_block");
}
int robot_push(lua_State* state) {
  const std::size_t place = place_argument(state, "world.push_robot", world_of(state).robots());
  return push_thing(state, {true, place}, "world.push_robot");
}

/// true; or false and the reason. A place that is taken is no error: scripts try another.
int place(lua_State* state) {
  ScriptWorld& world = world_of(state);
  const ScriptThing thing = named(state, world, "world.place");
  const Vec3 at = vector_argument(state, 2, "world.place", "position");
  std::optional<Quat> turn;
  if (!lua_isnoneornil(state, 3)) {
    turn = quaternion_argument(state, 3, "world.place", "orientation");
  }
  LuaBox::of(state).charge(state, kPlaceCost);
  const std::string problem = world.place(thing, at, turn);
  lua_pushboolean(state, problem.empty() ? 1 : 0);
  if (problem.empty()) return 1;
  lua_pushlstring(state, problem.data(), problem.size());
  return 2;
}

int halt(lua_State* state) {
  ScriptWorld& world = world_of(state);
  world.halt(robot_named(state, world, "world.halt").place);
  return 0;
}

int set_color(lua_State* state) {
  ScriptWorld& world = world_of(state);
  const ScriptThing thing = block_named(state, world, "world.set_color");
  const auto colour = integer_argument(state, 2, "world.set_color", "color", 0, 4);
  world.set_colour(thing.place, static_cast<int>(colour));
  return 0;
}

int set_camera(lua_State* state) {
  ScriptWorld& world = world_of(state);
  const ScriptThing robot = robot_named(state, world, "world.set_camera");
  world.set_camera(robot.place, bool_argument(state, 2, "world.set_camera", "on"));
  return 0;
}

int set_radio(lua_State* state) {
  ScriptWorld& world = world_of(state);
  const ScriptThing thing = named(state, world, "world.set_radio");
  world.set_radio(thing, bool_argument(state, 2, "world.set_radio", "on"));
  return 0;
}

/// A bit for each LED of these faces and places, from 1; 0: of all.
std::uint32_t leds_of(std::int64_t face, std::int64_t place) {
  std::uint32_t out = 0;
  for (std::int64_t i = 0; i < kFaces * kLedsOfFace; ++i) {
    const bool on_face = face == 0 || i / kLedsOfFace == face - 1;
    if (on_face && (place == 0 || i % kLedsOfFace == place - 1)) out |= std::uint32_t{1} << i;
  }
  return out;
}

int kill_leds(lua_State* state) {
  constexpr const char* kName = "world.set_leds";
  ScriptWorld& world = world_of(state);
  const ScriptThing block = block_named(state, world, kName);
  const bool on = bool_argument(state, 2, kName, "on");
  const auto optional = [state](int index, const char* name, std::int64_t most) {
    if (lua_isnoneornil(state, index)) return std::int64_t{0};
    return integer_argument(state, index, kName, name, 1, most);
  };
  const std::int64_t place = optional(3, "led", kLedsOfFace), face = optional(4, "face", kFaces);
  world.set_leds(block.place, leds_of(face, place), on);
  return 0;
}

int set_friction(lua_State* state) {
  constexpr const char* kName = "world.set_friction";
  ScriptWorld& world = world_of(state);
  const std::string_view body = text_argument(state, 1, kName, "name");
  const double factor = number_argument(state, 2, kName, "factor");
  if (factor < 0 || factor > kMostGrip) luaL_error(state, "%s: factor must be from 0 to 10", kName);
  LuaBox::of(state).charge(state, kNameCost * (world.blocks() + kBodies * world.robots()));
  if (!world.set_friction(body, factor)) {
    luaL_error(state, "%s: nothing is called '%s'", kName, lua_tostring(state, 1));
  }
  return 0;
}

/// The new block's number; or nil and the reason.
int drop(lua_State* state) {
  const Vec3 at = vector_argument(state, 1, "world.drop", "position");
  const double yaw = lua_isnoneornil(state, 2) ? 0 : number_argument(state, 2, "world.drop", "yaw");
  std::string problem;
  const auto place = world_of(state).drop({at, rotation({0, 0, yaw})}, problem);
  if (place) {
    lua_pushinteger(state, static_cast<lua_Integer>(*place) + 1);
    return 1;
  }
  lua_pushnil(state);
  lua_pushlstring(state, problem.data(), problem.size());
  return 2;
}

int stop(lua_State* state) {
  world_of(state).stop(std::string(text_argument(state, 1, "world.stop", "reason")));
  return 0;
}

// Measures are the results of an experiment, one number a name, the last of which holds.
int measure(lua_State* state) {
  const std::string_view name = text_argument(state, 1, "world.measure", "name");
  if (name.size() > kMostName) luaL_error(state, "world.measure: the name is too long");
  const double value = number_argument(state, 2, "world.measure", "value");
  world_of(state).measure(std::string(name), value);
  return 0;
}

struct ScriptJob {
  const char* function = nullptr;  ///< to call
  // Whether the text has come to its end tells "failed" from "has no callback".
  bool loaded = false;  ///< the text has run to its end
};

int open_and_run(lua_State* state) {
  push_robot(state);  // for log and print; a script is no robot
  lua_pop(state, 1);
  lua_pushnil(state);
  lua_setglobal(state, "robot");
  lua_newtable(state);
  set_functions(state, {{"time", time},
                        {"seed", seed},
                        {"blocks", blocks},
                        {"block", block},
                        {"robots", robots},
                        {"robot", robot},
                        {"place", place},
                        {"push", push_block},
                        {"halt", halt},
                        {"set_color", set_color},
                        {"set_camera", set_camera},
                        {"set_radio", set_radio},
                        {"set_leds", kill_leds},
                        {"set_friction", set_friction},
                        {"push_block", block_push},
                        {"push_robot", robot_push},
                        {"drop", drop},
                        {"stop", stop},
                        {"measure", measure}});
  // In the registry, out of the program's reach: `world` is an argument and no global.
  lua_setfield(state, LUA_REGISTRYINDEX, "stig.world");
  const LuaBox& box = LuaBox::of(state);
  const std::string chunk = LuaBox::of(state).chunk_name(box.program().path);
  if (!load_text(state, without_head(box.program().text), chunk.c_str())) lua_error(state);
  lua_call(state, 0, 0);
  static_cast<ScriptJob*>(lua_touserdata(state, 1))->loaded = true;
  need_one_of(state, {"on_start", "on_step", "on_end"});
  return 0;
}

int call_function(lua_State* state) {
  // A script need not have all three.
  if (!push_callback(state, static_cast<ScriptJob*>(lua_touserdata(state, 1))->function)) return 0;
  lua_getfield(state, LUA_REGISTRYINDEX, "stig.world");
  lua_call(state, 1, 0);
  return 0;
}

}  // namespace

struct LuaScript::State {
  ScriptSide side;
  LuaBox box;
  ControllerStatus status;
  bool begun = false;

  State(LuaProgram program, LuaSettings settings)
      : box(std::move(program), std::move(settings), static_cast<LuaSide*>(&side)) {}
};

LuaScript::LuaScript(LuaProgram program, LuaSettings settings)
    : state_(std::make_unique<State>(std::move(program), std::move(settings))) {}
LuaScript::~LuaScript() = default;
LuaScript::LuaScript(LuaScript&&) noexcept = default;
LuaScript& LuaScript::operator=(LuaScript&&) noexcept = default;

// For checks before a run: what the text logs while it is loaded is thrown away.
LuaScript::Loaded LuaScript::load() {
  assert(state_ != nullptr && !state_->begun);
  std::vector<std::string> log;
  State& own = *state_;
  own.side.log = &log;
  ScriptJob job;
  own.status = own.box.run(open_and_run, &job);
  own.begun = true;
  own.side.log = nullptr;
  return own.status.ok ? Loaded::good : job.loaded ? Loaded::without_callback : Loaded::failed;
}
const LuaFailure& LuaScript::failure() const { return state_->box.last_failure(); }

ControllerStatus LuaScript::call(ScriptCall which, ScriptWorld& world,
                                 std::vector<std::string>& log) {
  assert(state_ != nullptr);
  static constexpr const char* kNames[] = {"on_start", "on_step", "on_end"};
  State& own = *state_;
  // Sticky, as for controllers.
  if (!own.status.ok) return own.status;
  own.side.world = &world;
  own.side.log = &log;
  own.side.logged = 0;
  ScriptJob job{kNames[static_cast<std::size_t>(which)]};
  // The first call of a run loads the text, with the world at hand: its top level may already ask.
  if (!own.begun) own.status = own.box.run(open_and_run, &job);
  own.begun = true;
  if (own.status.ok) own.status = own.box.run(call_function, &job);
  own.side.world = nullptr;
  own.side.log = nullptr;
  return own.status;
}

}  // namespace stig::lua
