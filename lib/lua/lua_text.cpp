// SPDX-License-Identifier: MIT
// The string and utf8 libraries: Lua's own where their work is linear, which is charged; ours
// where it is not (patterns), or where addresses would show (%p).
#include <cassert>
#include <cstring>
#include <lua.hpp>
#include <optional>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"
#include "lua/lua_pattern.h"

namespace stig::lua {

namespace {

/// The function in upvalue 1, after paying for the texts that it is handed. A function of Lua's
/// library that takes time linear in its texts, with eight bytes an instruction; only the first
/// four arguments of any of them are texts of the caller's choice.
int charged(lua_State* state) {
  std::size_t size = 0;
  for (int i = 1, n = lua_gettop(state); i <= n && i <= 4; ++i) {
    if (lua_type(state, i) == LUA_TSTRING) size += lua_rawlen(state, i);
  }
  LuaBox::of(state).charge(state, size / 8);
  return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

std::string_view check_text(lua_State* state, int index) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(state, index, &size);
  return {text, size};
}

int rep(lua_State* state) {
  const std::string_view text = check_text(state, 1);
  const lua_Integer count = luaL_checkinteger(state, 2);
  const std::string_view separator = lua_isnoneornil(state, 3) ? "" : check_text(state, 3);
  // The limit on strings would end the program; an error here can be caught and says what was
  // wrong.
  const std::size_t most = LuaBox::of(state).settings().limits.string;
  const std::size_t each = text.size() + separator.size();
  if (count <= 0 || each == 0) {
    lua_pushliteral(state, "");
    return 1;
  }
  // The last has no separator; nothing overflows, since texts are short.
  if (static_cast<std::uint64_t>(count) > most / each + 1 ||
      static_cast<std::size_t>(count) * each - separator.size() > most) {
    return luaL_error(state, "string.rep: the text would have more than %d bytes",
                      static_cast<int>(most));
  }
  LuaBox::of(state).charge(state, static_cast<std::uint64_t>(count) / 8);
  luaL_Buffer buffer;
  luaL_buffinit(state, &buffer);
  for (lua_Integer i = 0; i < count; ++i) {
    if (i > 0) luaL_addlstring(&buffer, separator.data(), separator.size());
    luaL_addlstring(&buffer, text.data(), text.size());
  }
  luaL_pushresult(&buffer);
  return 1;
}

/// Replaces arguments of %s that Lua would show by address, then formats as Lua does. Formats are
/// walked only to find which argument each takes: %s and %p are the two that could show an address.
/// Lua's own format checks the rest.
int format(lua_State* state) {
  const std::string_view form = check_text(state, 1);
  LuaBox::of(state).charge(state, form.size() / 4);
  int argument = 1;
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] != '%') continue;
    if (++i < form.size() && form[i] == '%') continue;
    while (i < form.size() && std::strchr("-+ #0123456789.", form[i]) != nullptr && form[i] != 0) {
      ++i;
    }
    ++argument;
    if (i >= form.size()) break;
    if (form[i] == 'p') return luaL_error(state, "string.format: %%p is not known here");
    if (form[i] != 's' || argument > lua_gettop(state)) continue;
    push_text(state, argument);
    lua_replace(state, argument);
  }
  return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

// ---- Patterns ----

/// A first place, 0-based, from a 1-based one that may count from the end. As string.find and
/// others have it: -1 is the last character, and a place before the first is the first.
std::optional<std::size_t> start_place(lua_State* state, int index, std::size_t size) {
  const lua_Integer place = luaL_optinteger(state, index, 1);
  if (place > 0) {
    const auto start = static_cast<std::uint64_t>(place) - 1;
    return start <= size ? std::optional<std::size_t>(start) : std::nullopt;
  }
  const auto from_end = std::uint64_t{0} - static_cast<std::uint64_t>(place);
  return place == 0 || from_end > size ? 0 : size - static_cast<std::size_t>(from_end);
}

/// Pays for a matcher's steps so far, and raises what is wrong with its pattern.
void settle(lua_State* state, const LuaPattern& pattern, std::uint64_t& paid) {
  // Also when nothing was found: searching is the work.
  LuaBox::of(state).charge(state, pattern.steps() - paid);
  paid = pattern.steps();
  if (pattern.problem() != nullptr) luaL_error(state, "malformed pattern (%s)", pattern.problem());
}

LuaPattern matcher(lua_State* state, std::string_view subject, std::string_view pattern) {
  // What is left of the budget is the most steps: a match that would take longer is one that ends
  // the program.
  return {subject, pattern, LuaBox::of(state).left()};
}

struct Found {
  std::size_t begin = 0, end = 0;
};

/// The first match from `start` on.
std::optional<Found> search(lua_State* state, LuaPattern& pattern, std::size_t start,
                            bool anchored) {
  std::uint64_t paid = pattern.steps();
  std::optional<Found> found;
  // An attempt from every start, as in Lua: patterns are not compiled.
  for (std::size_t s = start; s <= pattern.subject().size(); ++s) {
    const std::size_t end = pattern.match(s);
    if (end != LuaPattern::kNone) found = Found{s, end};
    if (found || anchored || pattern.problem() != nullptr || pattern.exhausted()) break;
  }
  settle(state, pattern, paid);
  return found;
}

