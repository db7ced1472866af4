// SPDX-License-Identifier: MIT
#include "validate/ideal_time.h"

#include <doctest/doctest.h>

#include "support/uses.h"

namespace stig {
namespace {

// Round figures: a second to reach the cruising speed, half a metre on the way.
const WorkSpeeds kSpeeds{1, 1, 0.1};

Haul haul(double from, const Vec3& taken, const Vec3& put, std::optional<Cell> placed) {
  Haul out;
  out.from = from;
  out.taken = taken;
  out.put = put;
  out.placed = placed;
  return out;
}

TEST_CASE("a straight way takes its length by the speed, and a ramp at both ends") {
  CHECK(straight_time(0, kSpeeds) == 0);
  CHECK(straight_time(0.25, kSpeeds) == doctest::Approx(1));
  // Both formulas meet where the cruising speed is reached for a moment.
  CHECK(straight_time(1, kSpeeds) == doctest::Approx(2));
  CHECK(straight_time(3, kSpeeds) == doctest::Approx(4));
}

TEST_CASE("the ideal of a brick is two ways, two pulses and what of the lift is no way") {
  const double down = kPassingHeight / kSpeeds.lift;
  const std::vector<Haul> one = {haul(5, {3, 0, 0}, {3, 4, 0}, Cell{0, 0, 0})};
  CHECK(ideal_time(one, 0, {0, 0, 1}, kSpeeds) ==
        doctest::Approx(4 + kAttachTime + 5 + down + kReleaseTime));
  // Lifted by a metre, for which the way of a quarter leaves no time.
  const std::vector<Haul> high = {haul(5, {0, 0, 0}, {0.25, 0, 1}, Cell{0, 0, 1})};
  CHECK(ideal_time(high, 0, {0, 0, 1}, kSpeeds) ==
        doctest::Approx(kAttachTime + 10 + 2 * down + kReleaseTime));
}

TEST_CASE("the next way begins where the last block was let go of") {
  const double rest = kAttachTime + kPassingHeight / kSpeeds.lift + kReleaseTime;
  std::vector<Haul> hauls = {haul(0, {0, 0, 0}, {1, 0, 0}, Cell{0, 0, 0}),
                             haul(9, {1, 1, 0}, {1, 4, 0}, Cell{1, 0, 0})};
  CHECK(ideal_time(hauls, 0, {0, 0, 0}, kSpeeds) == doctest::Approx(0 + 2 + 2 + 4 + 2 * rest));
  // What another robot brings, or nobody's brick became, counts for nothing.
  hauls.push_back(haul(20, {9, 9, 0}, {0, 9, 0}, std::nullopt));
  hauls.push_back(haul(30, {9, 9, 0}, {0, 9, 0}, Cell{2, 0, 0}));
  hauls.back().robot = 1;
  CHECK(ideal_time(hauls, 0, {0, 0, 0}, kSpeeds) == doctest::Approx(8 + 2 * rest));
  // Of two bricks in one cell the one that stands.
  hauls.push_back(haul(40, {1, 0, 0}, {1, 3, 0}, Cell{1, 0, 0}));
  CHECK(ideal_time(hauls, 0, {0, 0, 0}, kSpeeds) == doctest::Approx(0 + 2 + 0 + 4 + 2 * rest));
}

TEST_CASE("a robot without drive or lift has no ideal") {
  CHECK(work_speeds(RobotModel{}).cruise == 0);
  const std::vector<Haul> one = {haul(5, {3, 0, 0}, {3, 4, 0}, Cell{0, 0, 0})};
  CHECK(ideal_time(one, 0, {0, 0, 1}, work_speeds(RobotModel{})) == 0);
}

}  // namespace
}  // namespace stig
