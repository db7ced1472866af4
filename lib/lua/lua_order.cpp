// SPDX-License-Identifier: MIT
// next, pairs and tostring that are the same in every run. Lua's tables hash texts with a seed
// and objects by address; here keys come in an order of their own: positive whole numbers
// rising, other numbers rising, texts by their bytes, false, true. Objects as keys have no such
// order, so a table may have one at most when it is walked.
#include <algorithm>
#include <cmath>
#include <lua.hpp>
#include <string_view>
#include <vector>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

/// What of a key decides its place. Texts are views into Lua's strings, which live as long as the
/// table holds them as keys.
struct Key {
  enum class Kind : std::uint8_t { whole, number, text, truth, object } kind = Kind::whole;
  lua_Integer whole = 0;
  bool is_whole = false;
  lua_Number number = 0;
  std::string_view text{};
};

Key key_at(lua_State* state, int index) {
  Key key;
  switch (lua_type(state, index)) {
    case LUA_TNUMBER:
      // 1 and 1.0 are the same key to Lua, which stores it as an integer.
      key.is_whole = lua_isinteger(state, index) != 0;
      key.whole = lua_tointeger(state, index);
      key.number = lua_tonumber(state, index);
      key.kind = key.is_whole && key.whole > 0 ? Key::Kind::whole : Key::Kind::number;
      return key;
    case LUA_TSTRING:
      key.kind = Key::Kind::text;
      key.text = {lua_tostring(state, index), lua_rawlen(state, index)};
      return key;
    case LUA_TBOOLEAN:
      key.kind = Key::Kind::truth;
      key.whole = lua_toboolean(state, index);
      return key;
    default:
      key.kind = Key::Kind::object;
      return key;
  }
}

// A strict weak order. NaN is no key in Lua, so numbers compare.
bool comes_before(const Key& a, const Key& b) {
  if (a.kind != b.kind) return a.kind < b.kind;
  switch (a.kind) {
    case Key::Kind::number:
      if (a.is_whole && b.is_whole) return a.whole < b.whole;
      if (a.number != b.number) return a.number < b.number;
      // An integer and a float of one value, beyond 2^53, where a double cannot tell neighbours
      // apart.
      return a.is_whole && !b.is_whole;
    case Key::Kind::text:
      return a.text < b.text;
    case Key::Kind::object:
      return false;
    default:
      return a.whole < b.whole;
  }
}

[[noreturn]] void refuse_objects(lua_State* state, const char* function) {
  luaL_error(state,
             "%s: the table has several keys that are tables, functions or the like; they have no "
             "order that is the same in every run",
             function);
  std::abort();  // luaL_error does not return, but does not say so
}

/// Calls `visit(key)`, key on top of the stack, for each of the table at index 1.
template <class Visit>
void each_key(lua_State* state, const Visit& visit) {
  lua_pushnil(state);
  while (lua_next(state, 1) != 0) {
    lua_pop(state, 1);
    visit(key_at(state, -1));
  }
}

/// next(table [, key]): each call looks through the whole table. Linear in the table's size, which
/// is charged; pairs, which sorts once, is the way to walk.
int next_key(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_settop(state, 3);  // 3: the best so far
  const bool from_start = lua_isnil(state, 2);
  const Key after = key_at(state, 2);
  Key best;
  bool found = false;
  std::size_t objects = 0, count = 0;
  each_key(state, [&](const Key& key) {
    ++count;
    objects += key.kind == Key::Kind::object ? 1 : 0;
    if (!from_start && !comes_before(after, key)) return;
    if (found && !comes_before(key, best)) return;
    found = true;
    best = key;
    // Kept by copying, since the key on top is lua_next's own and goes with the next turn.
    lua_copy(state, -1, 3);
  });
  LuaBox::of(state).charge(state, count);
  if (!found) {
    lua_pushnil(state);
    return 1;
  }
  // With a single object among the keys its place, the last, is certain.
  if (best.kind == Key::Kind::object && objects > 1) refuse_objects(state, "next");
  lua_pushvalue(state, 3);
  lua_pushvalue(state, 3);
  lua_rawget(state, 1);
  return 2;
}

/// Iterator of pairs: upvalues are the list of keys and the place in it.
int next_pair(lua_State* state) {
  // Keys are taken from a list made at the start; so unlike in Lua a program may add keys while it
  // walks, and finds those that it had.
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_Integer place = lua_tointeger(state, lua_upvalueindex(2));
  for (;;) {
    if (lua_rawgeti(state, lua_upvalueindex(1), ++place) == LUA_TNIL) return 1;
    lua_pushvalue(state, -1);
    if (lua_rawget(state, 1) != LUA_TNIL) break;
    lua_pop(state, 2);  // taken away meanwhile
  }
  lua_pushinteger(state, place);
  lua_replace(state, lua_upvalueindex(2));
  return 2;
}

