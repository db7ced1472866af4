// SPDX-License-Identifier: MIT
#include "physical/sensors/place_index.h"
#include "support/uses.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

using namespace stig;

namespace {

Bounds some_bounds(double spread, double size) {
  const auto value = [] { return *rc::gen::inRange(-1000, 1001) * 1e-3; };
  const Vec3 p = Vec3{value(), value(), value()} * spread;
  const Vec3 h = Vec3{std::abs(value()), std::abs(value()), std::abs(value())} * size;
  return {p - h, p + h};
}

}  // namespace

TEST_CASE("the index finds what overlaps, no more and no less") {
  CHECK(rc::check("as asking each", [] {
    std::vector<Bounds> all;
    for (int i = 0; i < 60; ++i) all.push_back(some_bounds(1, *rc::gen::element(0.0, 0.1, 3.0)));
    const PlaceIndex index(all, 0.12);
    for (const double size : {0.0, 0.05, 0.5, 1e7}) {
      const Bounds where = some_bounds(1, size);
      std::vector<std::uint32_t> found{99}, expected;
      index.find(where, found);
      for (std::uint32_t i = 0; i < all.size(); ++i) {
        if (overlap(all[i], where)) expected.push_back(i);
      }
      RC_ASSERT(found == expected);
    }
  }));
}

TEST_CASE("places beyond all measure and empty indices are no trouble") {
  const Bounds far{{1e300, -1e300, 0}, {1e300, -1e300, 1}};
  const PlaceIndex index({far}, 0.1);
  std::vector<std::uint32_t> found;
  index.find({{0, 0, 0}, {1, 1, 1}}, found);
  CHECK(found.empty());
  index.find(far, found);
  CHECK(found == std::vector<std::uint32_t>{0});
  index.find({{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}}, found);
  CHECK(found.size() == 1);
  PlaceIndex().find(far, found);
  CHECK(found.empty());
}

TEST_CASE("bounds of a turned box hold its corners, and touch them") {
  const Pose X{{1, 2, 3}, rotation({0, 0, 0.7853981633974483})};
  const Bounds b = bounds_of(X, {1, 1, 2});
  CHECK(b.high.x == doctest::Approx(1 + std::sqrt(2)));
  CHECK(b.low.y == doctest::Approx(2 - std::sqrt(2)));
  CHECK(b.high.z == doctest::Approx(5));
}
