// SPDX-License-Identifier: MIT
// The user's scene, as validate runs it: robots without a program get the compiled one.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "physical/scene/scene.h"
#include "uses.h"

namespace stig::cli {

/// The scene's text with the compiled program for robots that have none; nothing when the file
/// cannot be read, which is then said.
std::optional<std::string> given_scene(const std::string& path, const App& app);

/// Is the compiled program's name free for it? Not where the scene asks for a file of this name
/// and finds another, which is then said: it would be left out without a word.
bool controller_name_is_free(const std::string& path, const std::string& compiled,
                             const SceneLoader& load, const App& app);

}  // namespace stig::cli
