// SPDX-License-Identifier: MIT
#include "assembly/expected_time.h"

#include <algorithm>
#include <cassert>

namespace stig::assembly {

double expected_seconds(const std::vector<WorkStep>& work, int robots) {
  assert(robots > 0);
  double bricks = 0;  // as many as one robot puts in that time
  for (const WorkStep& step : work) {
    const std::size_t at_work = std::min(step.open, static_cast<std::size_t>(robots));
    bricks += 1 / static_cast<double>(std::max<std::size_t>(at_work, 1));
  }
  return kSecondsOfBrick * bricks * (robots > 1 ? kInEachOthersWay : 1);
}

}  // namespace stig::assembly
