// SPDX-License-Identifier: MIT
// The table library. Lua's own loops over as many places as a script asks for without a single
// instruction, and sorts large tables with the clock; this one pays for each place, and its sort
// is stable, whatever the comparator.
#include <algorithm>

#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

// Two instructions a place, about what a loop in Lua would cost at least.
void pay(lua_State* state, lua_Integer places) {
  if (places > 0) LuaBox::of(state).charge(state, 2 * static_cast<std::uint64_t>(places));
}

/// What '#' says of the table at index 1; a metatable may make it anything.
lua_Integer size_of(lua_State* state) {
  // 2^53: numbers up to there are exact as doubles, and sums of two of them do not overflow.
  constexpr lua_Integer kMost = lua_Integer{1} << 53;
  const lua_Integer size = luaL_len(state, 1);
  if (size < 0 || size > kMost) luaL_error(state, "table: a list cannot have this length");
  return size;
}

/// Number of places from one to another, 0 when there are none. In unsigned arithmetic, which is
/// defined where the range is wider than a signed integer.
std::uint64_t span(lua_Integer first, lua_Integer last) {
  if (first > last) return 0;
  const std::uint64_t more = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
  return more == UINT64_MAX ? more : more + 1;
}

int insert(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  // size_of may be a metamethod's answer, so nothing below takes it for the number of places that
  // are there.
  const lua_Integer end = size_of(state) + 1;
  const int count = lua_gettop(state);
  if (count == 2) {
    lua_seti(state, 1, end);
    return 0;
  }
  if (count != 3) return luaL_error(state, "table.insert: two or three arguments are needed");
  const lua_Integer place = integer_argument(state, 2, "table.insert", "position", 1, end);
  pay(state, end - place);
  for (lua_Integer i = end; i > place; --i) {
    lua_geti(state, 1, i - 1);
    lua_seti(state, 1, i);
  }
  lua_seti(state, 1, place);
  return 0;
}

int remove(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  const lua_Integer size = size_of(state);
  lua_Integer place = size;
  if (lua_gettop(state) > 1) {
    // One past the end, and 0 of an empty list, are allowed and remove what is there.
    place = integer_argument(state, 2, "table.remove", "position", size == 0 ? 0 : 1, size + 1);
  }
  lua_geti(state, 1, place);
  pay(state, size - place);
  for (; place < size; ++place) {
    lua_geti(state, 1, place + 1);
    lua_seti(state, 1, place);
  }
  lua_pushnil(state);
  lua_seti(state, 1, place);
  return 1;
}

int concat(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  std::size_t separator_size = 0;
  const char* separator = luaL_optlstring(state, 2, "", &separator_size);
  const lua_Integer first = luaL_optinteger(state, 3, 1);
  const lua_Integer last = lua_isnoneornil(state, 4) ? size_of(state) : luaL_checkinteger(state, 4);
  // Charged before the work, by places; the texts themselves are charged by the allocator.
  LuaBox::of(state).charge(state, span(first, last));
  luaL_Buffer buffer;
  luaL_buffinit(state, &buffer);
  for (std::uint64_t i = 0, n = span(first, last); i < n; ++i) {
    const auto place = first + static_cast<lua_Integer>(i);
    if (i > 0) luaL_addlstring(&buffer, separator, separator_size);
    lua_geti(state, 1, place);
    if (lua_isstring(state, -1) == 0) {
      return luaL_error(state, "table.concat: the value at %I is a %s, no text or number",
                        static_cast<LUAI_UACINT>(place), luaL_typename(state, -1));
    }
    luaL_addvalue(&buffer);
  }
  luaL_pushresult(&buffer);
  return 1;
}

int pack(lua_State* state) {
  const int count = lua_gettop(state);
  pay(state, count);
  lua_createtable(state, count, 1);
  lua_insert(state, 1);
  for (int i = count; i >= 1; --i) lua_seti(state, 1, i);
  lua_pushinteger(state, count);
  lua_setfield(state, 1, "n");
  return 1;
}

int unpack(lua_State* state) {
  // Lua's stack has a limit of a million; this one is for a program's own good.
  constexpr std::uint64_t kMostValues = 10'000;
  const lua_Integer first = luaL_optinteger(state, 2, 1);
  const lua_Integer last = lua_isnoneornil(state, 3) ? size_of(state) : luaL_checkinteger(state, 3);
  const std::uint64_t count = span(first, last);
  if (count > kMostValues || lua_checkstack(state, static_cast<int>(count) + 1) == 0) {
    return luaL_error(state, "table.unpack: too many values");
  }
  pay(state, static_cast<lua_Integer>(count));
  for (std::uint64_t i = 0; i < count; ++i) {
    lua_geti(state, 1, first + static_cast<lua_Integer>(i));
  }
  return static_cast<int>(count);
}

