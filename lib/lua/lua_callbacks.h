// SPDX-License-Identifier: MIT
// The global functions by which a host calls a program, and what is said when one that it cannot
// do without is not there: most often it is, under a name that nobody calls.
#pragma once

#include <initializer_list>

#include "lua/uses.h"

struct lua_State;

namespace stig::lua {

/// Pushes the global function and returns true; false, with nothing pushed, when there is none.
/// Raises an error when the name stands for something else.
bool push_callback(lua_State* state, const char* name);
/// Calls it without arguments, if it is there.
void call_back(lua_State* state, const char* name);
/// Calls it without arguments, and raises an error when it is not there.
void call_needed(lua_State* state, const char* name);
/// Raises an error unless the program has one of these functions, which names the function that
/// is near to one of them, and where it begins.
void need_one_of(lua_State* state, std::initializer_list<const char*> names);

}  // namespace stig::lua
