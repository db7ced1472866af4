// SPDX-License-Identifier: MIT
#include "lua/lua_userdata.h"

#include <cstring>
#include <lua.hpp>

namespace stig::lua::userdata {

void push_copy(lua_State* state, const void* value, std::size_t size, const void* key) {
  std::memcpy(lua_newuserdatauv(state, size, 0), value, size);
  lua_rawgetp(state, LUA_REGISTRYINDEX, key);
  lua_setmetatable(state, -2);
}

void* userdata_at(lua_State* state, int index, const void* key) {
  void* value = lua_touserdata(state, index);
  if (value == nullptr || lua_getmetatable(state, index) == 0) return nullptr;
  lua_rawgetp(state, LUA_REGISTRYINDEX, key);
  const bool is_one = lua_rawequal(state, -1, -2) != 0;
  lua_pop(state, 2);
  return is_one ? value : nullptr;
}

void not_userdata(lua_State* state, int index, const char* name) {
  luaL_checkudata(state, index, name);
}

char letter_at(lua_State* state, int index) {
  if (lua_type(state, index) != LUA_TSTRING || lua_rawlen(state, index) != 1) return 0;
  return *lua_tostring(state, index);
}

}  // namespace stig::lua::userdata
