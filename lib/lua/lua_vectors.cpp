// SPDX-License-Identifier: MIT
// vector2, vector3 and quaternion, with the names of ARGoS.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"
#include "lua/lua_userdata.h"

namespace stig::lua {

using namespace userdata;

namespace {

// ---- What all three have ----

template <class T>
int get(lua_State* state) {
  const std::size_t i = field<T>(state, 2);
  if (i != std::string_view::npos) {
    lua_pushnumber(state, numbers_of(check<T>(state, 1))[i]);
    return 1;
  }
  lua_pushvalue(state, 2);
  lua_rawget(state, lua_upvalueindex(1));
  return 1;
}

template <class T>
int set(lua_State* state) {
  T& value = check<T>(state, 1);
  const std::size_t i = field<T>(state, 2);
  if (i == std::string_view::npos)
    return luaL_error(state, "%s: there is no such field to set", Meta<T>::kName);
  Numbers<T> numbers = numbers_of(value);
  numbers[i] = number_argument(state, 3, Meta<T>::kName, "value");
  value = value_of<T>(numbers);
  return 0;
}

template <class T>
int to_text(lua_State* state) {
  const Numbers<T> numbers = numbers_of(check<T>(state, 1));
  luaL_Buffer buffer;
  luaL_buffinit(state, &buffer);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) luaL_addchar(&buffer, ',');
    lua_pushnumber(state, numbers[i] == 0 ? 0.0 : numbers[i]);  // no -0
    lua_tostring(state, -1);
    luaL_addvalue(&buffer);
  }
  luaL_pushresult(&buffer);
  return 1;
}

int join(lua_State* state) {
  push_text(state, 1);
  push_text(state, 2);
  lua_concat(state, 2);
  return 1;
}

template <class T>
int equal(lua_State* state) {
  const T *a = test<T>(state, 1), *b = test<T>(state, 2);
  lua_pushboolean(state, a != nullptr && b != nullptr && numbers_of(*a) == numbers_of(*b) ? 1 : 0);
  return 1;
}

/// T(), T(another), T(numbers).
template <class T>
int make(lua_State* state) {
  const int count = lua_gettop(state);
  if (count == 0) return push(state, T{});
  if (const T* other = count == 1 ? test<T>(state, 1) : nullptr) return push(state, *other);
  if (count != static_cast<int>(kSize<T>)) {
    return luaL_error(state, "%s: %d numbers are needed", Meta<T>::kName,
                      static_cast<int>(kSize<T>));
  }
  Numbers<T> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const char name[2] = {Meta<T>::kFields[i], '\0'};
    numbers[i] = number_argument(state, static_cast<int>(i) + 1, Meta<T>::kName, name);
  }
  return push(state, value_of<T>(numbers));
}

template <class T>
double length_of(const T& value) {
  double sum = 0;
  for (const double x : numbers_of(value)) sum += x * x;
  return std::sqrt(sum);
}

/// In place, as ARGoS does; a vector of no length stays.
template <class T>
int normalise(lua_State* state) {
  T& value = check<T>(state, 1);
  const double size = length_of(value);
  Numbers<T> numbers = numbers_of(value);
  if (size > 0) {
    for (double& x : numbers) x /= size;
  }
  value = value_of<T>(numbers);
  lua_settop(state, 1);
  return 1;
}

// ---- Vectors ----

template <class T, class Operation>
int by_parts(lua_State* state, const Operation& operation) {
  Numbers<T> a = numbers_of(check<T>(state, 1));
  const Numbers<T> b = numbers_of(check<T>(state, 2));
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = operation(a[i], b[i]);
  return push(state, value_of<T>(a));
}
template <class T>
int add(lua_State* state) {
  return by_parts<T>(state, [](double a, double b) { return a + b; });
}
template <class T>
int subtract(lua_State* state) {
  return by_parts<T>(state, [](double a, double b) { return a - b; });
}

