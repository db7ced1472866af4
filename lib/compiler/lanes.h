// SPDX-License-Identifier: MIT
// Lanes as sets of bricks, kept once they are known.
#pragma once

#include <array>

#include "compiler/approach.h"
#include "compiler/uses.h"

namespace stig::compiler {

class Lanes {
 public:
  /// Both must outlive it.
  Lanes(const TargetBricks& target, const Abilities& robot) : target_(target), robot_(robot) {
    for (std::vector<BrickSet>& one : known_) one.assign(target.bricks(), BrickSet(0));
  }

  /// What stands in the lane to a brick's cell.
  const BrickSet& to(std::uint32_t brick, ApproachSide side) {
    BrickSet& lane = known_[static_cast<std::size_t>(side)][brick];
    if (lane == BrickSet(0)) lane = lane_to(target_, target_.cell(brick), side, robot_);
    return lane;
  }

 private:
  const TargetBricks& target_;
  const Abilities& robot_;
  std::array<std::vector<BrickSet>, kAllSides.size()> known_;
};

}  // namespace stig::compiler
