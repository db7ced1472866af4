// SPDX-License-Identifier: MIT
#include "assembly/expected_time.h"
#include "support/uses.h"

#include <doctest/doctest.h>

namespace stig {
namespace {

TEST_CASE("the expected time counts no more robots than sites are open") {
  const std::vector<WorkStep> work = {{{}, {}, 1}, {{}, {}, 2}, {{}, {}, 4}, {{}, {}, 4}};
  CHECK(expected_seconds(work, 1) == doctest::Approx(4 * kSecondsOfBrick));
  CHECK(expected_seconds(work, 2) == doctest::Approx(2.5 * kSecondsOfBrick * kInEachOthersWay));
  CHECK(expected_seconds(work, 4) == doctest::Approx(2 * kSecondsOfBrick * kInEachOthersWay));
  CHECK(expected_seconds(work, 9) == expected_seconds(work, 4));
}

}  // namespace
}  // namespace stig
