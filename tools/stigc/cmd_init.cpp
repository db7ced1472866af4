// SPDX-License-Identifier: MIT
// stigc init: a project of the user's own.
//
// Nothing that is there is written over, not even the files of an earlier stigc init: they are the
// user's by now.
#include <fmt/format.h>

#include <filesystem>

#include "commands.h"
#include "outputs.h"
#include "project_files.h"

namespace stig::cli {

int run(const InitOptions& options, App& app) {
  const std::vector<ProjectFile> files = project_files();
  std::vector<std::string> paths;
  for (const ProjectFile& file : files) {
    paths.push_back((std::filesystem::path(options.folder) / file.name).string());
    std::error_code error;
    // A link that leads nowhere is there, too.
    if (!std::filesystem::exists(std::filesystem::symlink_status(paths.back(), error))) continue;
    app.complain(
        fmt::format("'{}' is there already: name a folder of its own", printable(paths.back())));
    return kUsage;
  }
  if (const int code = check_outputs(paths, app, options.folder); code != kOk) return code;
  if (const int code = make_folder(options.folder, app); code != kOk) return code;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (const int code = write_output(paths[i], files[i].text, app); code != kOk) return code;
  }
  app.say(fmt::format("'{}' says what to do with them", printable(paths.front())));
  return kOk;
}

}  // namespace stig::cli
