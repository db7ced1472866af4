// SPDX-License-Identifier: MIT
// Temporary files (file_io.h) of processes that ended without a word, as by kill -9.
#pragma once

#include <string>
#include <vector>

namespace stig {

/// Takes away those in the folder that were to become files of these names. One that a living
/// process writes stays: such a process has a lock on it, and its number is in the name.
void remove_left_behind(const std::string& folder, const std::vector<std::string>& names);

}  // namespace stig
