// SPDX-License-Identifier: MIT
// What is said where the parser gives up. It names the place where the text stops making
// sense, which is often a line or more below the slip; the slips that are made most are
// looked for above that place. Used by yaml.cpp.
#pragma once

#include <cstddef>
#include <string>

#include "base/diagnostic.h"

namespace stig {

/// Reports R006 at the byte `at`, for the reason that the parser gives in its own words.
void report_syntax(const SourceRef& source, std::size_t at, const std::string& reason,
                   Diagnostics& diagnostics);

}  // namespace stig
