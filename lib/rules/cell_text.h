// SPDX-License-Identifier: MIT
// How messages and reports write a cell.
#pragma once

#include <string>

#include "rules/cell.h"

namespace stig::rules {

/// "(1, 0, 2)"
std::string cell_text(Cell cell);

}  // namespace stig::rules
