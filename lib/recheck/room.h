// SPDX-License-Identifier: MIT
// Is there room for a robot to put a block, and is the block borne?
//
// Asked of all structures between two: bricks that are there for certain, and bricks that may be
// there. Each condition is taken where it is hardest.
#pragma once

#include <map>
#include <string>

#include "recheck/figures.h"
#include "recheck/uses.h"
#include "recheck/whole.h"

namespace stig::recheck {

struct Range {
  Bricks sure, maybe;  ///< all that is sure may be there
};

class Room {
 public:
  /// Both must outlive it.
  Room(const Whole& whole, const Figures& robot) : whole_(whole), robot_(robot) {}

  /// What keeps a block from this missing brick's cell; empty: nothing.
  std::string obstacle(std::uint32_t brick, int side, const Range& there);
  /// Does a brick there stand where the robot, its block or its way to the site would be?
  bool in_lane(const Seen& site, const Seen& brick) const;
  /// Does it stand behind the robot when that is at the site?
  bool behind(const Seen& site, const Seen& brick) const;
  /// All bricks in the lane to a place.
  const Bricks& lane(int side, const Seen& site);

 private:
  std::string at_effector(const Seen& site, int side, const Range& there) const;

  const Whole& whole_;
  const Figures& robot_;
  std::map<std::pair<int, Seen>, Bricks> lanes_;
};

}  // namespace stig::recheck