template <class T>
int scaled_by(lua_State* state, int vector, double factor) {
  Numbers<T> numbers = numbers_of(check<T>(state, vector));
  for (double& x : numbers) x *= factor;
  return push(state, value_of<T>(numbers));
}
template <class T>
int multiply(lua_State* state) {
  const int vector = lua_type(state, 1) == LUA_TNUMBER ? 2 : 1;
  check<T>(state, vector);
  return scaled_by<T>(state, vector, number_argument(state, 3 - vector, Meta<T>::kName, "factor"));
}
template <class T>
int divide(lua_State* state) {
  Numbers<T> numbers = numbers_of(check<T>(state, 1));
  const double divisor = number_argument(state, 2, Meta<T>::kName, "divisor");
  for (double& x : numbers) x /= divisor;
  return push(state, value_of<T>(numbers));
}
template <class T>
int negate(lua_State* state) {
  return scaled_by<T>(state, 1, -1);
}
template <class T>
int length_method(lua_State* state) {
  lua_pushnumber(state, length_of(check<T>(state, 1)));
  return 1;
}
template <class T>
double dot_of(const T& a, const T& b) {
  const Numbers<T> x = numbers_of(a), y = numbers_of(b);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}
template <class T>
int dot_method(lua_State* state) {
  lua_pushnumber(state, dot_of(check<T>(state, 1), check<T>(state, 2)));
  return 1;
}

/// Changes the first, as in ARGoS.
int cross_method(lua_State* state) {
  Vec3& v = check<Vec3>(state, 1);
  v = cross(v, check<Vec3>(state, 2));
  lua_settop(state, 1);
  return 1;
}
/// The angle of the vector from the x axis, or to another vector, counter-clockwise.
int angle2(lua_State* state) {
  const Vec2 a = check<Vec2>(state, 1);
  const Vec2 b = lua_isnone(state, 2) ? a : check<Vec2>(state, 2);
  const Vec2 from = lua_isnone(state, 2) ? Vec2{1, 0} : a;
  lua_pushnumber(state, std::atan2(from.x * b.y - from.y * b.x, from.x * b.x + from.y * b.y));
  return 1;
}
int angle3(lua_State* state) {
  const Vec3 a = check<Vec3>(state, 1), b = check<Vec3>(state, 2);
  lua_pushnumber(state, std::atan2(length(cross(a, b)), dot(a, b)));
  return 1;
}
int rotate2(lua_State* state) {
  Vec2& v = check<Vec2>(state, 1);
  const double angle = number_argument(state, 2, "vector2:rotate", "angle");
  const double c = std::cos(angle), s = std::sin(angle);
  v = {v.x * c - v.y * s, v.x * s + v.y * c};
  lua_settop(state, 1);
  return 1;
}
int rotate3(lua_State* state) {
  Vec3& v = check<Vec3>(state, 1);
  v = rotate(check<Quat>(state, 2), v);
  lua_settop(state, 1);
  return 1;
}

// ---- Quaternions ----

/// quaternion(), (another), (w, x, y, z), (angle, axis), (from, to).
int make_quaternion(lua_State* state) {
  if (lua_gettop(state) != 2) return make<Quat>(state);
  const Vec3 second = vector_argument(state, 2, "quaternion", "axis");
  const bool between = lua_type(state, 1) != LUA_TNUMBER;
  const Vec3 first = between ? vector_argument(state, 1, "quaternion", "from") : Vec3{};
  if (!(length(second) > 0) || (between && !(length(first) > 0))) {
    return luaL_error(state, "quaternion: a vector without length has no direction");
  }
  if (between) return push(state, turn_between(first, second));
  const double angle = number_argument(state, 1, "quaternion", "angle");
  const Vec3 axis = normalised(second) * std::sin(angle / 2);
  return push(state, Quat{std::cos(angle / 2), axis.x, axis.y, axis.z});
}

int multiply_quaternions(lua_State* state) {
  const Quat a = check<Quat>(state, 1);
  return push(state, a * check<Quat>(state, 2));
}
int inverse_method(lua_State* state) { return push(state, conjugate(check<Quat>(state, 1))); }

int to_angle_axis(lua_State* state) {
  const Quat q = check<Quat>(state, 1);
  const Vec3 v{q.x, q.y, q.z};
  const double sine = length(v);
  lua_pushnumber(state, 2 * std::atan2(sine, q.w));
  push(state, sine > 0 ? v * (1 / sine) : Vec3{0, 0, 1});
  return 2;
}

