// SPDX-License-Identifier: MIT
// Scenes and what belongs to them, found on the disk.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app.h"
#include "physical/simulation/loaded_scene.h"
#include "uses.h"

namespace stig::cli {

/// What a data file is, by its key stigc, stigc_scene, stigc_robot, stigc_block or stigc_solid.
enum class FileContent : std::uint8_t { rules, scene, robot, block, solid };
FileContent content_of(std::string_view text);

/// Finds blocks and robots beside the scene, in the folders blocks/ and robots/ next to the
/// scene's, and where the program's own are.
SceneLoader scene_loader(const std::string& scene_path);
/// The folders in which that looks, in their order.
std::vector<std::string> scene_folders(const std::string& scene_path);
/// Finds the program's own files alone.
SceneLoader own_loader();

/// Reads and places a scene; its errors are reported.
std::optional<LoadedScene> read_loaded_scene(const std::string& path,
                                             std::optional<std::uint64_t> seed, const App& app);

}  // namespace stig::cli
