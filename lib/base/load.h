// SPDX-License-Identifier: MIT
// A file that a user named, as source text: what every reader of files begins with.
#pragma once

#include <cstddef>
#include <string>

#include "base/diagnostic.h"

namespace stig {

/// The file's text; "-" is standard input and shown as <stdin>. Null with R001 (cannot be
/// read) or R002 (larger than `most` bytes) reported.
SourceRef load_source(const std::string& path, std::size_t most, Diagnostics& diagnostics);

}  // namespace stig
