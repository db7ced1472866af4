// SPDX-License-Identifier: MIT
// Vectors and quaternions in Lua's userdata: how they are pushed, told apart and read. They hold
// nothing but numbers and cannot be forged from tables.
#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <lua.hpp>
#include <string_view>

#include "base/vec.h"
#include "lua/uses.h"

namespace stig::lua::userdata {

struct Vec2 {
  double x = 0, y = 0;
};

template <class T>
struct Meta;
template <>
struct Meta<Vec2> {
  static constexpr const char* kName = "vector2";
  static constexpr std::string_view kFields = "xy";
};
template <>
struct Meta<Vec3> {
  static constexpr const char* kName = "vector3";
  static constexpr std::string_view kFields = "xyz";
};
template <>
struct Meta<Quat> {
  static constexpr const char* kName = "quaternion";
  static constexpr std::string_view kFields = "wxyz";
};

template <class T>
inline constexpr std::size_t kSize = Meta<T>::kFields.size();
template <class T>
using Numbers = std::array<double, kSize<T>>;

template <class T>
Numbers<T> numbers_of(const T& value) {
  return std::bit_cast<Numbers<T>>(value);
}
template <class T>
T value_of(const Numbers<T>& numbers) {
  return std::bit_cast<T>(numbers);
}

/// Where the registry has the metatable, beside its name: programs take numbers from vectors all
/// the time, and to find a name takes longer.
template <class T>
inline constexpr char kKey = 0;

template <class T>
void push_metatable(lua_State* state) {
  lua_rawgetp(state, LUA_REGISTRYINDEX, &kKey<T>);
}

template <class T>
int push(lua_State* state, const T& value) {
  void* place = lua_newuserdatauv(state, sizeof(T), 0);
  std::memcpy(place, &value, sizeof value);
  push_metatable<T>(state);
  lua_setmetatable(state, -2);
  return 1;
}

template <class T>
T* test(lua_State* state, int index) {
  void* value = lua_touserdata(state, index);
  if (value == nullptr || lua_getmetatable(state, index) == 0) return nullptr;
  push_metatable<T>(state);
  const bool is_one = lua_rawequal(state, -1, -2) != 0;
  lua_pop(state, 2);
  return is_one ? static_cast<T*>(value) : nullptr;
}
template <class T>
T& check(lua_State* state, int index) {
  T* value = test<T>(state, index);
  if (value == nullptr) luaL_checkudata(state, index, Meta<T>::kName);  // says what is wrong
  return *value;
}

/// The place of a field by its one-letter name, or npos.
template <class T>
std::size_t field(lua_State* state, int index) {
  if (lua_type(state, index) != LUA_TSTRING || lua_rawlen(state, index) != 1)
    return std::string_view::npos;
  return Meta<T>::kFields.find(*lua_tostring(state, index));
}

}  // namespace stig::lua::userdata
