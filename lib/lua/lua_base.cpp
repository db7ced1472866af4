// SPDX-License-Identifier: MIT
// The basic library: Lua's own where it is harmless, and ours where Lua's would catch the stop
// of a box, load binary chunks, or show when garbage is collected.
#include <string>

#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

/// What comes back from a protected call, with true or false in front; `skip` values lie below.
int finish_call(lua_State* state, int status, lua_KContext skip) {
  // A call that yielded in between comes here as LUA_YIELD: it is as good as one that returned.
  if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(state) - static_cast<int>(skip);
  // A stop looks like any other error to lua_pcallk; it must not end in the program's hands.
  raise_if_stopped(state);
  lua_pushboolean(state, 0);
  lua_insert(state, -2);
  return 2;
}

int protected_call(lua_State* state) {
  luaL_checkany(state, 1);
  // The result `true` is laid under the function beforehand, as lua_pcallk leaves what is below its
  // function alone.
  lua_pushboolean(state, 1);
  lua_insert(state, 1);
  const int status = lua_pcallk(state, lua_gettop(state) - 2, LUA_MULTRET, 0, 0, finish_call);
  return finish_call(state, status, 0);
}

int protected_call_with_handler(lua_State* state) {
  const int count = lua_gettop(state);
  luaL_checktype(state, 2, LUA_TFUNCTION);
  // As in Lua's own xpcall: two values, the function and its handler, lie below what is returned.
  lua_pushboolean(state, 1);
  lua_pushvalue(state, 1);
  lua_rotate(state, 3, 2);  // function, handler, true, function, arguments
  const int status = lua_pcallk(state, count - 2, LUA_MULTRET, 2, 2, finish_call);
  return finish_call(state, status, 2);
}

/// load(text [, name [, mode [, environment]]]): texts only, the mode changes nothing.
int load(lua_State* state) {
  const std::string_view text = text_argument(state, 1, "load", "chunk");
  const char* name = luaL_optstring(state, 2, "=(load)");
  // nil is an environment too, one in which nothing is found, so "none" is what counts.
  const bool has_environment = !lua_isnone(state, 4);
  if (!load_text(state, text, name)) {
    // An error in the text is a result here, but a stop while it was being loaded is not.
    raise_if_stopped(state);
    lua_pushnil(state);
    lua_insert(state, -2);
    return 2;
  }
  if (has_environment) {
    // The first upvalue of a chunk is _ENV; a chunk that uses no global has none.
    lua_pushvalue(state, 4);
    if (lua_setupvalue(state, -2, 1) == nullptr) lua_pop(state, 1);
  }
  return 1;
}

/// Finalizers are refused: they would tell when garbage is collected.
int set_metatable(lua_State* state) {
  // The checks are those of Lua's own setmetatable, in the same order, with __gc refused after
  // them.
  luaL_checktype(state, 1, LUA_TTABLE);
  if (!lua_isnil(state, 2)) luaL_checktype(state, 2, LUA_TTABLE);
  lua_settop(state, 2);
  if (luaL_getmetafield(state, 1, "__metatable") != LUA_TNIL) {
    return luaL_error(state, "setmetatable: the metatable is protected");
  }
  if (lua_istable(state, 2)) {
    lua_pushliteral(state, "__gc");
    if (lua_rawget(state, 2) != LUA_TNIL) {
      return luaL_error(state, "setmetatable: there are no finalizers (__gc) here");
    }
    lua_settop(state, 2);
  }
  lua_setmetatable(state, 1);
  return 1;
}

/// collectgarbage('count'): KiB of objects made since the last collection. Everything else is
/// accepted and does nothing.
int collect_garbage(lua_State* state) {
  const std::string_view option = luaL_optstring(state, 1, "collect");
  if (option != "count") {
    lua_pushinteger(state, 0);
  } else {
    lua_pushnumber(state, static_cast<double>(LuaBox::of(state).made()) / 1024);
  }
  return 1;
}

// tonumber of Lua reads its text to the end, which may be as long as the longest text: charged. The
// upvalue is Lua's function.
int number_of(lua_State* state) {
  LuaBox::of(state).charge(state, lua_rawlen(state, 1) / 8);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, 1);
  return 1;
}

}  // namespace

std::string_view without_head(std::string_view file) {
  // What editors and shells put in front of a file. The first line is emptied and not removed, so
  // that the lines of messages are those of the file.
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (file.starts_with(kMark)) file.remove_prefix(kMark.size());
  if (file.starts_with('#')) file.remove_prefix(std::min(file.find('\n'), file.size()));
  return file;
}

bool load_text(lua_State* state, std::string_view text, const char* chunk_name) {
  // Parsing takes time in proportion to the text, and "t" refuses binary chunks: those are not
  // verified when loaded, and can crash the interpreter.
  LuaBox::of(state).charge(state, text.size());
  return luaL_loadbufferx(state, text.data(), text.size(), chunk_name, "t") == LUA_OK;
}

void open_base(lua_State* state) {
  // Taken out: functions that reach files, and warn, which writes to standard error.
  luaL_requiref(state, LUA_GNAME, luaopen_base, 1);
  for (const char* name : {"dofile", "loadfile", "warn"}) {
    lua_pushnil(state);
    lua_setfield(state, -2, name);
  }
  lua_getfield(state, -1, "tonumber");
  lua_pushcclosure(state, number_of, 1);
  lua_setfield(state, -2, "tonumber");
  set_functions(state, {{"pcall", protected_call},
                        {"xpcall", protected_call_with_handler},
                        {"load", load},
                        {"setmetatable", set_metatable},
                        {"collectgarbage", collect_garbage}});
  lua_pop(state, 1);
}

}  // namespace stig::lua
