// SPDX-License-Identifier: MIT
// An order in which robots may build what was compiled, and how many of them have something to do
// on the way: by the very decisions that their program makes.
#pragma once

#include <vector>

#include "assembly/uses.h"
#include "compiler/compile.h"

namespace stig::assembly {

/// A brick that is put, and what else could have been.
struct WorkStep {
  Cell at;
  ApproachSide from{};
  std::size_t open = 0;  ///< sites that some robot could have filled at that moment, this one too
};

/// A run of compiled rules, from the start on: of what may be put, always the brick that comes
/// first in `liked`, a list of the structure's cells.
std::vector<WorkStep> work_of(const CompiledRules& compiled, const std::vector<Cell>& liked);

}  // namespace stig::assembly
