// SPDX-License-Identifier: MIT
// Coroutines: Lua's own but for what resumes them. A coroutine counts its instructions by itself
// and from the start of an interval, so resuming one costs an interval; and a resumer must not
// swallow the stop of the box.
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

/// Moves the arguments, which are all above the thread's place, into it; results or the error
/// come back on top. The number of results, or -1.
int resume_with(lua_State* state, lua_State* thread, int count) {
  // The count hook is inherited by a new thread but its counter starts from zero, so a program
  // could run for ever in coroutines shorter than an interval: each resume pays for a whole one.
  LuaBox::of(state).charge(state, LuaBox::kHookInterval);
  if (lua_checkstack(thread, count) == 0) {
    return luaL_error(state, "coroutine: too many arguments to resume");
  }
  lua_xmove(state, thread, count);
  int results = 0;
  const int status = lua_resume(thread, state, count, &results);
  if (status == LUA_OK || status == LUA_YIELD) {
    // lua_xmove does not grow the stack: the room has to be there beforehand.
    if (lua_checkstack(state, results + 1) == 0) {
      return luaL_error(state, "coroutine: too many results to resume");
    }
    lua_xmove(thread, state, results);
    return results;
  }
  // A thread that failed keeps its error on its own stack.
  lua_xmove(thread, state, 1);
  raise_if_stopped(state);
  return -1;
}

int resume(lua_State* state) {
  // Like Lua's: true and results, or false and the error.
  luaL_checktype(state, 1, LUA_TTHREAD);
  const int results = resume_with(state, lua_tothread(state, 1), lua_gettop(state) - 1);
  lua_pushboolean(state, results >= 0 ? 1 : 0);
  const int count = results >= 0 ? results : 1;
  lua_insert(state, -(count + 1));
  return count + 1;
}

int create(lua_State* state) {
  luaL_checktype(state, 1, LUA_TFUNCTION);
  lua_State* thread = lua_newthread(state);
  lua_pushvalue(state, 1);
  lua_xmove(state, thread, 1);
  return 1;
}

/// Runs what a thread still has to close; false, with the error on top of `state`.
bool close_thread(lua_State* state, lua_State* thread) {
  LuaBox::of(state).charge(state, LuaBox::kHookInterval);
  if (lua_resetthread(thread) == LUA_OK) return true;
  lua_xmove(thread, state, 1);
  raise_if_stopped(state);
  return false;
}

// As luaB_auxwrap of Lua 5.4: an error closes the thread's pending variables before it goes on.
int resume_wrapped(lua_State* state) {
  lua_State* thread = lua_tothread(state, lua_upvalueindex(1));
  const int results = resume_with(state, thread, lua_gettop(state));
  if (results >= 0) return results;
  const int status = lua_status(thread);
  if (status != LUA_OK && status != LUA_YIELD) {
    lua_pushvalue(state, -1);  // the thread's variables to be closed are told of the error
    lua_xmove(state, thread, 1);
    close_thread(state, thread);
  }
  return lua_error(state);
}

int wrap(lua_State* state) {
  create(state);
  lua_pushcclosure(state, resume_wrapped, 1);
  return 1;
}

int close(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTHREAD);
  lua_State* thread = lua_tothread(state, 1);
  lua_Debug frame;
  const int status = lua_status(thread);
  // A thread that runs, or that waits for one which it has resumed (LUA_OK with a frame), cannot be
  // closed.
  const bool runs = thread == state || (status == LUA_OK && lua_getstack(thread, 0, &frame) != 0);
  if (runs) return luaL_error(state, "coroutine.close: the coroutine is running");
  const bool closed = close_thread(state, thread);
  lua_pushboolean(state, closed ? 1 : 0);
  if (closed) return 1;
  lua_insert(state, -2);
  return 2;
}

}  // namespace

void open_coroutines(lua_State* state) {
  luaL_requiref(state, LUA_COLIBNAME, luaopen_coroutine, 1);
  // Lua's own resume, wrap and close would run threads without a charge.
  set_functions(state, {{"resume", resume}, {"create", create}, {"wrap", wrap}, {"close", close}});
  lua_pop(state, 1);
}

}  // namespace stig::lua
