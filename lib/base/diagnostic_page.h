// SPDX-License-Identifier: MIT
// docs/diagnostics.md, generated from diagnostics.def; a test keeps both alike.
#pragma once

#include <string>

namespace stig {

/// The page in Markdown: every code with its meaning, by group.
std::string diagnostics_markdown();

}  // namespace stig
