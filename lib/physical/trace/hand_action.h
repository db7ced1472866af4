// SPDX-License-Identifier: MIT
// What somebody who looks at a run does to it by hand.
#pragma once

#include <cstdint>
#include <optional>

#include "base/vec.h"
#include "physical/trace/uses.h"

namespace stig::physics {

/// place: puts a block or a robot elsewhere, at rest. drop: a block of the scene's stock. halt: a
/// robot breaks down. mend: one that was halted goes on.
enum class HandKind : std::uint8_t { place, drop, halt, mend };

struct HandAction {
  HandKind kind = HandKind::place;
  bool robot = false;        ///< otherwise a block
  std::uint32_t number = 0;  ///< of the robot in its scene, or of the block's body
  Vec3 at;                   ///< m, of its own frame
  std::optional<Quat> turn;  ///< otherwise as it is
};

}  // namespace stig::physics
