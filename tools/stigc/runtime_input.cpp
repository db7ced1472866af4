// SPDX-License-Identifier: MIT
// The library of controllers is compiled into one file, in which every module must come after those
// that it requires: a depth-first walk gives that order. A circle would end in the list as it was
// begun, and fails in Lua, as it should.
#include "runtime_input.h"

#include <algorithm>

#include "base/file_io.h"
#include "lua/lua_settings.h"
#include "scene_input.h"

namespace stig::cli {

namespace {

/// Adds a module after all that it requires. False where a file is missing.
bool add_module(std::string_view name, const App& app, std::vector<std::string>& begun,
                std::vector<std::string>& out) {
  // Begun is enough: what it requires is on its way into the list.
  if (std::find(begun.begin(), begun.end(), name) != begun.end()) return true;
  begun.emplace_back(name);
  auto module = read_module(name, app);
  if (!module) return false;
  const std::vector<std::string> required = required_names(*module);
  // all_of ends at the first that is missing; its message has been printed.
  const bool whole = std::all_of(required.begin(), required.end(), [&](const std::string& other) {
    return add_module(other, app, begun, out);
  });
  out.push_back(std::move(*module));
  return whole;
}

}  // namespace

std::optional<std::string> read_module(std::string_view name, const App& app) {
  FileError error;
  auto text = own_loader()(module_file(name), kMaxSceneBytes, error);
  if (!text) app.complain("the library of controllers is not complete: " + error.message);
  return text;
}

std::optional<std::vector<std::string>> read_runtime(const App& app) {
  std::vector<std::string> begun;
  std::vector<std::string> out;
  if (!add_module(kRuntimeRoot, app, begun, out)) return std::nullopt;
  return out;
}

}  // namespace stig::cli
