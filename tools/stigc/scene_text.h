// SPDX-License-Identifier: MIT
// The text of a scene's file, changed in one place. A text that is no scene comes back as it is:
// whoever reads it says what is wrong.
#pragma once

#include <string>
#include <string_view>

#include "uses.h"

namespace stig::cli {

/// The same scene with this duration in s, whatever it had.
std::string with_duration(std::string text, double seconds);

/// The same scene with this key, where it does not have it. The value is plain in YAML.
std::string with_default(std::string text, std::string_view key, std::string_view value);

}  // namespace stig::cli
