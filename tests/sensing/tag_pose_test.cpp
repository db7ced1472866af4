// SPDX-License-Identifier: MIT
#include "sensing/tag_pose.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "support.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr double kSide = 0.024;
constexpr double kSigma = 0.5;  ///< px

using Six = std::array<double, 6>;
using Square = std::array<Six, 6>;

/// A tag turned a little by v's first half and moved by its second, camera frame.
Pose nudged(const Pose& X_CT, const Six& v) {
  return {X_CT.p + Vec3{v[3], v[4], v[5]}, rotation({v[0], v[1], v[2]}) * X_CT.q};
}
Six difference(const Pose& from, const Pose& to) {
  Quat turn = to.q * conjugate(from.q);
  if (turn.w < 0) turn = {-turn.w, -turn.x, -turn.y, -turn.z};
  const Vec3 axis{turn.x, turn.y, turn.z};
  const double sine = length(axis);
  const Vec3 t = sine > 0 ? axis * (2 * std::atan2(sine, turn.w) / sine) : Vec3{};
  const Vec3 p = to.p - from.p;
  return {t.x, t.y, t.z, p.x, p.y, p.z};
}

/// Inverse by elimination; of well-behaved matrices.
Square inverse_of(Square a) {
  Square b{};
  for (std::size_t i = 0; i < 6; ++i) b[i][i] = 1;
  for (std::size_t i = 0; i < 6; ++i) {
    const double pivot = a[i][i];
    for (std::size_t j = 0; j < 6; ++j) a[i][j] /= pivot, b[i][j] /= pivot;
    for (std::size_t r = 0; r < 6; ++r) {
      if (r == i) continue;
      const double f = a[r][i];
      for (std::size_t j = 0; j < 6; ++j) a[r][j] -= f * a[i][j], b[r][j] -= f * b[i][j];
    }
  }
  return b;
}

/// Least covariance that any unbiased estimator can have with pixel noise `sigma` (Cramér and
/// Rao), from numeric derivatives of the projection.
Square least_covariance(const CameraIntrinsics& camera, const Pose& X_CT, double sigma) {
  constexpr double kStep = 1e-6;
  std::array<std::array<double, 8>, 6> slope{};
  for (std::size_t k = 0; k < 6; ++k) {
    Six step{};
    step[k] = kStep;
    const auto ahead = corners_of(camera, nudged(X_CT, step), kSide);
    step[k] = -kStep;
    const auto behind = corners_of(camera, nudged(X_CT, step), kSide);
    for (std::size_t i = 0; i < 4; ++i) {
      slope[k][2 * i] = (ahead[i].x - behind[i].x) / (2 * kStep);
      slope[k][2 * i + 1] = (ahead[i].y - behind[i].y) / (2 * kStep);
    }
  }
  Square information{};
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < 6; ++b) {
      for (std::size_t i = 0; i < 8; ++i) {
        information[a][b] += slope[a][i] * slope[b][i] / (sigma * sigma);
      }
    }
  }
  return inverse_of(information);
}

double gauss(Random& random) {
  const double r = std::sqrt(-2 * std::log(1 - random.unit()));
  return r * std::cos(2 * std::numbers::pi * random.unit());
}

/// Estimates of one view with noisy corners.
std::vector<TagPose> estimates(const CameraIntrinsics& camera, const Pose& X_CT, int count) {
  std::vector<TagPose> out;
  for (int i = 0; i < count; ++i) {
    Random random(7, 0, Purpose::test, 0, std::uint64_t(i));
    auto corners = corners_of(camera, X_CT, kSide);
    for (ImagePoint& c : corners) c = {c.x + kSigma * gauss(random), c.y + kSigma * gauss(random)};
    const auto pose = estimate_tag_pose(camera, corners, kSide);
    REQUIRE(pose);
    out.push_back(*pose);
  }
  return out;
}

}  // namespace

TEST_CASE("exact corners give the exact pose, whatever the view and the distortion") {
  CHECK(rc::check("pose from projected corners", [] {
    const CameraIntrinsics camera = some_camera();
    const double z = value_in(0.05, 0.5);
    const Pose X_CT = tag_before({0.25 * z * unit_value(), 0.15 * z * unit_value(), z},
                                 value_in(0, 75) * kDegree, 3.2 * unit_value(), 3.2 * unit_value());
    const auto pose = estimate_tag_pose(camera, corners_of(camera, X_CT, kSide), kSide);
    RC_ASSERT(pose.has_value());
    RC_ASSERT(pose->error < 1e-8);
    RC_ASSERT(pose->other_error >= pose->error);
    RC_ASSERT(length(pose->X_CT.p - X_CT.p) < 1e-7);
    RC_ASSERT(turn_between(pose->X_CT, X_CT) < 1e-5);
    const auto centre = project(camera, X_CT.p);
    RC_ASSERT(std::hypot(pose->centre.x - centre->x, pose->centre.y - centre->y) < 1e-7);
  }));
}

