// SPDX-License-Identifier: MIT
// What a structure would fall into without one of its bricks.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "assembly/uses.h"
#include "compiler/target_bricks.h"

namespace stig::assembly {

/// All bricks numbered anew, such that parts are ranges of numbers.
struct Parts {
  /// By new number: the brick. The root's is 0; what does not hang together with it is left out.
  std::vector<std::uint32_t> order;
  /// By brick: ranges of new numbers, without their ends. Each is a part that without the brick no
  /// longer hangs together, face to face, with the root or with any of the others.
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> beyond;
};

/// In time linear in the bricks.
Parts parts_from(const TargetBricks& target, std::uint32_t root);

}  // namespace stig::assembly
