// SPDX-License-Identifier: MIT
// The text of a scene's file, changed in one place.
#pragma once

#include <string>

namespace stig {

/// The same scene with this duration in s, whatever it had. A text that is no scene comes back as
/// it is: whoever reads it says what is wrong.
std::string with_duration(std::string text, double seconds);

}  // namespace stig
