// SPDX-License-Identifier: MIT
// require: files beside the program or in folders there, by plain names; and, for programs of 2019,
// package.path, by which they name their folders.
//
// A scene's programs travel with it, in traces and checkpoints, so `require` looks first among the
// modules that came with the program, and for files only where the program itself came from a file.
// What a text requires is found without running it, by looking for the word: names must be written
// out.
#include <algorithm>
#include <cassert>
#include <filesystem>
#include <lua.hpp>
#include <string>

#include "lua/lua_box.h"
#include "lua/lua_libraries.h"
#include "lua/module_search.h"

namespace stig::lua {

namespace {

namespace fs = std::filesystem;

constexpr const char* kLoaded = "stig.loaded";
constexpr const char* kPackage = "stig.package";

/// The file, if it really is below the program's folder: a link may not lead out of it. Both sides
/// are made canonical, so that neither '..' nor a link decides. Names have neither, by
/// is_module_name, but a folder in a program's folder may be a link.
std::optional<std::string> find_beside(const std::string& program, const std::string& beside) {
  std::error_code error;
  const fs::path folder = fs::canonical(fs::absolute(program).parent_path(), error);
  if (error) return std::nullopt;
  const fs::path file = fs::canonical(folder / beside, error);
  if (error) return std::nullopt;
  // The folder's path must be a prefix, part by part: "/a/bc" is not below "/a/b".
  const auto parted = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return parted.first == folder.end() ? std::optional(file.string()) : std::nullopt;
}

/// A module's text, and the path by which messages call it.
struct Module {
  std::string path, text;
};

/// The file beside the program, or nothing with `problem` set where it cannot be read.
std::optional<Module> read_beside(const LuaProgram& program, const std::string& file,
                                  std::string& problem) {
  const auto path = find_beside(program.path, file);
  if (!path) return std::nullopt;
  FileError error;
  auto text = read_file(*path, kMostLuaSource, error);
  if (!text) {
    problem = error.message;
    return std::nullopt;
  }
  // As the user named the program, whatever the file's canonical path is.
  return Module{program.path.substr(0, program.path.rfind('/') + 1) + file, std::move(*text)};
}

/// A module by its name, or nothing with `problem` set.
std::optional<Module> read_module(const LuaProgram& program, const std::string& name,
                                  std::string& problem) {
  for (const auto& [known, text] : program.modules) {
    if (known == name) return Module{module_path(program, name), text};
  }
  problem = "there is no file '" + module_file(name) + "' beside the program";
  // Only what the text names came with it.
  if (!program.whole) return read_beside(program, module_file(name), problem);
  problem +=
      ", or its name does not stand in the program's text: it must, as require '" + name + "'";
  return std::nullopt;
}

/// The same for a program of 2019, by the templates of package.path.
std::optional<Module> search_module(const LuaProgram& program, const std::string& name,
                                    std::string_view templates, std::string& problem) {
  problem = "there is no module '" + name + "'; tried";
  for (const std::string& file : module_candidates(name, templates, program.path)) {
    problem += " '" + file + "'";
    for (const auto& [known, text] : program.modules) {
      if (known == file) return Module{file, text};
    }
    // Without a scene there is no folder that the program was started in but its own.
    if (program.whole) continue;
    if (auto module = read_beside(program, file, problem)) return module;
  }
  return std::nullopt;
}

/// package.path as the program has made it.
std::string path_templates(lua_State* state) {
  lua_getfield(state, LUA_REGISTRYINDEX, kPackage);
  lua_pushliteral(state, "path");
  lua_rawget(state, -2);
  if (lua_type(state, -1) != LUA_TSTRING) luaL_error(state, "require: package.path is no text");
  std::string out(lua_tostring(state, -1), lua_rawlen(state, -1));
  lua_pop(state, 2);
  return out;
}

std::optional<Module> find_module(lua_State* state, const std::string& name, std::string& problem) {
  const LuaProgram& program = LuaBox::of(state).program();
  if (program.interface == InterfaceLevel::of_2021) return read_module(program, name, problem);
  return search_module(program, name, path_templates(state), problem);
}

int require(lua_State* state) {
  LuaBox& box = LuaBox::of(state);
  const std::string name(text_argument(state, 1, "require", "name"));
  const bool searched = box.program().interface == InterfaceLevel::of_2019;
  if (searched ? !is_module_search_name(name) : !is_module_name(name)) {
    return luaL_error(state,
                      "require: a name of letters, digits, _ and - is needed, of a file "
                      "beside the program, with a dot after each folder");
  }
  lua_settop(state, 1);
  luaL_getsubtable(state, LUA_REGISTRYINDEX, kLoaded);
  lua_pushvalue(state, 1);
  if (lua_rawget(state, 2) != LUA_TNIL) {
    // While a module runs its name stands for a light pointer, which no program can make: that is
    // how a circle is noticed.
    if (lua_islightuserdata(state, -1) == 0) return 1;
    return luaL_error(state, "require: '%s' requires itself", name.c_str());
  }
  box.charge(state, 10'000);  // files are slow
  std::string problem;
  const auto module = find_module(state, name, problem);
  if (!module) return luaL_error(state, "require: %s", problem.c_str());
  const std::string chunk = box.chunk_name(module->path);
  if (!load_text(state, without_head(module->text), chunk.c_str())) return lua_error(state);
  const auto keep = [&] {  // the value on top, as what the name stands for
    lua_pushvalue(state, 1);
    lua_pushvalue(state, -2);
    lua_rawset(state, 2);
  };
  lua_pushlightuserdata(state, &box);
  keep();
  lua_pop(state, 1);
  // Handed its own name, as in Lua.
  lua_pushvalue(state, 1);
  // A module that failed may be tried again.
  if (lua_pcall(state, 1, 1, 0) != LUA_OK) {
    lua_pushnil(state);
    keep();
    lua_pop(state, 1);
    return lua_error(state);
  }
  // As in Lua, a module that returns nothing is true.
  if (lua_isnil(state, -1)) {
    lua_pop(state, 1);
    lua_pushboolean(state, 1);
  }
  keep();
  return 1;
}

}  // namespace

bool is_module_name(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  // 64 bytes: names become keys of scenes' files and parts of paths.
  if (name.size() > 64) return false;
  for (std::size_t at = 0;;) {
    const std::string_view part = name.substr(at, name.find('.', at) - at);
    if (part.empty() || !std::all_of(part.begin(), part.end(), fits)) return false;
    at += part.size() + 1;
    if (at > name.size()) return true;
  }
}

// A dot is a folder, as in Lua's own package.path.
std::string module_file(std::string_view name) {
  assert(is_module_name(name));
  std::string out(name);
  std::replace(out.begin(), out.end(), '.', '/');
  return out + ".lua";
}

std::string module_path(const LuaProgram& program, const std::string& module) {
  if (program.interface == InterfaceLevel::of_2019) return module;
  return program.path.substr(0, program.path.rfind('/') + 1) + module_file(module);
}

// A word in a comment or a text is found too, which costs a file that is not needed and nothing
// else. Names that are put together while running are not found, and `require` says so.
std::vector<std::string> required_names(std::string_view text) {
  constexpr std::string_view kWord = "require";
  std::vector<std::string> out;
  for (auto at = text.find(kWord); at != text.npos; at = text.find(kWord, at)) {
    at += kWord.size();
    const auto open = text.find_first_not_of(" \t(", at);
    if (open == text.npos || (text[open] != '\'' && text[open] != '"')) continue;
    const auto close = text.find(text[open], open + 1);
    if (close == text.npos) break;
    const std::string name(text.substr(open + 1, close - open - 1));
    if (is_module_name(name) && std::find(out.begin(), out.end(), name) == out.end()) {
      out.push_back(name);
    }
  }
  return out;
}

void open_require(lua_State* state) {
  lua_pushcfunction(state, require);
  lua_setglobal(state, "require");
}

// The table is found by the registry, as in Lua, so that a program may hide it. What native
// libraries would need is not there, but for an empty cpath, which programs add to.
void open_package(lua_State* state) {
  lua_createtable(state, 0, 3);
  lua_pushlstring(state, kDefaultTemplates.data(), kDefaultTemplates.size());
  lua_setfield(state, -2, "path");
  lua_pushliteral(state, "");
  lua_setfield(state, -2, "cpath");
  luaL_getsubtable(state, LUA_REGISTRYINDEX, kLoaded);
  lua_setfield(state, -2, "loaded");
  lua_pushvalue(state, -1);
  lua_setfield(state, LUA_REGISTRYINDEX, kPackage);
  lua_setglobal(state, "package");
}

}  // namespace stig::lua
