// SPDX-License-Identifier: MIT
// A scene of the user's becomes one for a validation by two lines at its end, as a user would add
// them: the controller, and a duration that is enough. They are added to the text and not to what
// was read, since the text is what traces carry.
#include "given_scene.h"

#include <fmt/format.h>

#include "base/file_io.h"
#include "base/load.h"
#include "validate/set_up.h"

namespace stig {
namespace {

/// Does a line begin with the key? As YAML has it at the top level of a file in block style; flow
/// style is not used for scenes.
bool has_key(std::string_view text, std::string_view key) {
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    if (at == 0 || text[at - 1] == '\n') return true;
  }
  return false;
}

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
  if (!has_key(*text, "robot_program:"))
    *text += fmt::format("robot_program: {}\n", kControllerFile);
  if (!has_key(*text, "duration:")) *text += fmt::format("duration: {:g}\n", kMostBuildTime);
  return text;
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

}  // namespace stig