/// Turns about z, then the new y, then the new x.
int to_euler_angles(lua_State* state) {
  const Mat3 m = matrix(check<Quat>(state, 1));
  lua_pushnumber(state, std::atan2(m.x.y, m.x.x));
  lua_pushnumber(state, std::asin(std::clamp(-m.x.z, -1.0, 1.0)));
  lua_pushnumber(state, std::atan2(m.y.z, m.z.z));
  return 3;
}

// ---- Registration ----

template <class T, std::size_t n, std::size_t m>
void open_type(lua_State* state, LuaFunction constructor, const LuaEntry (&methods)[n],
               const LuaEntry (&operators)[m]) {
  luaL_newmetatable(state, Meta<T>::kName);
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &kKey<T>);
  lua_createtable(state, 0, static_cast<int>(n) + 2);
  set_functions(state, methods);
  // In ARGoS the metatable is its own __index, so programs call v:__tostring().
  set_functions(state, {{"normalize", normalise<T>}, {"__tostring", to_text<T>}});
  lua_pushcclosure(state, get<T>, 1);
  lua_setfield(state, -2, "__index");
  set_functions(
      state,
      {{"__newindex", set<T>}, {"__tostring", to_text<T>}, {"__eq", equal<T>}, {"__concat", join}});
  set_functions(state, operators);
  lua_pushstring(state, Meta<T>::kName);
  lua_setfield(state, -2, "__metatable");
  lua_pop(state, 1);
  lua_pushcfunction(state, constructor);
  lua_setglobal(state, Meta<T>::kName);
}

template <class T>
constexpr LuaEntry kArithmetic[] = {{"__add", add<T>},
                                    {"__sub", subtract<T>},
                                    {"__mul", multiply<T>},
                                    {"__div", divide<T>},
                                    {"__unm", negate<T>}};

}  // namespace

Quat turn_between(const Vec3& from, const Vec3& to) {
  assert(length(from) > 0 && length(to) > 0);
  const Vec3 a = normalised(from), b = normalised(to);
  const double c = dot(a, b);
  if (c < -1 + 1e-12) {
    const Vec3 axis = perpendicular(a);
    return {0, axis.x, axis.y, axis.z};
  }
  const Vec3 axis = cross(a, b);
  return normalised(Quat{1 + c, axis.x, axis.y, axis.z});
}

void push_vector(lua_State* state, const Vec3& v) { push(state, v); }
void push_vector(lua_State* state, const ImagePoint& v) { push(state, Vec2{v.x, v.y}); }
void push_quaternion(lua_State* state, const Quat& q) { push(state, q); }

Vec3 vector_argument(lua_State* state, int index, const char* function, const char* name) {
  const Vec3* v = test<Vec3>(state, index);
  if (v == nullptr || !is_finite(*v)) {
    bad_argument(state, index, function, name, "a finite vector3");
  }
  return *v;
}

Quat quaternion_argument(lua_State* state, int index, const char* function, const char* name) {
  const Quat* q = test<Quat>(state, index);
  const double squares = q == nullptr ? 0 : q->w * q->w + q->x * q->x + q->y * q->y + q->z * q->z;
  // Written so that NaN fails.
  if (!(squares > 1e-12 && squares < 1e12)) {
    bad_argument(state, index, function, name, "a quaternion that turns");
  }
  return normalised(*q);
}

void open_vectors(lua_State* state) {
  open_type<Vec2>(state, make<Vec2>,
                  {{"length", length_method<Vec2>},
                   {"dot", dot_method<Vec2>},
                   {"angle", angle2},
                   {"rotate", rotate2}},
                  kArithmetic<Vec2>);
  open_type<Vec3>(state, make<Vec3>,
                  {{"length", length_method<Vec3>},
                   {"dot", dot_method<Vec3>},
                   {"cross", cross_method},
                   {"angle", angle3},
                   {"rotate", rotate3}},
                  kArithmetic<Vec3>);
  open_type<Quat>(state, make_quaternion,
                  {{"inverse", inverse_method},
                   {"toangleaxis", to_angle_axis},
                   {"toeulerangles", to_euler_angles}},
                  {{"__mul", multiply_quaternions}});
}

}  // namespace stig::lua
