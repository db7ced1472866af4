// SPDX-License-Identifier: MIT
// How C++ and a program's tables meet. Tables of devices are made once and kept in the registry;
// steps write plain fields into them, raw, so that no metatable of the program runs in between.
// Functions carry their device's number as an upvalue, since they may be called without the table
// that they came from.
#include "lua/lua_interface.h"

#include <algorithm>
#include <cassert>
#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"

namespace stig::lua {

namespace {

// Logs go into traces and reports, whose size programs must not decide.
constexpr std::size_t kMostLogged = std::size_t{64} << 10;  ///< bytes a call
constexpr std::size_t kMostLine = 2000;
constexpr std::size_t kMostSent = 1024;
constexpr std::size_t kMostMessages = 64;  ///< of a radio in a step

LuaSide& side_of(lua_State* state) { return *static_cast<LuaSide*>(LuaBox::of(state).user()); }

void add_line(LuaSide& side, std::string line) {
  // One line tells that there was more; then nothing until the next call.
  constexpr const char* kFull = "(more was logged in this step and is left out)";
  if (side.log == nullptr || side.logged > kMostLogged) return;
  if (line.size() > kMostLine) line.resize(kMostLine);
  side.logged += line.size() + 1;
  side.log->push_back(side.logged > kMostLogged ? kFull : std::move(line));
}

/// Logs the arguments from `first` on, after a prefix.
int log_arguments(lua_State* state, std::string line, int first, std::string_view between) {
  for (int i = first, n = lua_gettop(state); i <= n && line.size() <= kMostLine; ++i) {
    if (i > first) line += between;
    line += push_text(state, i);
    lua_pop(state, 1);
  }
  // Texts are copied: charged by the byte, beside a cost for the call.
  LuaBox::of(state).charge(state, 10 + line.size() / 8);
  add_line(side_of(state), std::move(line));
  return 0;
}

int print(lua_State* state) { return log_arguments(state, "", 1, "\t"); }
/// ARGoS's log and logerr join their arguments.
int log(lua_State* state) { return log_arguments(state, "", 1, ""); }
int log_error(lua_State* state) { return log_arguments(state, "error: ", 1, ""); }

/// robot.logger(…), robot.logger:info(…): with or without the logger itself in front.
int log_as(lua_State* state, const char* level) {
  lua_pushvalue(state, lua_upvalueindex(1));
  // lua_rawequal and not ==, which may be a metamethod.
  const bool is_method = lua_rawequal(state, 1, -1) != 0;
  lua_pop(state, 1);
  return log_arguments(state, level, is_method ? 2 : 1, " ");
}
int log_plain(lua_State* state) { return log_as(state, ""); }
int log_info(lua_State* state) { return log_as(state, "info: "); }
int log_warning(lua_State* state) { return log_as(state, "warning: "); }
int log_failure(lua_State* state) { return log_as(state, "error: "); }
int ignore(lua_State* /*state*/) { return 0; }

void push_logger(lua_State* state) {
  constexpr LuaEntry kMethods[] = {
      {"info", log_info},          {"warn", log_warning},     {"error", log_failure},
      {"log_info", log_info},      {"log_warn", log_warning}, {"log_err", log_failure},
      {"register_module", ignore}, {"set_verbosity", ignore}, {"enable", ignore},
      {"disable", ignore},         {"set_level", ignore}};
  // The logger itself is the upvalue of its methods, for log_as to recognise.
  lua_createtable(state, 0, static_cast<int>(std::size(kMethods)));
  for (const LuaEntry& entry : kMethods) {
    lua_pushvalue(state, -1);
    lua_pushcclosure(state, entry.function, 1);
    lua_setfield(state, -2, entry.name);
  }
  // A metatable of its own makes robot.logger(…) a call.
  lua_createtable(state, 0, 1);
  lua_pushvalue(state, -2);
  lua_pushcclosure(state, log_plain, 1);
  lua_setfield(state, -2, "__call");
  lua_setmetatable(state, -2);
}

void push_value(lua_State* state, const LuaValue& value) {
  if (const auto* truth = std::get_if<bool>(&value)) {
    lua_pushboolean(state, *truth ? 1 : 0);
  } else if (const auto* number = std::get_if<double>(&value)) {
    lua_pushnumber(state, *number);
  } else {
    const auto& text = std::get<std::string>(value);
    lua_pushlstring(state, text.data(), text.size());
  }
}

/// The bytes of the list at index 1. Bytes as a list are how ARGoS's radios have it; a text is our
/// own addition, and shorter to write.
Message bytes_of(lua_State* state) {
  const lua_Unsigned size = lua_rawlen(state, 1);
  if (size > kMostSent)
    luaL_error(state, "send: a message has at most %d bytes", static_cast<int>(kMostSent));
  Message message;
  for (lua_Unsigned i = 1; i <= size; ++i) {
    lua_rawgeti(state, 1, static_cast<lua_Integer>(i));
    int exact = 0;
    const lua_Integer byte =
        lua_type(state, -1) == LUA_TNUMBER ? lua_tointegerx(state, -1, &exact) : 0;
    // An integer that comes as 1.0 is taken; 1.5 and '1' are not.
    if (exact == 0 || byte < 0 || byte > 255) {
      luaL_error(state,
                 "send: byte %d of the message must be a whole number from 0 to 255, and is %s",
                 static_cast<int>(i), push_shown(state, -1));
    }
    message += static_cast<char>(byte);
    lua_pop(state, 1);
  }
  return message;
}

Message message_argument(lua_State* state) {
  if (lua_istable(state, 1)) return bytes_of(state);
  if (lua_type(state, 1) != LUA_TSTRING) {
    bad_argument(state, 1, "send", "message", "a list of bytes or a text");
  }
  const std::string_view text = text_argument(state, 1, "send", "message");
  if (text.size() > kMostSent) {
    luaL_error(state, "send: a message has at most %d bytes", static_cast<int>(kMostSent));
  }
  return Message(text);
}

}  // namespace

void put(lua_State* state, const char* key) {
  assert(lua_istable(state, -2));
  // Raw: lua_setfield would ask a metatable's __newindex.
  lua_pushstring(state, key);
  lua_insert(state, -2);
  lua_rawset(state, -3);
}
void put(lua_State* state, const char* key, double number) {
  assert(lua_istable(state, -1));
  lua_pushstring(state, key);
  lua_pushnumber(state, number);
  lua_rawset(state, -3);
}
void put(lua_State* state, const char* key, bool truth) {
  assert(lua_istable(state, -1));
  lua_pushstring(state, key);
  lua_pushboolean(state, truth ? 1 : 0);
  lua_rawset(state, -3);
}
void put(lua_State* state, const char* key, std::string_view text) {
  assert(lua_istable(state, -1));
  lua_pushstring(state, key);
  lua_pushlstring(state, text.data(), text.size());
  lua_rawset(state, -3);
}
void put_function(lua_State* state, const char* key, int (*function)(lua_State*),
                  std::size_t device) {
  assert(function != nullptr);
  lua_pushinteger(state, static_cast<lua_Integer>(device));
  lua_pushcclosure(state, function, 1);
  put(state, key);
}
std::size_t device_of(lua_State* state) {
  return static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(1)));
}
int keep_table(lua_State* state) {
  assert(lua_istable(state, -1));
  // luaL_ref gives positive numbers that are not used again before they are freed, and nothing is
  // freed here.
  lua_pushvalue(state, -1);
  return luaL_ref(state, LUA_REGISTRYINDEX);
}
void push_kept(lua_State* state, int reference) {
  assert(reference > 0);
  lua_rawgeti(state, LUA_REGISTRYINDEX, reference);
}

