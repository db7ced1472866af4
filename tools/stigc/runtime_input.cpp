// SPDX-License-Identifier: MIT
#include "runtime_input.h"

#include "base/file_io.h"
#include "scene_input.h"

namespace stig {

std::optional<std::vector<RuntimeModule>> read_runtime(const App& app) {
  const SceneLoader load = own_loader();
  std::vector<RuntimeModule> out;
  for (const std::string_view name : kRuntimeModules) {
    FileError error;
    auto text = load(std::string(name) + ".lua", kMaxSceneBytes, error);
    if (!text) {
      app.complain("the library of controllers is not complete: " + error.message);
      return std::nullopt;
    }
    out.push_back({std::string(name), std::move(*text)});
  }
  return out;
}

}  // namespace stig
