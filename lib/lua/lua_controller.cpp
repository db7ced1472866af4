// SPDX-License-Identifier: MIT
// What robots and blocks have in common is a Host: a box, the side that C functions act on, and a
// status that stays as it is after the first failure. Calls into Lua get their data by a pointer to
// a struct on the C++ stack (Call), and C functions find the side by LuaBox::user, so nothing that
// a program can reach holds a pointer into the simulation.
#include "lua/lua_controller.h"

#include <algorithm>
#include <cassert>
#include <lua.hpp>
#include <utility>

#include "lua/lua_box.h"
#include "lua/lua_callbacks.h"
#include "lua/lua_interface.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

void run_program(lua_State* state) {
  LuaBox& box = LuaBox::of(state);
  const std::string chunk = box.chunk_name(box.program().path);
  if (!load_text(state, without_head(box.program().text), chunk.c_str())) lua_error(state);
  lua_call(state, 0, 0);
}

/// What one call hands to the state.
template <class Side, class Readings>
struct Call {
  Side* side;
  const Readings* readings;
};

template <class Call>
Call& call_of(lua_State* state) {
  return *static_cast<Call*>(lua_touserdata(state, 1));
}

using RobotCall = Call<RobotSide, RobotReadings>;
using BlockCall = Call<BlockSide, BlockReadings>;

// Devices first, so that the program's own top level finds `robot`; then the program; then its
// init, if it has one.
int init_robot(lua_State* state) {
  open_robot(state, *call_of<RobotCall>(state).side);
  run_program(state);
  call_back(state, "init");
  return 0;
}
int init_block(lua_State* state) {
  open_block(state, *call_of<BlockCall>(state).side);
  run_program(state);
  call_back(state, "init");
  return 0;
}
template <class Call>
int step_any(lua_State* state) {
  // Readings are written into the tables, then the program is called: a step never sees half of
  // them.
  const Call& call = call_of<Call>(state);
  put_readings(state, *call.side, *call.readings);
  call_needed(state, "step");
  return 0;
}
// Asked by tools before a long run; a run itself finds out at the first step.
int need_step(lua_State* state) {
  need_one_of(state, {"step"});
  return 0;
}
int reset_robot(lua_State* state) {
  call_back(state, "reset");
  return 0;
}
int destroy_robot(lua_State* state) {
  call_back(state, "destroy");
  return 0;
}

// The traceback is split into lines, since a log is a list of lines.
void log_failure(const LuaBox& box, const std::string& error, std::vector<std::string>& log) {
  log.push_back("error: " + error);
  const std::string& trace = box.traceback();
  for (std::size_t begin = 0; begin < trace.size();) {
    const std::size_t end = std::min(trace.find('\n', begin), trace.size());
    log.push_back(trace.substr(begin, end - begin));
    begin = end + 1;
  }
}

/// A box, the side that its program acts on, and how it has fared. In a template and not a base
/// class with virtual functions: the two sides share no types but their names.
template <class Side, class Readings, class Commands>
struct Host {
  Side side;
  LuaBox box;
  ControllerStatus status;
  bool begun = false;

  Host(LuaProgram program, LuaSettings settings)
      : box(std::move(program), std::move(settings), static_cast<LuaSide*>(&side)) {}

  ControllerStatus run(LuaBox::Body body, const Readings* readings, Commands& commands) {
    // Sticky: a program that has failed once is in a state that its author did not foresee.
    if (!status.ok) return status;
    side.commands = &commands;
    side.log = &commands.log;
    // The limit on what is logged is for each call.
    side.logged = 0;
    Call<Side, Readings> call{&side, readings};
    status = box.run(body, &call);
    if (!status.ok) log_failure(box, status.error, commands.log);
    // Commands and log belong to the caller and end with the call; a C function that is called
    // later, by whatever way, finds null instead of a stale pointer.
    side.commands = nullptr;
    side.log = nullptr;
    return status;
  }
};

}  // namespace

struct LuaController::State : Host<RobotSide, RobotReadings, RobotCommands> {
  using Host::Host;
  bool stepped = false;
};
struct LuaBlockController::State : Host<BlockSide, BlockReadings, BlockCommands> {
  using Host::Host;
};

LuaController::LuaController(LuaProgram program, RobotModel model, LuaSettings settings)
    : state_(std::make_unique<State>(std::move(program), std::move(settings))) {
  state_->side.model = std::move(model);
}
LuaController::~LuaController() = default;

ControllerStatus LuaController::init(RobotCommands& commands) {
  state_->begun = true;
  return state_->run(init_robot, nullptr, commands);
}
ControllerStatus LuaController::step(const RobotReadings& readings, RobotCommands& commands) {
  assert(state_->begun);
  // ARGoS of 2019 senses between init and the first step, so that programs count on what a camera
  // sees that init has switched on. Here that takes a tick.
  const bool first = !std::exchange(state_->stepped, true);
  if (first && state_->box.program().interface == InterfaceLevel::of_2019) return state_->status;
  // detect_led looks at the camera's LEDs of this step, which are handed to Lua only through it.
  state_->side.readings = &readings;
  auto status = state_->run(step_any<RobotCall>, &readings, commands);
  state_->side.readings = nullptr;
  return status;
}
ControllerStatus LuaController::reset(RobotCommands& commands) {
  assert(state_->begun);
  return state_->run(reset_robot, nullptr, commands);
}
void LuaController::destroy() {
  // The commands are dropped: the robot is about to be taken away.
  RobotCommands commands;
  if (state_->begun) state_->run(destroy_robot, nullptr, commands);
}
ControllerStatus LuaController::ready() {
  assert(state_->begun);
  RobotCommands commands;
  return state_->run(need_step, nullptr, commands);
}
const LuaFailure& LuaController::failure() const { return state_->box.last_failure(); }
std::size_t LuaController::memory() const { return state_->box.memory(); }

LuaBlockController::LuaBlockController(LuaProgram program, LuaSettings settings)
    : state_(std::make_unique<State>(std::move(program), std::move(settings))) {}
LuaBlockController::~LuaBlockController() = default;

ControllerStatus LuaBlockController::init(BlockCommands& commands) {
  state_->begun = true;
  return state_->run(init_block, nullptr, commands);
}
ControllerStatus LuaBlockController::step(const BlockReadings& readings, BlockCommands& commands) {
  assert(state_->begun);
  return state_->run(step_any<BlockCall>, &readings, commands);
}
ControllerStatus LuaBlockController::ready() {
  assert(state_->begun);
  BlockCommands commands;
  return state_->run(need_step, nullptr, commands);
}
const LuaFailure& LuaBlockController::failure() const { return state_->box.last_failure(); }
std::size_t LuaBlockController::memory() const { return state_->box.memory(); }

}  // namespace stig::lua
