// SPDX-License-Identifier: MIT
// Whether a file is text at all, asked before anything in it is read.
#pragma once

#include "base/diagnostic.h"

namespace stig {

/// A control character other than tab and line ends (R003) or a byte that is not UTF-8 (R004), the
/// first alone, is reported.
bool is_text(const SourceRef& source, Diagnostics& diagnostics);

}  // namespace stig
