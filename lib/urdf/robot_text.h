// SPDX-License-Identifier: MIT
// A description as the text of a robot file.
#pragma once

#include <string>

#include "urdf/description.h"
#include "urdf/uses.h"

namespace stig::urdf {

struct RobotText {
  std::string text;
  double lowest = 0;  ///< m, of its shapes in the model's frame: there its floor is
};

/// Of a description without frames; `source` is the file's name. The text is read again by the
/// robots' own reader; what that does not take is an error at the description's place.
RobotText robot_text(const Description& robot, const std::string& source, const Reading& reading);

}  // namespace stig::urdf
