// SPDX-License-Identifier: MIT
// What would help where no rules were found for a target: each thing is tried before it is named.
#pragma once

#include <string>
#include <vector>

#include "assembly/assemble.h"
#include "assembly/uses.h"

namespace stig::assembly {

struct AssemblyRemedy {
  std::string what;         ///< "without the brick at (1, 1, 1)"
  bool any_number = false;  ///< of robots may work at once then
};

/// Another robot that could be had.
struct OtherRobot {
  std::string name;
  Abilities abilities;
};

/// A few, found with some of the effort for each; none: nothing that was tried does.
std::vector<AssemblyRemedy> find_remedies(const AssemblyTask& task, const Assembly& made,
                                          const std::vector<OtherRobot>& others, double effort,
                                          const AssemblyHooks& hooks);

}  // namespace stig::assembly
