// SPDX-License-Identifier: MIT
// The libraries that programs find in a LuaBox, each made by one function, and what those
// functions share. Called in protected mode only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/vec.h"
#include "lua/uses.h"
#include "sensing/camera.h"

struct lua_State;

namespace stig::lua {

void open_base(lua_State* state);        ///< what of the basic library is harmless; pcall, load
void open_order(lua_State* state);       ///< next, pairs, tostring: the same in every run
void open_text(lua_State* state);        ///< string, utf8
void open_tables(lua_State* state);      ///< table
void open_math(lua_State* state);        ///< math
void open_coroutines(lua_State* state);  ///< coroutine
void open_require(lua_State* state);     ///< require
void open_vectors(lua_State* state);     ///< vector2, vector3, quaternion
// Of the interface of 2019:
void open_package(lua_State* state);  ///< package.path, .cpath, .loaded
void open_debug(lua_State* state);    ///< debug.getinfo, .traceback; .sethook does nothing
void open_io(lua_State* state);  ///< io.open, which finds no file; io.read, which reads nothing

using LuaFunction = int (*)(lua_State*);
struct LuaEntry {
  const char* name;
  LuaFunction function;
};
/// Sets fields of the table on top of the stack.
void set_functions(lua_State* state, const LuaEntry* entries, std::size_t count);
template <std::size_t n>
void set_functions(lua_State* state, const LuaEntry (&entries)[n]) {
  set_functions(state, entries, n);
}

/// Makes every C function of the table on top pay for the texts that it is handed, before it
/// runs; they may have no upvalues.
void charge_all(lua_State* state);

/// Raises again, when the box was stopped, what some function caught: the value on top.
void raise_if_stopped(lua_State* state);

/// Pushes the text of a value as tostring gives it, and returns it; never an address.
std::string_view push_text(lua_State* state, int index);

/// A file's text as Lua reads files: without a byte order mark, and with an empty first line where
/// that begins with '#'.
std::string_view without_head(std::string_view file);
/// Loads the text as a function onto the stack, or pushes a message and returns false.
bool load_text(lua_State* state, std::string_view text, const char* chunk_name);

void push_vector(lua_State* state, const Vec3& v);
void push_vector(lua_State* state, const ImagePoint& v);
void push_quaternion(lua_State* state, const Quat& q);

/// The smallest turn from one direction to another; neither is 0.
Quat turn_between(const Vec3& from, const Vec3& to);

/// Arguments; wrong ones raise an error that names the function and the argument.
double number_argument(lua_State* state, int index, const char* function, const char* name);
std::int64_t integer_argument(lua_State* state, int index, const char* function, const char* name,
                              std::int64_t low, std::int64_t high);
bool bool_argument(lua_State* state, int index, const char* function, const char* name);
std::string_view text_argument(lua_State* state, int index, const char* function, const char* name);
Vec3 vector_argument(lua_State* state, int index, const char* function, const char* name);
/// The argument as a quaternion of length 1, whatever the length of what was given.
Quat quaternion_argument(lua_State* state, int index, const char* function, const char* name);
/// Pushes what a message shows of an argument: "missing", a number, the beginning of a text in
/// quotes, otherwise its type. It is valid as long as it stays on the stack.
const char* push_shown(lua_State* state, int index);
[[noreturn]] void bad_argument(lua_State* state, int index, const char* function, const char* name,
                               const char* expected);

}  // namespace stig::lua
