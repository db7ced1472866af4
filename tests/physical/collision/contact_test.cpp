// SPDX-License-Identifier: MIT
#include "physical/collision/contact.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

#include "physical/touch_oracle.h"
#include "support/draws.h"
#include "support/uses.h"

using namespace stig;

namespace {

Placed cube_at(const Vec3& p, const Vec3& turn = {}) {
  return {Shape::box({2, 2, 2}), p, matrix(normalised(rotation(turn)))};
}
Placed ball_at(const Vec3& p) { return {Shape::sphere(1), p, {}}; }

}  // namespace

TEST_CASE("two cubes, face to face: four corners of the common face") {
  const Touch t = touch(cube_at({1, 0.5, 2.1}), cube_at({}), 0.2);
  CHECK(t.count == 4);
  CHECK(length(t.normal - Vec3{0, 0, 1}) < 1e-12);
  double low_x = 9, high_x = -9, low_y = 9, high_y = -9;
  for (const TouchPoint& point : t.points) {
    CHECK(point.gap == doctest::Approx(0.1));
    CHECK(point.p.z == doctest::Approx(1.05));
    low_x = std::min(low_x, point.p.x), high_x = std::max(high_x, point.p.x);
    low_y = std::min(low_y, point.p.y), high_y = std::max(high_y, point.p.y);
  }
  CHECK(low_x == doctest::Approx(0));
  CHECK(high_x == doctest::Approx(1));
  CHECK(low_y == doctest::Approx(-0.5));
  CHECK(high_y == doctest::Approx(1));
  CHECK(touch(cube_at({1, 0.5, 2.1}), cube_at({}), 0.05).count == 0);
}

TEST_CASE("a cube turned upon another keeps four points that carry it") {
  const Touch t = touch(cube_at({0, 0, 2}, {0, 0, 0.7}), cube_at({}), 0.01);
  REQUIRE(t.count == 4);
  Vec3 middle;
  for (const TouchPoint& point : t.points) middle += point.p * 0.25;
  CHECK(std::abs(middle.x) < 0.5);
  CHECK(std::abs(middle.y) < 0.5);
}

TEST_CASE("edges that cross meet in a point") {
  const double d = 2 * std::sqrt(2.0);
  const Touch t =
      touch(cube_at({0, 0, d - 0.01}, {0.785398163, 0, 0}), cube_at({}, {0, 0.785398163, 0}), 0.1);
  REQUIRE(t.count == 1);
  CHECK(length(t.normal - Vec3{0, 0, 1}) < 1e-6);
  CHECK(t.points[0].gap == doctest::Approx(-0.01).epsilon(1e-3));
  CHECK(length(t.points[0].p - Vec3{0, 0, d / 2 - 0.005}) < 1e-6);
}

TEST_CASE("a touch says the same from the other side") {
  CHECK(rc::check("boxes swapped", [] {
    const Placed a = cube_at({unit_value() * 2, unit_value() * 2, unit_value() * 2},
                             {unit_value(), unit_value(), unit_value()});
    const Placed b = cube_at({}, {unit_value(), unit_value(), unit_value()});
    const Touch one = touch(a, b, 0.3), other = touch(b, a, 0.3);
    RC_ASSERT((one.count == 0) == (other.count == 0));
    if (one.count == 0) return;
    // Faces may tie within the preference; depths then agree within it too.
    RC_ASSERT(std::abs(deepest(one) - deepest(other)) < 0.3);
  }));
}

TEST_CASE("no direction parts two boxes farther than the one found") {
  CHECK(rc::check("against many directions", [] {
    const Vec3 at{unit_value() * 3, unit_value() * 3, unit_value() * 3};
    const Placed a = cube_at(at, {unit_value(), unit_value(), unit_value()});
    const Placed b = cube_at({}, {unit_value(), unit_value(), unit_value()});
    const double separation = sampled_separation(a, b);
    const Touch t = touch(a, b, 0.01);
    // The samples lie up to 3 degrees beside the best direction.
    if (separation > 0.011) RC_ASSERT(t.count == 0);
    if (separation < -0.4) RC_ASSERT(t.count > 0);
    if (t.count > 0) RC_ASSERT(std::abs(length(t.normal) - 1) < 1e-9);
    for (int i = 0; i < t.count; ++i) {
      const TouchPoint& point = t.points[static_cast<std::size_t>(i)];
      RC_ASSERT(point.gap < 0.01);
      // Half the gap from either surface: on or in both cubes, grown by that.
      const double most = 1.001 + std::abs(point.gap) / 2;
      for (const Placed* box : {&a, &b}) {
        const Vec3 c = box->r.transposed(point.p - box->p);
        RC_ASSERT(std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) <= most);
      }
    }
  }));
}

