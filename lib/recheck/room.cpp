// SPDX-License-Identifier: MIT
// A robot drives up along its row with the block before it, and leaves by the same way: whatever
// stands there on any level is in its way, since lift and camera are higher than what it builds.
#include "recheck/room.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace stig::recheck {

bool Room::in_lane(const Seen& site, const Seen& brick) const {
  const int across = std::abs(brick.v - site.v), before = brick.u - site.u;
  if (before > 0 && across == 0 && brick.z >= site.z) return true;  // there the block comes along
  // The body stays behind the block's near face by so much.
  const double gap = robot_.carried_x - robot_.side / 2 - robot_.body_front;
  const int free = static_cast<int>(std::floor(std::max(0.0, gap) / robot_.side));
  return across <= robot_.rows_beside() && before > free;
}

bool Room::behind(const Seen& site, const Seen& brick) const {
  // From the site's middle to the brick's near face; the robot's middle is carried_x from there.
  return (brick.u - site.u) * robot_.side - robot_.side / 2 >= robot_.carried_x + robot_.body_back;
}

const Bricks& Room::lane(int side, const Seen& site) {
  const auto [known, added] = lanes_.try_emplace({side, site}, whole_.size());
  if (added) {
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      if (in_lane(site, whole_.seen(side, i))) known->second.add(i);
    }
  }
  return known->second;
}

std::string Room::obstacle(std::uint32_t brick, int side, const Range& there) {
  const Seen site = whole_.seen(side, brick);
  const auto may_stand = [&](int du, int dv, int dz) {
    const std::uint32_t one = whole_.at(side, {site.u + du, site.v + dv, site.z + dz});
    return one != kNoBrick && there.maybe.has(one);
  };
  if (!robot_.reaches(site.z)) return "the lift does not reach so high";
  if (there.maybe.meets(lane(side, site))) return "a brick may stand in the robot's lane";
  if (may_stand(0, 0, 1)) return "a brick may lie over the site";
  if (may_stand(0, 1, 0) && may_stand(0, -1, 0)) return "the site may be a slot between two bricks";
  if (std::string problem = at_effector(site, side, there); !problem.empty()) return problem;
  for (int z = 0; z < site.z; ++z) {
    const std::uint32_t one = whole_.at(side, {site.u, site.v, z});
    if (one == kNoBrick || !there.sure.has(one)) {
      return "not all below it is certain to stand, and what hangs on magnets is not certified";
    }
  }
  return {};
}

/// The end-effector lies on the block and sticks out ahead and to both sides. Straight ahead it
/// stops at a brick; magnets close what gap that leaves, if it is small.
std::string Room::at_effector(const Seen& site, int side, const Range& there) const {
  const auto brick = [&](int du, int dv) {
    return whole_.at(side, {site.u + du, site.v + dv, site.z + 1});
  };
  const auto in = [](const Bricks& some, std::uint32_t one) {
    return one != kNoBrick && some.has(one);
  };
  const double half = robot_.side / 2;
  const double ahead = robot_.effector_front - robot_.carried_x - half;
  const double beside = robot_.effector_half_width - half;
  const std::uint32_t stop = brick(-1, 0);
  if (ahead > robot_.magnets_close && in(there.maybe, stop)) {
    return "the end-effector may leave a gap that magnets do not close";
  }
  if (beside <= 0) return {};
  const bool stopped = ahead <= 0 || in(there.sure, stop);
  for (const int dv : {-1, 1}) {
    if (in(there.maybe, brick(0, dv)) || (!stopped && in(there.maybe, brick(-1, dv)))) {
      return "the end-effector may meet a brick beside the site";
    }
  }
  return {};
}

}  // namespace stig::recheck