void push_capture(lua_State* state, const LuaPattern& pattern, int i, const Found& whole) {
  const std::string_view subject = pattern.subject();
  if (i >= pattern.captures()) {
    // %1 of a pattern without captures is the whole match.
    if (i > 0) luaL_error(state, "invalid capture index %%%d", i + 1);
    lua_pushlstring(state, subject.data() + whole.begin, whole.end - whole.begin);
    return;
  }
  const LuaPattern::Capture& capture = pattern.capture(i);
  if (capture.kind == LuaPattern::Capture::Kind::open) luaL_error(state, "unfinished capture");
  if (capture.kind == LuaPattern::Capture::Kind::position) {
    lua_pushinteger(state, static_cast<lua_Integer>(capture.begin) + 1);
  } else {
    lua_pushlstring(state, subject.data() + capture.begin, capture.length);
  }
}

/// All captures, or the whole match if there are none and it is wanted.
int push_captures(lua_State* state, const LuaPattern& pattern, const Found& whole, bool or_whole) {
  const int count = pattern.captures() == 0 && or_whole ? 1 : pattern.captures();
  luaL_checkstack(state, count + 2, "too many captures");
  for (int i = 0; i < count; ++i) push_capture(state, pattern, i, whole);
  return count;
}

// Plain searches are the common ones; two-way matching (memmem of glibc) keeps them linear.
int find_plain(lua_State* state, std::string_view text, std::string_view word, std::size_t start) {
  LuaBox::of(state).charge(state, (text.size() - start + word.size()) / 4);
  // Linear, whatever the texts; std::string_view::find is not.
  const void* at = word.empty()
                       ? text.data() + start
                       : memmem(text.data() + start, text.size() - start, word.data(), word.size());
  if (at == nullptr) {
    lua_pushnil(state);
    return 1;
  }
  const auto begin = static_cast<const char*>(at) - text.data();
  lua_pushinteger(state, begin + 1);
  lua_pushinteger(state, begin + static_cast<lua_Integer>(word.size()));
  return 2;
}

int find_or_match(lua_State* state, bool find) {
  const std::string_view text = check_text(state, 1);
  std::string_view form = check_text(state, 2);
  const auto start = start_place(state, 3, text.size());
  if (!start) {
    lua_pushnil(state);
    return 1;
  }
  const bool plain = form.find_first_of("^$*+?.([%-") == std::string_view::npos;
  if (find && (plain || lua_toboolean(state, 4) != 0)) {
    return find_plain(state, text, form, *start);
  }
  const bool anchored = form.starts_with('^');
  if (anchored) form.remove_prefix(1);
  LuaPattern pattern = matcher(state, text, form);
  const auto found = search(state, pattern, *start, anchored);
  if (!found) {
    lua_pushnil(state);
    return 1;
  }
  if (!find) return push_captures(state, pattern, *found, true);
  lua_pushinteger(state, static_cast<lua_Integer>(found->begin) + 1);
  lua_pushinteger(state, static_cast<lua_Integer>(found->end));
  return 2 + push_captures(state, pattern, *found, false);
}
int find(lua_State* state) { return find_or_match(state, true); }
int match(lua_State* state) { return find_or_match(state, false); }

/// Upvalues: text, pattern, next place, end of the last match (so that an empty match does not
/// follow right behind another). gmatch in Lua 5.4 keeps the end of the last match apart from the
/// place to go on from; so does this.
int next_match(lua_State* state) {
  const std::string_view text = check_text(state, lua_upvalueindex(1));
  const std::string_view form = check_text(state, lua_upvalueindex(2));
  auto start = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
  const lua_Integer last = lua_tointeger(state, lua_upvalueindex(4));
  LuaPattern pattern = matcher(state, text, form);
  for (; start <= text.size(); ++start) {
    const auto found = search(state, pattern, start, false);
    if (!found) break;
    if (static_cast<lua_Integer>(found->end) == last) {
      start = found->begin;
      continue;
    }
    lua_pushinteger(state, static_cast<lua_Integer>(found->end));
    lua_copy(state, -1, lua_upvalueindex(3));
    lua_replace(state, lua_upvalueindex(4));
    return push_captures(state, pattern, *found, true);
  }
  return 0;
}

int gmatch(lua_State* state) {
  const std::string_view text = check_text(state, 1);
  check_text(state, 2);
  const auto start = start_place(state, 3, text.size());
  lua_settop(state, 2);
  lua_pushinteger(state, static_cast<lua_Integer>(start.value_or(text.size() + 1)));
  lua_pushinteger(state, -1);
  lua_pushcclosure(state, next_match, 4);
  return 1;
}