/// Pushes the list of the keys of the table at index 1, in order. Keys are on the stack in
/// groups only, as texts by reference: the table holds them.
void push_keys(lua_State* state) {
  std::vector<Key> keys;
  each_key(state, [&](const Key& key) {
    if (key.kind == Key::Kind::object) {
      // Slot 2 is where pairs has put a nil for the one object that there may be.
      lua_pushvalue(state, -1);
      lua_replace(state, 2);
    }
    keys.push_back(key);
  });
  LuaBox::of(state).charge(state, 2 * keys.size());
  // No two keys are equal but for objects, of which more than one are refused below.
  std::sort(keys.begin(), keys.end(), comes_before);
  if (keys.size() > 1 && keys[keys.size() - 2].kind == Key::Kind::object) {
    refuse_objects(state, "pairs");
  }
  lua_createtable(state, static_cast<int>(keys.size()), 0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Key& key = keys[i];
    if (key.kind == Key::Kind::text) {
      lua_pushlstring(state, key.text.data(), key.text.size());
    } else if (key.kind == Key::Kind::truth) {
      lua_pushboolean(state, static_cast<int>(key.whole));
    } else if (key.kind == Key::Kind::object) {
      lua_pushvalue(state, 2);
    } else if (key.is_whole) {
      lua_pushinteger(state, key.whole);
    } else {
      lua_pushnumber(state, key.number);
    }
    lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
  }
}

int pairs(lua_State* state) {
  luaL_checkany(state, 1);
  lua_settop(state, 1);
  // As in Lua, __pairs gives the three values of a generic for.
  if (luaL_getmetafield(state, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(state, 1);
    lua_call(state, 1, 3);
    return 3;
  }
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_pushnil(state);
  push_keys(state);
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, next_pair, 2);
  lua_pushvalue(state, 1);
  lua_pushnil(state);
  return 3;
}

/// Objects are told apart by numbers, in the order in which they were first asked for.
/// tostring(table) shows an address in Lua. Numbers in the order of first use are the same in every
/// run, and still tell objects apart.
constexpr const char* kNumbers = "stig.numbers";

void push_object(lua_State* state, int index) {
  // The table has weak keys, see open_order: asking for a name keeps nothing alive.
  luaL_getsubtable(state, LUA_REGISTRYINDEX, kNumbers);
  lua_pushvalue(state, index);
  if (lua_rawget(state, -2) == LUA_TNIL) {
    lua_pop(state, 1);
    lua_pushinteger(state, static_cast<lua_Integer>(LuaBox::of(state).next_number()));
    lua_pushvalue(state, index);
    lua_pushvalue(state, -2);
    lua_rawset(state, -4);
  }
  const lua_Integer number = lua_tointeger(state, -1);
  const bool named = luaL_getmetafield(state, index, "__name") == LUA_TSTRING;
  const char* type = named ? lua_tostring(state, -1) : luaL_typename(state, index);
  lua_pushfstring(state, "%s: #%I", type, static_cast<LUAI_UACINT>(number));
}

int to_string(lua_State* state) {
  luaL_checkany(state, 1);
  push_text(state, 1);
  return 1;
}

}  // namespace

std::string_view push_text(lua_State* state, int index) {
  index = lua_absindex(state, index);
  luaL_checkstack(state, 8, "too many values");
  if (luaL_callmeta(state, index, "__tostring") != 0) {
    if (lua_isstring(state, -1) == 0) luaL_error(state, "'__tostring' must return a text");
    lua_tostring(state, -1);
  } else {
    switch (lua_type(state, index)) {
      case LUA_TNIL:
      case LUA_TBOOLEAN:
      case LUA_TNUMBER:
      case LUA_TSTRING:
        luaL_tolstring(state, index, nullptr);
        break;
      default:
        push_object(state, index);
    }
  }
  return {lua_tostring(state, -1), lua_rawlen(state, -1)};
}

void open_order(lua_State* state) {
  // Weak, so that a number keeps nothing alive.
  luaL_getsubtable(state, LUA_REGISTRYINDEX, kNumbers);
  lua_createtable(state, 0, 1);
  lua_pushliteral(state, "k");
  lua_setfield(state, -2, "__mode");
  lua_setmetatable(state, -2);
  lua_pop(state, 1);
  lua_pushglobaltable(state);
  set_functions(state, {{"next", next_key}, {"pairs", pairs}, {"tostring", to_string}});
  lua_pop(state, 1);
}

}  // namespace stig::lua