void push_robot(lua_State* state) {
  lua_pushglobaltable(state);
  set_functions(state, {{"print", print}, {"log", log}, {"logerr", log_error}});
  if (is_of_2019(state)) {
    lua_getfield(state, -1, "io");
    set_functions(state, {{"write", log}});
    lua_pop(state, 1);
  }
  lua_newtable(state);
  lua_pushvalue(state, -1);
  lua_setfield(state, -3, "robot");
  lua_remove(state, -2);
  const LuaSettings& settings = LuaBox::of(state).settings();
  put(state, "id", settings.id);
  lua_newtable(state);
  for (const auto& [name, value] : settings.params) {
    lua_pushlstring(state, name.data(), name.size());
    push_value(state, value);
    lua_rawset(state, -3);
  }
  put(state, "params");
  push_logger(state);
  put(state, "logger");
}

void push_radio(lua_State* state, std::size_t place, int (*send)(lua_State*)) {
  lua_createtable(state, 0, 2);
  put_function(state, "send", send, place);
  lua_newtable(state);
  put(state, "recv");
}

void add_message(lua_State* state, std::vector<std::vector<Message>>& sends, std::size_t radios) {
  assert(device_of(state) < radios);
  // The list has an entry for every radio once any has sent.
  sends.resize(std::max(sends.size(), radios));
  auto& sent = sends[device_of(state)];
  if (sent.size() >= kMostMessages) {
    luaL_error(state, "send: at most %d messages in a step", static_cast<int>(kMostMessages));
  }
  sent.push_back(message_argument(state));
  LuaBox::of(state).charge(state, 10 + sent.back().size());
}

void put_received(lua_State* state, int radio, const std::vector<Message>& messages) {
  push_kept(state, radio);
  if (messages.empty()) {
    // Mostly nothing comes twice in a row: then the empty list of the last step will do. Otherwise
    // each of thousands of blocks would make six new lists a step.
    lua_pushliteral(state, "recv");
    if (lua_rawget(state, -2) == LUA_TTABLE) {
      // The list is checked to be empty, since it is the program's, which may have put something
      // into it.
      lua_pushnil(state);
      if (lua_next(state, -2) == 0) {
        lua_pop(state, 2);
        return;
      }
      lua_pop(state, 2);
    }
    lua_pop(state, 1);
  }
  lua_createtable(state, static_cast<int>(messages.size()), 0);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const Message& message = messages[i];
    lua_createtable(state, static_cast<int>(message.size()), 0);
    for (std::size_t j = 0; j < message.size(); ++j) {
      lua_pushinteger(state, static_cast<unsigned char>(message[j]));
      lua_rawseti(state, -2, static_cast<lua_Integer>(j) + 1);
    }
    lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
  }
  put(state, "recv");
  lua_pop(state, 1);
}

}  // namespace stig::lua
