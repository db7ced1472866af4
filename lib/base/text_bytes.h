// SPDX-License-Identifier: MIT
// Whether a file is text at all, asked before anything in it is read.
#pragma once

#include <string_view>

#include "base/diagnostic.h"

namespace stig {

/// That some editors put before UTF-8; no part of what a file says.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A control character other than tab and line ends (R003) or a byte that is not UTF-8 (R004), the
/// first alone, is reported.
bool is_text(const SourceRef& source, Diagnostics& diagnostics);

}  // namespace stig
