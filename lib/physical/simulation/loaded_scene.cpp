// SPDX-License-Identifier: MIT
// The other files are found by the names that the scene calls them by, in memory alone.
#include "physical/simulation/loaded_scene.h"

namespace stig::physics {

std::optional<LoadedScene> load_scene(const std::vector<SceneFile>& files, std::uint64_t seed,
                                      Diagnostics& diagnostics) {
  if (files.empty()) {
    diagnostics.add(Code::F480, {}, "the file holds no scene");
    return std::nullopt;
  }
  const auto source = std::make_shared<const SourceFile>(files[0].name, files[0].text);
  auto scene = read_scene(source, memory_loader({files.begin() + 1, files.end()}), diagnostics);
  if (!scene) return std::nullopt;
  auto placed = place_scene(*scene, seed, diagnostics);
  if (!placed) return std::nullopt;
  return LoadedScene{std::move(*scene), std::move(*placed)};
}

}  // namespace stig::physics
