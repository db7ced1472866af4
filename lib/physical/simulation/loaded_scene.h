// SPDX-License-Identifier: MIT
// A scene from texts kept in a trace or a checkpoint, read and placed.
#pragma once

#include <optional>
#include <vector>

#include "physical/scene/scene.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct LoadedScene {
  Scene scene;
  PlacedScene placed;
};

/// The scene's own text comes first.
std::optional<LoadedScene> load_scene(const std::vector<SceneFile>& files, std::uint64_t seed,
                                      Diagnostics& diagnostics);

}  // namespace stig::physics
