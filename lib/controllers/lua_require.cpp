// SPDX-License-Identifier: MIT
// require: files beside the program, by plain names.
#include <algorithm>
#include <filesystem>
#include <lua.hpp>
#include <string>

#include "controllers/lua_box.h"
#include "controllers/lua_libraries.h"

namespace stig {

namespace {

namespace fs = std::filesystem;

constexpr const char* kLoaded = "stig.loaded";

bool is_plain(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), fits);
}

/// The file, if it really is in the program's folder: a link may not lead out of it.
std::optional<std::string> find_beside(const std::string& program, const std::string& name) {
  std::error_code error;
  const fs::path folder = fs::canonical(fs::absolute(program).parent_path(), error);
  if (error) return std::nullopt;
  const fs::path file = fs::canonical(folder / (name + ".lua"), error);
  if (error || file.parent_path() != folder) return std::nullopt;
  return file.string();
}

/// The text of a module, or nothing with `problem` set.
std::optional<std::string> read_module(const std::string& program, const std::string& name,
                                       std::string& problem) {
  const auto path = find_beside(program, name);
  if (!path) {
    problem = "there is no file '" + name + ".lua' beside the program";
    return std::nullopt;
  }
  FileError error;
  auto text = read_file(*path, kMostLuaSource, error);
  if (!text) problem = error.message;
  return text;
}

std::string beside(const std::string& program, const std::string& name) {
  return program.substr(0, program.rfind('/') + 1) + name + ".lua";
}

int require(lua_State* state) {
  LuaBox& box = LuaBox::of(state);
  const std::string name(text_argument(state, 1, "require", "name"));
  if (!is_plain(name)) {
    return luaL_error(state,
                      "require: a name of letters, digits, _ and - is needed, of a file "
                      "beside the program");
  }
  lua_settop(state, 1);
  luaL_getsubtable(state, LUA_REGISTRYINDEX, kLoaded);
  lua_pushvalue(state, 1);
  if (lua_rawget(state, 2) != LUA_TNIL) {
    if (lua_islightuserdata(state, -1) == 0) return 1;
    return luaL_error(state, "require: '%s' requires itself", name.c_str());
  }
  box.charge(state, 10'000);  // files are slow
  std::string problem;
  const auto text = read_module(box.program().path, name, problem);
  if (!text) return luaL_error(state, "require: %s", problem.c_str());
  const std::string chunk = box.chunk_name(beside(box.program().path, name));
  if (!load_text(state, *text, chunk.c_str())) return lua_error(state);
  const auto keep = [&] {  // the value on top, as what the name stands for
    lua_pushvalue(state, 1);
    lua_pushvalue(state, -2);
    lua_rawset(state, 2);
  };
  lua_pushlightuserdata(state, &box);
  keep();
  lua_pop(state, 1);
  lua_pushvalue(state, 1);
  // A module that failed may be tried again.
  if (lua_pcall(state, 1, 1, 0) != LUA_OK) {
    lua_pushnil(state);
    keep();
    lua_pop(state, 1);
    return lua_error(state);
  }
  if (lua_isnil(state, -1)) {
    lua_pop(state, 1);
    lua_pushboolean(state, 1);
  }
  keep();
  return 1;
}

}  // namespace

void open_require(lua_State* state) {
  lua_pushcfunction(state, require);
  lua_setglobal(state, "require");
}

}  // namespace stig
