// SPDX-License-Identifier: MIT
// Golden files: printed forms that tests hold the program to, byte by byte. With the
// environment variable STIG_UPDATE_GOLDEN=1 they are written instead; look at what
// git says has changed before committing it.
#pragma once

#include <string>

#include "support/uses.h"

namespace stig {

/// Fails the running test when the text differs from the file, whose path is
/// relative to the project's root.
void check_golden(const std::string& path, const std::string& text);

/// The bytes of a file of the project; a missing one fails the test.
std::string project_file(const std::string& path);

}  // namespace stig
