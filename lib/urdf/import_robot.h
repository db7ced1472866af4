// SPDX-License-Identifier: MIT
// Robots and worlds in URDF and SDF, as robot and scene files. docs/robots.md says what goes over.
//
// URDF has links of any mass and shape on joints; SDF worlds besides, with sensors and drives,
// which URDF borrows. What cannot be said here is a diagnostic: an error (F432) where the robot
// would be another without it, otherwise a warning (F433). No mesh is read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "urdf/uses.h"

namespace stig::urdf {

inline constexpr std::size_t kMaxDescriptionBytes = std::size_t{1} << 20;

struct ImportedFile {
  std::string name;  ///< without a folder
  std::string text;
};

struct ImportedDescription {
  bool scene = false;  ///< otherwise a robot
  std::string text;
  std::vector<ImportedFile> parts;  ///< robots and blocks of a scene, which names them
};

/// Does it begin as XML does?
bool is_description(std::string_view text);

/// `stem` begins the names of a scene's parts. Nothing when an error was reported.
std::optional<ImportedDescription> import_description(const SourceRef& source,
                                                      const std::string& stem,
                                                      Diagnostics& diagnostics);

}  // namespace stig::urdf
