// SPDX-License-Identifier: MIT
// What of Lua's libraries debug and io does no harm, for programs that expect them: where a
// function stands, and files of which there are none. Nothing that reads or sets other functions'
// variables or the registry, which would lead out of the sandbox; and no function is handed out,
// since those on the stack may not be the program's own.
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

constexpr const char* kFields = "Slnut";  ///< of lua_getinfo: source, line, name, parameters, tail

void put_text(lua_State* state, const char* key, const char* text) {
  if (text == nullptr) return;
  lua_pushstring(state, text);
  lua_setfield(state, -2, key);
}
void put_number(lua_State* state, const char* key, int number) {
  lua_pushinteger(state, number);
  lua_setfield(state, -2, key);
}

/// debug.getinfo(level or function [, what]): what is asked for is given whole.
int get_info(lua_State* state) {
  LuaBox::of(state).charge(state, 100);
  lua_Debug frame{};
  if (lua_isfunction(state, 1)) {
    lua_settop(state, 1);
    lua_getinfo(state, ">Slnut", &frame);
  } else {
    const auto level = integer_argument(state, 1, "debug.getinfo", "level", 0, 1'000'000);
    // No such level: nothing, as in Lua.
    if (lua_getstack(state, static_cast<int>(level), &frame) == 0) return 0;
    lua_getinfo(state, kFields, &frame);
  }
  lua_createtable(state, 0, 10);
  put_text(state, "source", frame.source);
  put_text(state, "short_src", frame.short_src);
  put_text(state, "what", frame.what);
  put_text(state, "name", frame.name);
  put_text(state, "namewhat", frame.namewhat);
  put_number(state, "currentline", frame.currentline);
  put_number(state, "linedefined", frame.linedefined);
  put_number(state, "lastlinedefined", frame.lastlinedefined);
  put_number(state, "nparams", frame.nparams);
  put_number(state, "nups", frame.nups);
  return 1;
}

/// debug.traceback([message [, level]]): a message that is no text comes back as it is.
int trace_back(lua_State* state) {
  if (!lua_isnoneornil(state, 1) && lua_type(state, 1) != LUA_TSTRING) {
    lua_settop(state, 1);
    return 1;
  }
  LuaBox::of(state).charge(state, 1000);
  const char* message = lua_tostring(state, 1);
  const int level =
      lua_isnoneornil(state, 2)
          ? 1
          : static_cast<int>(integer_argument(state, 2, "debug.traceback", "level", 0, 1'000'000));
  luaL_traceback(state, state, message, level);
  return 1;
}

/// debug.sethook(…): a debugger that a program brings is never called.
int set_no_hook(lua_State* /*state*/) { return 0; }

/// io.open(name [, mode]): as where there is no such file and none can be made.
int open_no_file(lua_State* state) {
  lua_pushnil(state);
  lua_pushliteral(state, "programs of robots have no files");
  return 2;
}

/// io.read(…): as at the end of the input.
int read_nothing(lua_State* state) {
  lua_pushnil(state);
  return 1;
}

}  // namespace

void open_debug(lua_State* state) {
  lua_createtable(state, 0, 3);
  set_functions(state,
                {{"getinfo", get_info}, {"traceback", trace_back}, {"sethook", set_no_hook}});
  lua_setglobal(state, "debug");
}

void open_io(lua_State* state) {
  lua_createtable(state, 0, 3);
  set_functions(state, {{"open", open_no_file}, {"read", read_nothing}});
  lua_setglobal(state, "io");
}

}  // namespace stig::lua
