// SPDX-License-Identifier: MIT
// What pictures are taken of, as the command line says it. Each function returns the words of what
// is wrong, empty when the text is good.
#pragma once

#include <string>
#include <string_view>

#include "options.h"
#include "uses.h"

namespace stig::cli {

/// "iso", "front", "top", "orbit", or "X,Y,Z": the direction in which the camera is.
std::string parse_view(std::string_view text, RenderView& out);
/// "WxH": pixels.
std::string parse_pixels(std::string_view text, int& width, int& height);
/// "z=0..3", "x=..2" or "y=1..": both ends included, one may be left out.
std::string parse_slice(std::string_view text, Slice& out);

}  // namespace stig::cli