TEST_CASE("balls") {
  const Touch t = touch(ball_at({0, 3, 0}), ball_at({0, 1.1, 0}), 0.1);
  REQUIRE(t.count == 1);
  CHECK(length(t.normal - Vec3{0, 1, 0}) < 1e-12);
  CHECK(t.points[0].gap == doctest::Approx(-0.1));
  CHECK(length(t.points[0].p - Vec3{0, 2.05, 0}) < 1e-12);
  CHECK(touch(ball_at({}), ball_at({0, 0, 2.2}), 0.1).count == 0);
}

TEST_CASE("a ball against a cube's face, edge, and from inside") {
  const Touch face = touch(ball_at({0.3, 0, 2.05}), cube_at({}), 0.1);
  REQUIRE(face.count == 1);
  CHECK(length(face.normal - Vec3{0, 0, 1}) < 1e-12);
  CHECK(face.points[0].gap == doctest::Approx(0.05));
  const Touch edge = touch(cube_at({}), ball_at({1.6, 0, 1.6}), 0.1);
  REQUIRE(edge.count == 1);
  CHECK(length(edge.normal - normalised(Vec3{-1, 0, -1})) < 1e-12);
  CHECK(edge.points[0].gap == doctest::Approx(0.6 * std::sqrt(2.0) - 1));
  const Touch inside = touch(ball_at({0, -0.9, 0}), cube_at({}), 0.1);
  REQUIRE(inside.count == 1);
  CHECK(length(inside.normal - Vec3{0, -1, 0}) < 1e-12);
  CHECK(inside.points[0].gap == doctest::Approx(-1.1));
}

TEST_CASE("the floor") {
  const Touch flat = touch_floor(cube_at({5, 5, 1.001}), 0.01);
  CHECK(flat.count == 4);
  CHECK(flat.points[0].gap == doctest::Approx(0.001));
  CHECK(touch_floor(cube_at({5, 5, 1.02}), 0.01).count == 0);
  CHECK(touch_floor(cube_at({0, 0, std::sqrt(2.0)}, {0.785398163, 0, 0}), 0.01).count == 2);
  CHECK(touch_floor(cube_at({0, 0, -3}), 0.01).count == 4);
  CHECK(deepest(touch_floor(ball_at({0, 0, 0.9}), 0.01)) == doctest::Approx(-0.1));
}

TEST_CASE("a hull touches as the box of its corners does, wherever its origin is") {
  CHECK(rc::check([] {
    const Vec3 off{5 * unit_value(), 5 * unit_value(), 5 * unit_value()};
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
      corners.push_back(off + Vec3{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    }
    const Placed box = cube_at({2.2 * unit_value(), 2.2 * unit_value(), 2.2 * unit_value()},
                               Vec3{unit_value(), unit_value(), unit_value()});
    const Placed hull{Shape::hull(corners), box.p - box.r * off, box.r};
    const Placed can{
        Shape::cylinder(0.7, 1.5), {}, matrix(rotation({unit_value(), unit_value(), 0}))};
    for (const double margin : {0.001, 0.5}) {
      const Touch a = touch(box, can, margin), b = touch(hull, can, margin);
      RC_ASSERT((a.count > 0) == (b.count > 0));
      if (a.count == 0) continue;
      RC_ASSERT(std::abs(deepest(a) - deepest(b)) < 1e-9);
      const Touch c = touch(can, hull, margin);
      RC_ASSERT(std::abs(deepest(a) - deepest(c)) < 2e-4);  // faces are preferred by 0.1 mm
    }
  }));
}