/// move(from, first, last, to [, table])
int move(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  const lua_Integer first = luaL_checkinteger(state, 2), last = luaL_checkinteger(state, 3);
  const lua_Integer to = luaL_checkinteger(state, 4);
  const int target = lua_isnoneornil(state, 5) ? 1 : 5;
  luaL_checktype(state, target, LUA_TTABLE);
  const std::uint64_t count = span(first, last);
  // Twice: a read and a write each. Two calls, since a product might overflow.
  LuaBox::of(state).charge(state, count);
  LuaBox::of(state).charge(state, count);
  // Beyond the budget's reach nothing overflows.
  if (count > 0 && to > LUA_MAXINTEGER - static_cast<lua_Integer>(count)) {
    return luaL_error(state, "table.move: no such places");
  }
  // Overlapping ranges of one table are moved from the end, as memmove does.
  const bool backwards = target == 1 && to > first && to <= last;
  for (std::uint64_t n = 0; n < count; ++n) {
    const auto i = static_cast<lua_Integer>(backwards ? count - 1 - n : n);
    lua_geti(state, 1, first + i);
    lua_seti(state, target, to + i);
  }
  lua_pushvalue(state, target);
  return 1;
}

// ---- Sorting: stack 1 the table, 2 the comparator or nil, 3 and 4 two lists ----
// Merge sort, bottom up, over two lists in turn. Comparators are the program's and may contradict
// themselves: whatever they say, merges end after the same number of steps and lose no value, where
// quicksort may run out of bounds.

/// Whether the value at the top comes before the one under it.
bool top_is_less(lua_State* state) {
  if (lua_isnil(state, 2)) return lua_compare(state, -1, -2, LUA_OPLT) != 0;
  lua_pushvalue(state, 2);
  lua_pushvalue(state, -2);
  lua_pushvalue(state, -4);
  lua_call(state, 2, 1);
  const bool less = lua_toboolean(state, -1) != 0;
  lua_pop(state, 1);
  return less;
}

/// Merges places [low, middle) and [middle, high) of one list into the other.
void merge(lua_State* state, int from, int to, lua_Integer low, lua_Integer middle,
           lua_Integer high) {
  pay(state, high - low);
  lua_Integer left = low, right = middle;
  for (lua_Integer place = low; place < high; ++place) {
    bool take_right = left >= middle;
    if (left < middle && right < high) {
      lua_rawgeti(state, from, left);
      lua_rawgeti(state, from, right);
      // take_right only where strictly less: equal values keep their order.
      take_right = top_is_less(state);
      lua_pop(state, 2);
    }
    lua_rawgeti(state, from, take_right ? right++ : left++);
    lua_rawseti(state, to, place);
  }
}

int sort(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  if (!lua_isnoneornil(state, 2)) luaL_checktype(state, 2, LUA_TFUNCTION);
  lua_settop(state, 2);
  const lua_Integer size = size_of(state);
  pay(state, size);
  lua_newtable(state);
  lua_newtable(state);
  for (lua_Integer i = 1; i <= size; ++i) {
    lua_geti(state, 1, i);
    lua_rawseti(state, 3, i);
  }
  int from = 3, to = 4;
  // The last width is at least the size, after which all is one run, in the list `from`.
  for (lua_Integer width = 1; width < size; width *= 2) {
    for (lua_Integer low = 1; low <= size; low += 2 * width) {
      merge(state, from, to, low, std::min(low + width, size + 1),
            std::min(low + 2 * width, size + 1));
    }
    std::swap(from, to);
  }
  for (lua_Integer i = 1; i <= size; ++i) {
    lua_rawgeti(state, from, i);
    lua_seti(state, 1, i);
  }
  return 0;
}

}  // namespace

void open_tables(lua_State* state) {
  lua_createtable(state, 0, 7);
  set_functions(state, {{"insert", insert},
                        {"remove", remove},
                        {"concat", concat},
                        {"pack", pack},
                        {"unpack", unpack},
                        {"move", move},
                        {"sort", sort}});
  lua_setglobal(state, "table");
}

}  // namespace stig::lua
