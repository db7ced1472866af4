// SPDX-License-Identifier: MIT
// A program whose step() is called Step(), on_step() or steps() runs without ever doing anything,
// and nothing about it is an error to Lua. So a host that finds a callback missing looks for a
// function that was probably meant, and names the line on which it begins.
#include "lua/lua_callbacks.h"

#include <fmt/format.h>

#include <cassert>
#include <lua.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/diagnostic.h"
#include "base/text.h"
#include "lua/lua_box.h"

namespace stig::lua {

namespace {

constexpr std::size_t kLongestNear = 64;   ///< bytes of a name that may be near another
constexpr std::uint64_t kGlobalCost = 20;  ///< instructions, for each global

/// Letters and digits alone, small: how names are compared. Case and underscores are how names of
/// one meaning differ between interfaces: on_step, onStep.
std::string bare(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') out += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) out += c;
  }
  return out;
}

/// A function of the program whose name is near to one that is wanted; smaller is nearer.
struct Near {
  int rank;
  std::string name;
  const char* wanted;
  friend bool operator<(const Near& a, const Near& b) {
    return std::tie(a.rank, a.name) < std::tie(b.rank, b.name);
  }
};

std::optional<Near> near_to(const std::string& name, const char* wanted) {
  const std::string own = bare(name), goal = bare(wanted);
  // Too many names would be near to a short one.
  if (own.size() < 3) return std::nullopt;
  if (own == goal) return Near{0, name, wanted};
  if (own.ends_with(goal) || goal.ends_with(own)) return Near{1, name, wanted};
  if (own.starts_with(goal)) return Near{2, name, wanted};
  if (edit_distance(own, goal, 1) <= 1) return Near{3, name, wanted};
  return std::nullopt;
}

/// The nearest of the global functions that are written in Lua; the order in which a table is
/// walked does not matter.
std::optional<Near> nearest_function(lua_State* state, std::initializer_list<const char*> names) {
  std::optional<Near> best;
  // The walk is by lua_next, whose order depends on the seed of hashes; the minimum over a total
  // order (rank, then name) does not.
  lua_pushglobaltable(state);
  lua_pushnil(state);
  while (lua_next(state, -2) != 0) {
    // The program may have filled its table of globals with millions of names: it pays for the
    // walk.
    LuaBox::of(state).charge(state, kGlobalCost);
    const bool plain = lua_type(state, -2) == LUA_TSTRING && lua_isfunction(state, -1) &&
                       lua_iscfunction(state, -1) == 0 && lua_rawlen(state, -2) <= kLongestNear;
    lua_pop(state, 1);
    if (!plain) continue;
    const std::string name = lua_tostring(state, -1);
    for (const char* wanted : names) {
      auto near = near_to(name, wanted);
      // strict <: among equals the first of `names` wins, which is the same in every run too.
      if (near && (!best || *near < *best)) best = std::move(near);
    }
  }
  lua_pop(state, 1);
  return best;
}

/// "file:line: " where the global function begins.
std::string place_of(lua_State* state, const std::string& function) {
  // Known to be a function, so this pushes it, and ">" takes it off again.
  push_callback(state, function.c_str());
  lua_Debug about{};
  lua_getinfo(state, ">S", &about);
  return fmt::format("{}:{}: ", about.short_src, about.linedefined);
}

std::string lack(lua_State* state, std::initializer_list<const char*> names) {
  const std::string wanted = fmt::format("'{}'", fmt::join(names, "', '"));
  const std::string what =
      names.size() == 1 ? fmt::format("there is no function {}, which each step calls", wanted)
                        : fmt::format("there is none of the functions {}", wanted);
  if (const auto near = nearest_function(state, names)) {
    return fmt::format("{}{}: is '{}' meant to be '{}'?", place_of(state, near->name), what,
                       printable(near->name), near->wanted);
  }
  LuaBox& box = LuaBox::of(state);
  return box.chunk_name(box.program().path).substr(1) + ": " + what;
}

}  // namespace

bool push_callback(lua_State* state, const char* name) {
  assert(name != nullptr);
  // Raw: a metatable of the globals may make up functions that are not there.
  lua_pushglobaltable(state);
  lua_pushstring(state, name);
  const int type = lua_rawget(state, -2);
  lua_remove(state, -2);
  if (type == LUA_TNIL) {
    lua_pop(state, 1);
    return false;
  }
  if (type != LUA_TFUNCTION) {
    luaL_error(state, "'%s' must be a function, and is a %s", name, lua_typename(state, type));
  }
  return true;
}

void call_back(lua_State* state, const char* name) {
  if (push_callback(state, name)) lua_call(state, 0, 0);
}

void call_needed(lua_State* state, const char* name) {
  if (!push_callback(state, name)) need_one_of(state, {name});
  lua_call(state, 0, 0);
}

void need_one_of(lua_State* state, std::initializer_list<const char*> names) {
  assert(names.size() > 0);
  for (const char* name : names) {
    if (!push_callback(state, name)) continue;
    lua_pop(state, 1);
    return;
  }
  const std::string text = lack(state, names);
  lua_pushlstring(state, text.data(), text.size());
  lua_error(state);
}

}  // namespace stig::lua
