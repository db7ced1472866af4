// SPDX-License-Identifier: MIT
// A scene of the user's becomes one for a validation by two keys, as a user would add them: the
// controller, and a duration that is enough. They are added to the text and not to what
// was read, since the text is what traces carry.
#include "given_scene.h"

#include <fmt/format.h>

#include "base/file_io.h"
#include "base/load.h"
#include "scene_text.h"
#include "validate/set_up.h"

namespace stig::cli {
namespace {

/// Does the scene, as it was written, ask for a file with the compiled program's name? By reading
/// the scene with a loader that listens.
bool asks_for_controller(const SourceRef& scene, const SceneLoader& load) {
  bool asked = false;
  const SceneLoader listening = [&](const std::string& name, std::size_t most, FileError& error) {
    asked = asked || name == kControllerFile;
    return load(name, most, error);
  };
  Diagnostics ignored;
  read_scene(scene, listening, ignored);
  return asked;
}

}  // namespace

std::optional<std::string> given_scene(const std::string& path, const App& app) {
  FileError error;
  auto text = read_file(path, kMaxSceneBytes, error);
  if (!text) {
    app.complain(error.message);
    return std::nullopt;
  }
  if (!text->ends_with('\n')) *text += '\n';
  return with_default(with_default(std::move(*text), "robot_program", kControllerFile), "duration",
                      fmt::format("{:g}", kMostBuildTime));
}

bool controller_name_is_free(const std::string& path, const std::string& compiled,
                             const SceneLoader& load, const App& app) {
  FileError ignored;
  const auto found = load(std::string(kControllerFile), kMaxSceneBytes, ignored);
  // Not found, or left by an earlier validation: no danger of a mix-up.
  if (!found || *found == compiled) return true;
  Diagnostics unread;
  const SourceRef scene = load_source(path, kMaxSceneBytes, unread);
  if (!scene || !asks_for_controller(scene, load)) return true;
  app.complain(fmt::format(
      "'{}' asks for '{}', which is the name of the compiled controller, and another file has it\n"
      "rename that file to have it run; take it away to have the compiled controller run",
      printable(path), kControllerFile));
  return false;
}

}  // namespace stig::cli