// %0 to %9 and %% in a replacement text; anything else after '%' is an error since Lua 5.2.
void add_template(lua_State* state, luaL_Buffer& buffer, const LuaPattern& pattern,
                  const Found& whole) {
  const std::string_view form = check_text(state, 3);
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] != '%') {
      luaL_addchar(&buffer, form[i]);
      continue;
    }
    const char c = ++i < form.size() ? form[i] : '\0';
    if (c == '%') {
      luaL_addchar(&buffer, '%');
    } else if (c == '0') {
      luaL_addlstring(&buffer, pattern.subject().data() + whole.begin, whole.end - whole.begin);
    } else if (c >= '1' && c <= '9') {
      push_capture(state, pattern, c - '1', whole);
      luaL_tolstring(state, -1, nullptr);  // a place is a number
      lua_remove(state, -2);
      luaL_addvalue(&buffer);
    } else {
      luaL_error(state, "invalid use of '%%' in replacement string");
    }
  }
}

/// Adds what stands for a match: of a text, a table or a function.
void add_replacement(lua_State* state, luaL_Buffer& buffer, const LuaPattern& pattern,
                     const Found& whole) {
  const int type = lua_type(state, 3);
  if (type == LUA_TSTRING || type == LUA_TNUMBER) {
    LuaBox::of(state).charge(state, lua_rawlen(state, 3));
    add_template(state, buffer, pattern, whole);
    return;
  }
  if (type == LUA_TFUNCTION) {
    lua_pushvalue(state, 3);
    lua_call(state, push_captures(state, pattern, whole, true), 1);
  } else {
    push_capture(state, pattern, 0, whole);
    lua_gettable(state, 3);
  }
  if (lua_toboolean(state, -1) == 0) {
    // false or nil: the match stays as it was.
    lua_pop(state, 1);
    luaL_addlstring(&buffer, pattern.subject().data() + whole.begin, whole.end - whole.begin);
    return;
  }
  if (lua_isstring(state, -1) == 0) {
    luaL_error(state, "invalid replacement value (a %s)", luaL_typename(state, -1));
  }
  luaL_addvalue(&buffer);
}

int gsub(lua_State* state) {
  const std::string_view text = check_text(state, 1);
  std::string_view form = check_text(state, 2);
  const int type = lua_type(state, 3);
  luaL_argexpected(
      state,
      type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TFUNCTION || type == LUA_TTABLE, 3,
      "string/function/table");
  // A number as replacement becomes its text once, and not for each match.
  if (type == LUA_TNUMBER) lua_tostring(state, 3);
  const lua_Integer most = luaL_optinteger(state, 4, static_cast<lua_Integer>(text.size()) + 1);
  const bool anchored = form.starts_with('^');
  if (anchored) form.remove_prefix(1);
  lua_settop(state, 4);
  luaL_Buffer buffer;
  luaL_buffinit(state, &buffer);
  lua_Integer count = 0;
  std::size_t place = 0, last_end = LuaPattern::kNone;
  while (count < most) {
    // A new one each time: what was called meanwhile has spent of the budget too.
    LuaPattern pattern = matcher(state, text, form);
    const auto found = search(state, pattern, place, true);
    if (found && found->end != last_end) {
      ++count;
      add_replacement(state, buffer, pattern, *found);
      place = last_end = found->end;
    } else if (place < text.size()) {
      luaL_addchar(&buffer, text[place++]);
    } else {
      break;
    }
    if (anchored) break;
  }
  luaL_addlstring(&buffer, text.data() + place, text.size() - place);
  luaL_pushresult(&buffer);
  lua_pushinteger(state, count);
  return 2;
}

}  // namespace

// Keys stay the same and only values change, which lua_next allows.
void charge_all(lua_State* state) {
  assert(lua_istable(state, -1));
  lua_pushnil(state);
  while (lua_next(state, -2) != 0) {
    if (lua_iscfunction(state, -1) != 0) {
      lua_pushvalue(state, -2);
      lua_insert(state, -2);
      lua_pushcclosure(state, charged, 1);
      lua_rawset(state, -4);
    } else {
      lua_pop(state, 1);
    }
  }
}

void open_text(lua_State* state) {
  luaL_requiref(state, LUA_UTF8LIBNAME, luaopen_utf8, 1);
  charge_all(state);
  luaL_requiref(state, LUA_STRLIBNAME, luaopen_string, 1);
  // string.dump gives a function's bytecode, which depends on the interpreter, and is of no use
  // without load.
  lua_pushnil(state);
  lua_setfield(state, -2, "dump");
  // Fetched before charge_all wraps it: format calls Lua's own function.
  lua_getfield(state, -1, "format");
  const lua_CFunction lua_format = lua_tocfunction(state, -1);
  lua_pop(state, 1);
  charge_all(state);
  set_functions(
      state, {{"rep", rep}, {"find", find}, {"match", match}, {"gmatch", gmatch}, {"gsub", gsub}});
  lua_pushcfunction(state, lua_format);
  lua_pushcclosure(state, format, 1);
  lua_setfield(state, -2, "format");
  // The metatable that all texts share is out of the program's hands.
  lua_getmetatable(state, (lua_pushliteral(state, ""), -1));
  charge_all(state);  // arithmetic reads numbers out of texts
  lua_pushliteral(state, "string");
  lua_setfield(state, -2, "__metatable");
  lua_pop(state, 4);
}

}  // namespace stig::lua
