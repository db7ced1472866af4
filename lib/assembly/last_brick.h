// SPDX-License-Identifier: MIT
// Can a brick have been put last? Asked again and again of fewer and fewer bricks, so what is known
// is kept.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assembly/uses.h"
#include "compiler/approach.h"

namespace stig::assembly {

/// Who builds: what a robot can do, and from which sides it works.
struct Builders {
  Abilities robot;
  std::vector<ApproachSide> sides;
};

/// From where the brick can be put when the others of `state` stand, next to some column. Where it
/// cannot, and bricks in the way are why from every side, `obstacles` gets such bricks: as long as
/// all of them stand, whatever else does, it cannot be put.
std::optional<ApproachSide> side_for(const TargetBricks& target, const BrickSet& state,
                                     std::uint32_t brick, const Builders& builders,
                                     std::vector<std::uint32_t>* obstacles = nullptr);

/// Which bricks hang together face to face.
class Connected {
 public:
  /// The target must outlive it.
  explicit Connected(const TargetBricks& target);

  /// Do these hang together, with `removed` just taken from bricks that did?
  bool without(const BrickSet& left, std::uint32_t removed);

 private:
  bool all_of(const BrickSet& left);
  bool about(const BrickSet& left, Cell middle) const;

  const TargetBricks& target_;
  bool whole_ = false;  ///< does the whole target?
  std::vector<std::uint32_t> edge_;
};

}  // namespace stig::assembly
