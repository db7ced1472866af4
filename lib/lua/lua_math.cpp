// SPDX-License-Identifier: MIT
// The math library: Lua's own but for random numbers, which are a function of the seed, the
// robot and the number of the call.
#include <bit>
#include <lua.hpp>

#include "base/hash.h"
#include "lua/lua_box.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

// Two words of 32 bits, in an order that is written down.
std::uint64_t word(Random& random) {
  const std::uint64_t high = random.next();
  return high << 32 | random.next();
}

/// random() in [0, 1); random(0) any whole number; random(m) in 1…m; random(m, n) in m…n. As Lua's
/// math.random has it, the interval's bounds included.
int random_number(lua_State* state) {
  Random& random = LuaBox::of(state).random();
  const int count = lua_gettop(state);
  if (count == 0) {
    lua_pushnumber(state, random.unit());
    return 1;
  }
  const lua_Integer first = luaL_checkinteger(state, 1);
  const lua_Integer low = count == 1 ? 1 : first;
  const lua_Integer high = count == 1 ? first : luaL_checkinteger(state, 2);
  if (count == 1 && first == 0) {
    lua_pushinteger(state, std::bit_cast<lua_Integer>(word(random)));
    return 1;
  }
  if (low > high) return luaL_error(state, "math.random: the interval is empty");
  // Unsigned, since high - low of the whole range overflows a signed integer; then a bound of 0
  // stands for 2^64.
  const std::uint64_t bound =
      static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
  // below() is without bias: no remainder of a division.
  const std::uint64_t drawn = bound == 0 ? word(random) : random.below(bound);
  lua_pushinteger(state, std::bit_cast<lua_Integer>(static_cast<std::uint64_t>(low) + drawn));
  return 1;
}

/// Keys the numbers by the run's seed and the argument; without one, by the run's seed alone.
int seed_random(lua_State* state) {
  LuaBox& box = LuaBox::of(state);
  const std::uint64_t seed = box.settings().seed;
  if (lua_isnoneornil(state, 1)) {
    box.reseed(seed);
    return 0;
  }
  const double number = number_argument(state, 1, "math.randomseed", "seed");
  // By its bits, so that 1 and 1.5 are different seeds; -0 and 0 are too.
  box.reseed(combine(seed, std::bit_cast<std::uint64_t>(number)));
  return 0;
}

}  // namespace

void open_math(lua_State* state) {
  luaL_requiref(state, LUA_MATHLIBNAME, luaopen_math, 1);
  charge_all(state);  // a text may stand for a number
  set_functions(state, {{"random", random_number}, {"randomseed", seed_random}});
  lua_pop(state, 1);
}

}  // namespace stig::lua
