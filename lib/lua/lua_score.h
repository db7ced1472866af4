// SPDX-License-Identifier: MIT
// A number from a program of the user's: `score(one)` in Lua, given the measures of a structure and
// its cells. Each call has a Lua state of its own in the sandbox of robots' programs, so that what
// it says follows from what it is given alone, whatever was scored before and by which thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lua/lua_settings.h"
#include "lua/uses.h"

namespace stig::lua {

struct ScoredCell {
  int x = 0, y = 0, z = 0;
  int colour = 0;  ///< from 1
};

/// What the function finds in the table that it is given: a field for each measure, `id`, and
/// `cells`, a list of tables with x, y, z and color.
struct ScoredStructure {
  std::uint64_t id = 0;
  std::vector<std::pair<std::string_view, double>> measures;
  std::vector<ScoredCell> cells;
};

/// Nothing, with `failure` set, where the program fails, exceeds a limit, or returns anything but a
/// finite number. `require` finds the program's modules and no files.
std::optional<double> lua_score(const LuaProgram& program, const ScoredStructure& one,
                                LuaFailure& failure);

}  // namespace stig::lua
