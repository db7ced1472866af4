// SPDX-License-Identifier: MIT
#include "rules/cell_text.h"

#include <fmt/format.h>

namespace stig::rules {

std::string cell_text(Cell cell) { return fmt::format("({}, {}, {})", cell.x, cell.y, cell.z); }

}  // namespace stig::rules
