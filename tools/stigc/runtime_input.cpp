// SPDX-License-Identifier: MIT
#include "runtime_input.h"

#include "base/file_io.h"
#include "scene_input.h"

namespace stig {

std::optional<RuntimeModule> read_module(std::string_view name, const App& app) {
  FileError error;
  auto text = own_loader()(std::string(name) + ".lua", kMaxSceneBytes, error);
  if (text) return RuntimeModule{std::string(name), std::move(*text)};
  app.complain("the library of controllers is not complete: " + error.message);
  return std::nullopt;
}

std::optional<std::vector<RuntimeModule>> read_runtime(const App& app) {
  std::vector<RuntimeModule> out;
  for (const std::string_view name : kRuntimeModules) {
    auto module = read_module(name, app);
    if (!module) return std::nullopt;
    out.push_back(std::move(*module));
  }
  return out;
}

}  // namespace stig
