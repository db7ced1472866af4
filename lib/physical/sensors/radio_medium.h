// SPDX-License-Identifier: MIT
// Near-field radios: a message reaches every other radio within the sender's range that is
// not itself sending (half duplex).
//
// Tick order: what controllers send in step k is carried at the end of k, and is what radios
// have received when step k + 1 reads them. Nothing is kept for longer.
#pragma once

#include <vector>

#include "physical/sensors/uses.h"
#include "robots/robot_io.h"

namespace stig::physics {

struct Radio {
  Vec3 p_W;
  double range = 0.02;  ///< m, of what it sends
};

/// What each radio hears: by sender in the order of radios, and of one sender as sent. `sends`
/// has an entry for each radio; one that sends nothing listens.
std::vector<std::vector<Message>> carry(const std::vector<Radio>& radios,
                                        const std::vector<std::vector<Message>>& sends);

}  // namespace stig::physics
