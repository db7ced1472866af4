// SPDX-License-Identifier: MIT
// Vectors and quaternions in Lua's userdata: how they are pushed, told apart and read. They hold
// nothing but numbers and cannot be forged from tables.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string_view>

#include "base/vec.h"
#include "lua/uses.h"

struct lua_State;

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

/// Pushes a copy of `size` bytes as userdata whose metatable is the one of this key.
void push_copy(lua_State* state, const void* value, std::size_t size, const void* key);
/// The bytes of the value at this index, or null where it has not the metatable of this key.
void* userdata_at(lua_State* state, int index, const void* key);
/// A Lua error: the value at this index is no `name`.
void not_userdata(lua_State* state, int index, const char* name);
/// The letter of a string of one, or 0.
char letter_at(lua_State* state, int index);

template <class T>
int push(lua_State* state, const T& value) {
  push_copy(state, &value, sizeof value, &kKey<T>);
  return 1;
}

template <class T>
T* test(lua_State* state, int index) {
  return static_cast<T*>(userdata_at(state, index, &kKey<T>));
}
template <class T>
T& check(lua_State* state, int index) {
  T* value = test<T>(state, index);
  if (value == nullptr) not_userdata(state, index, Meta<T>::kName);
  return *value;
}

/// The place of a field by its one-letter name, or npos.
template <class T>
std::size_t field(lua_State* state, int index) {
  const char letter = letter_at(state, index);
  return letter == 0 ? std::string_view::npos : Meta<T>::kFields.find(letter);
}

}  // namespace stig::lua::userdata
