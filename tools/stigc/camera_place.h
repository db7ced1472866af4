// SPDX-License-Identifier: MIT
// A robot's camera by its name on the command line, and what it sees.
#pragma once

#include <optional>
#include <string>

#include "physical/simulation/simulation.h"
#include "uses.h"

namespace stig::cli {

struct CameraPlace {
  std::size_t robot = 0, camera = 0;
};

/// The camera named ROBOT or ROBOT:CAMERA; the first camera of a robot when none is named.
std::optional<CameraPlace> camera_named(const Simulation& run, const std::string& name,
                                        std::string& problem);
/// A PNG file.
std::string view_png(const Simulation& run, const CameraPlace& place);

}  // namespace stig::cli
