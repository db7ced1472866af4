// SPDX-License-Identifier: MIT
// Arguments of the functions that programs call. Lua's own luaL_check… functions turn texts into
// numbers, let NaN and infinities pass, and name arguments by their place alone; what comes in here
// ends up in physics and in traces, so it is held to more, and a program's author is told the
// function, the argument and what was given.
#include <cassert>
#include <cmath>
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

void set_functions(lua_State* state, const LuaEntry* entries, std::size_t count) {
  assert(lua_istable(state, -1));
  for (std::size_t i = 0; i < count; ++i) {
    lua_pushcfunction(state, entries[i].function);
    lua_setfield(state, -2, entries[i].name);
  }
}

void raise_if_stopped(lua_State* state) {
  // Whoever catches the stop of a box is given the same error again, so that it passes through any
  // number of pcalls and ends the call from outside.
  if (LuaBox::of(state).stopped()) lua_error(state);
}

const char* push_shown(lua_State* state, int index) {
  // Messages go into logs and reports, where a long text would bury what they say.
  constexpr std::size_t kMostShown = 40;
  if (lua_isnone(state, index)) return lua_pushliteral(state, "missing");
  lua_pushvalue(state, index);
  // Numbers are copied above before lua_tostring, which changes the value in place.
  if (lua_type(state, -1) == LUA_TNUMBER) return lua_tostring(state, -1);
  if (lua_type(state, -1) != LUA_TSTRING) return luaL_typename(state, -1);
  std::size_t size = 0;
  const char* text = lua_tolstring(state, -1, &size);
  const bool whole = size <= kMostShown;
  lua_pushlstring(state, text, whole ? size : kMostShown);
  return lua_pushfstring(state, whole ? "'%s'" : "'%s…'", lua_tostring(state, -1));
}

void bad_argument(lua_State* state, int index, const char* function, const char* name,
                  const char* expected) {
  luaL_error(state, "%s: argument %d (%s) must be %s, and is %s", function, index, name, expected,
             push_shown(state, index));
  std::abort();  // luaL_error does not return, but does not say so
}

double number_argument(lua_State* state, int index, const char* function, const char* name) {
  // A text is no number here, though Lua would take one.
  const double number = lua_type(state, index) == LUA_TNUMBER ? lua_tonumber(state, index) : NAN;
  if (!std::isfinite(number)) bad_argument(state, index, function, name, "a finite number");
  return number;
}

std::int64_t integer_argument(lua_State* state, int index, const char* function, const char* name,
                              std::int64_t low, std::int64_t high) {
  int exact = 0;
  // lua_tointegerx takes 3.0 for 3, as Lua's own library does; 3.5 is not exact.
  const lua_Integer number =
      lua_type(state, index) == LUA_TNUMBER ? lua_tointegerx(state, index, &exact) : 0;
  if (exact == 0 || number < low || number > high) {
    const char* expected =
        lua_pushfstring(state, "a whole number from %I to %I", static_cast<LUAI_UACINT>(low),
                        static_cast<LUAI_UACINT>(high));
    bad_argument(state, index, function, name, expected);
  }
  return number;
}

bool bool_argument(lua_State* state, int index, const char* function, const char* name) {
  // Everything is true or false in Lua: a number here is a mistake.
  if (!lua_isboolean(state, index)) bad_argument(state, index, function, name, "true or false");
  return lua_toboolean(state, index) != 0;
}

std::string_view text_argument(lua_State* state, int index, const char* function,
                               const char* name) {
  if (lua_type(state, index) != LUA_TSTRING) bad_argument(state, index, function, name, "a text");
  std::size_t size = 0;
  const char* text = lua_tolstring(state, index, &size);
  return {text, size};
}

}  // namespace stig::lua