TEST_CASE("a frontal tag, where both solutions are one, is exact too") {
  const CameraIntrinsics camera = paper_camera();
  for (const double x : {0.0, 0.03}) {
    const Pose X_CT = tag_before({x, 0, 0.3}, 0, 0, 0.4);
    const auto pose = estimate_tag_pose(camera, corners_of(camera, X_CT, kSide), kSide);
    REQUIRE(pose);
    CHECK(length(pose->X_CT.p - X_CT.p) < 1e-7);
    CHECK(turn_between(pose->X_CT, X_CT) < 1e-5);
  }
}

TEST_CASE("with half a pixel of noise the errors are the least that is possible") {
  CameraIntrinsics bent = paper_camera();
  bent.k1 = -0.2;
  bent.k2 = 0.05;
  for (const CameraIntrinsics& camera : {paper_camera(), bent}) {
    // Near and tilted: the mirrored solution never wins.
    const Pose X_CT = tag_before({0.01, -0.01, 0.12}, 45 * kDegree, 0.5, 0.3);
    constexpr int kCount = 2000;
    Six mean{}, square{};
    double error = 0;
    for (const TagPose& pose : estimates(camera, X_CT, kCount)) {
      const Six d = difference(X_CT, pose.X_CT);
      for (std::size_t k = 0; k < 6; ++k)
        mean[k] += d[k] / kCount, square[k] += d[k] * d[k] / kCount;
      error += pose.error * pose.error / kCount;
    }
    const Square least = least_covariance(camera, X_CT, kSigma);
    for (std::size_t k = 0; k < 6; ++k) {
      CAPTURE(k);
      CHECK(std::sqrt(square[k] / least[k][k]) == doctest::Approx(1).epsilon(0.1));
      CHECK(std::abs(mean[k]) < 0.2 * std::sqrt(least[k][k]));  // next to no bias
    }
    // Eight numbers less six unknowns leave two of noise, spread over four corners.
    CHECK(error == doctest::Approx(2 * kSigma * kSigma / 4).epsilon(0.1));
  }
}

TEST_CASE("far away and nearly frontal, noise makes the mirrored solution win at times") {
  const Pose X_CT = tag_before({0, 0, 0.45}, 20 * kDegree, 0, 0);
  int wrong = 0;
  for (const TagPose& pose : estimates(paper_camera(), X_CT, 500)) {
    const double other = turn_between(pose.X_CT_other, X_CT);
    if (other < turn_between(pose.X_CT, X_CT)) ++wrong;
    CHECK(std::min(other, turn_between(pose.X_CT, X_CT)) < 30 * kDegree);
    CHECK(std::abs(length(pose.X_CT.p) - 0.45) < 0.03);  // the place is right either way
  }
  CHECK(wrong > 25);
  CHECK(wrong < 250);
}

TEST_CASE("no pose is made up from degenerate corners") {
  const CameraIntrinsics camera = paper_camera();
  using Corners = std::array<ImagePoint, 4>;
  const auto refused = [&](const Corners& c) { return !estimate_tag_pose(camera, c, kSide); };
  const Corners good = {{{300, 200}, {340, 200}, {340, 160}, {300, 160}}};
  CHECK(!refused(good));
  CHECK(!estimate_tag_pose(camera, good, 0));
  CHECK(!estimate_tag_pose(camera, good, NAN));
  CHECK(refused({{{300, 160}, {340, 160}, {340, 200}, {300, 200}}}));  // from behind
  CHECK(refused({{{300, 200}, {340, 200}, {300, 160}, {340, 160}}}));  // crossed
  CHECK(refused({{{300, 200}, {340, 200}, {315, 185}, {300, 160}}}));  // dented
  CHECK(refused({{{300, 200}, {300, 200}, {340, 160}, {300, 160}}}));  // two in one
  CHECK(refused({{{300, 200}, {320, 200}, {340, 200}, {360, 200}}}));  // in a line
  CHECK(refused({{{300, 200}, {300, 200}, {300, 200}, {300, 200}}}));
  CHECK(refused({{{300, NAN}, {340, 200}, {340, 160}, {300, 160}}}));
  CHECK(refused({{{300, 1e300}, {340, 200}, {340, 160}, {300, 160}}}));
}
