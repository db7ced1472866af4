// SPDX-License-Identifier: MIT
// What stigc init writes: the files of a small project that work as they are and are meant to be
// changed.
#pragma once

#include <string>
#include <vector>

namespace stig::cli {

struct ProjectFile {
  std::string name;  ///< within the project's folder
  std::string text;
};

/// The files, README.md first; its indented lines are commands that run in the project's folder.
std::vector<ProjectFile> project_files();

}  // namespace stig::cli
