// SPDX-License-Identifier: MIT
// Bad files say in comments what is wrong with them, on the line concerned:
// `# expect: R104 R105`. Inside a drawing a comment would be content, so
// `# expect@+2: R204` speaks of the second line after its own.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "support/uses.h"

namespace stig {

/// Line and code, for every diagnostic of a file.
using Findings = std::multiset<std::pair<std::size_t, std::string>>;

/// Names of the files in a folder of the project, sorted.
std::vector<std::string> bad_files(const std::string& folder);
/// What the comments of a file's text expect.
Findings expected(const std::string& text);
/// What was reported of it.
Findings found(const Diagnostics& diagnostics);

}  // namespace stig
