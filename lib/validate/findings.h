// SPDX-License-Identifier: MIT
// What went wrong in a run, and what blocks one that is not complete: sentences.
#pragma once

#include <string>
#include <vector>

#include "validate/trial.h"
#include "validate/uses.h"

namespace stig::validate {

/// None: nothing did.
std::vector<std::string> findings_of(const BuildTarget& target, const Trial& trial);

}  // namespace stig::validate
