// SPDX-License-Identifier: MIT
// What is written is read again first, a scene with its parts, so that nobody gets a file that the
// program would refuse.
#include "description_input.h"

#include <filesystem>

#include "outputs.h"
#include "physical/scene/scene.h"
#include "urdf/import_robot.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

bool stands(const ImportedDescription& imported, const App& app) {
  if (!imported.scene) return true;  // import_description has read it
  std::vector<SceneFile> files;
  for (const ImportedFile& part : imported.parts) files.push_back({part.name, part.text});
  Diagnostics diagnostics;
  const auto scene = read_scene(std::make_shared<SourceFile>("<imported scene>", imported.text),
                                memory_loader(std::move(files)), diagnostics);
  if (scene) place_scene(*scene, scene->seed, diagnostics);
  if (!app.invalid(diagnostics)) return true;
  app.report(diagnostics);
  return false;
}

/// Beside the scene.
std::vector<std::string> part_paths(const ImportedDescription& imported,
                                    const std::string& output) {
  std::vector<std::string> out;
  for (const ImportedFile& part : imported.parts) {
    out.push_back((fs::path(output).parent_path() / part.name).string());
  }
  return out;
}

}  // namespace

int import_described(const ImportOptions& options, const SourceRef& source, App& app) {
  const std::string stem = options.output ? fs::path(*options.output).stem().string() : "imported";
  Diagnostics diagnostics;
  const auto imported = import_description(source, stem, diagnostics);
  app.report(diagnostics);
  if (!imported || app.invalid(diagnostics) || !stands(*imported, app)) return kFailed;
  if (!options.output) {
    if (!imported->parts.empty()) {
      app.complain("a world has robots and blocks in files of their own: name the scene's with -o");
      return kUsage;
    }
    app.print(imported->text);
    return kOk;
  }
  std::vector<std::string> paths = part_paths(*imported, *options.output);
  paths.push_back(*options.output);
  if (const int code = check_outputs(paths, app); code != kOk) return code;
  for (std::size_t i = 0; i < imported->parts.size(); ++i) {
    const int code = write_output(paths[i], imported->parts[i].text, app);
    if (code != kOk) return code;
  }
  return write_output(*options.output, imported->text, app);
}

}  // namespace stig::cli
