// SPDX-License-Identifier: MIT
#include "lua/lua_score.h"

#include <fmt/format.h>

#include <cmath>

#include <lua.hpp>

#include "lua/lua_box.h"
#include "lua/lua_callbacks.h"
#include "lua/lua_interface.h"
#include "lua/lua_libraries.h"

namespace stig::lua {
namespace {

struct ScoreJob {
  const ScoredStructure* one = nullptr;
  double score = 0;
};

void push_cells(lua_State* state, const std::vector<ScoredCell>& cells) {
  lua_createtable(state, static_cast<int>(cells.size()), 0);
  lua_Integer place = 0;
  for (const ScoredCell& cell : cells) {
    lua_createtable(state, 0, 4);
    const std::pair<const char*, int> fields[] = {
        {"x", cell.x}, {"y", cell.y}, {"z", cell.z}, {"color", cell.colour}};
    // Whole numbers, which index lists and print without a point.
    for (const auto& [name, value] : fields) {
      lua_pushinteger(state, value);
      put(state, name);
    }
    lua_rawseti(state, -2, ++place);
  }
}

void push_structure(lua_State* state, const ScoredStructure& one) {
  lua_newtable(state);
  for (const auto& [name, value] : one.measures) put(state, std::string(name).c_str(), value);
  lua_pushinteger(state, static_cast<lua_Integer>(one.id));
  put(state, "id");
  push_cells(state, one.cells);
  put(state, "cells");
}

int load_and_score(lua_State* state) {
  push_robot(state);  // for log and print, which nobody hears; nothing scored is a robot
  lua_pop(state, 1);
  lua_pushnil(state);
  lua_setglobal(state, "robot");
  LuaBox& box = LuaBox::of(state);
  const std::string chunk = box.chunk_name(box.program().path);
  if (!load_text(state, without_head(box.program().text), chunk.c_str())) lua_error(state);
  lua_call(state, 0, 0);
  need_one_of(state, {"score"});
  push_callback(state, "score");
  auto& job = *static_cast<ScoreJob*>(lua_touserdata(state, 1));
  push_structure(state, *job.one);
  lua_call(state, 1, 1);
  // A text that looks like a number is a mistake more often than not.
  if (lua_type(state, -1) != LUA_TNUMBER || !std::isfinite(lua_tonumber(state, -1))) {
    const char* what = lua_isnil(state, -1) ? "nothing" : push_shown(state, lua_gettop(state));
    luaL_error(state, "score returned %s in place of a finite number", what);
  }
  job.score = lua_tonumber(state, -1);
  return 0;
}

}  // namespace

std::optional<double> lua_score(const LuaProgram& program, const ScoredStructure& one,
                                LuaFailure& failure) {
  LuaSettings settings;
  settings.id = fmt::format("individual {}", one.id);
  settings.seed = 1;
  std::vector<std::string> log;
  LuaSide side;
  side.log = &log;
  LuaBox box(program, std::move(settings), &side);
  ScoreJob job{&one};
  if (box.run(load_and_score, &job).ok) return job.score;
  failure = box.last_failure();
  return std::nullopt;
}

}  // namespace stig::lua
