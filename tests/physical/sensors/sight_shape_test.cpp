// SPDX-License-Identifier: MIT
#include "physical/sensors/sight_shape.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>

#include "support/draws.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// An octahedron, |x| + |y| + |z| <= r.
SightShape octahedron(double r) {
  std::vector<HalfSpace> planes;
  for (int i = 0; i < 8; ++i) {
    planes.push_back({{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0}, r});
  }
  return sight_hull(planes, {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}});
}

bool inside(const SightShape& s, const Vec3& p) {
  switch (s.type) {
    case ShapeType::box:
      return std::abs(p.x) <= s.half.x && std::abs(p.y) <= s.half.y && std::abs(p.z) <= s.half.z;
    case ShapeType::sphere:
      return length(p) <= s.half.x;
    case ShapeType::cylinder:
      return std::hypot(p.x, p.y) <= s.half.x && std::abs(p.z) <= s.half.z;
    case ShapeType::hull:
      return std::abs(p.x) + std::abs(p.y) + std::abs(p.z) <= s.half.x;
  }
  return false;
}

const std::array<SightShape, 4> kShapes = {sight_box({0.4, 0.6, 0.8}), sight_sphere(0.5),
                                           sight_cylinder(0.3, 0.9), octahedron(0.6)};

}  // namespace

TEST_CASE("a line is inside a shape just where its cut says") {
  CHECK(rc::check("points along the line", [] {
    const SightShape& shape = kShapes[*rc::gen::inRange<std::size_t>(0, 4)];
    const Vec3 o = some_vector();
    Vec3 d = some_vector();
    if (*rc::gen::inRange(0, 4) == 0) d = Vec3{0, 0, *rc::gen::element(1.0, -1.0)};
    RC_PRE(squared(d) > 1e-4);
    const auto meets = cut(shape, o, d);
    for (int i = -400; i <= 400; ++i) {
      const double t = i * 0.02 / length(d);
      const bool near_end =
          meets && (std::abs(t - meets->in) < 1e-6 || std::abs(t - meets->out) < 1e-6);
      if (near_end) continue;
      RC_ASSERT(inside(shape, o + d * t) == (meets && t > meets->in && t < meets->out));
    }
  }));
}

TEST_CASE("what touches as a box, a ball or a cylinder is met as one") {
  CHECK(sight_of(Shape::box({0.4, 0.6, 0.8})) == sight_box({0.4, 0.6, 0.8}));
  CHECK(sight_of(Shape::sphere(0.5)) == sight_sphere(0.5));
  CHECK(sight_of(Shape::cylinder(0.3, 0.9)) == sight_cylinder(0.3, 0.9));
  CHECK_FALSE(sight_of(Shape::cylinder(0.3, 0.9)) == sight_of(Shape::box({0.6, 0.6, 0.9})));
}

TEST_CASE("a hull of contacts is met just where it is solid") {
  // A corner cut off a cube: three faces along the axes and a slanted one.
  const SightShape corner = sight_of(
      Shape::hull({{-0.2, -0.2, -0.2}, {0.7, -0.2, -0.2}, {-0.2, 0.7, -0.2}, {-0.2, -0.2, 0.7}}));
  CHECK(corner.planes.size() == 4);
  CHECK(rc::check("points along the line", [&] {
    const Vec3 o = some_vector(), d = some_vector();
    RC_PRE(squared(d) > 1e-4);
    const auto meets = cut(corner, o, d);
    for (int i = -400; i <= 400; ++i) {
      const double t = i * 0.02 / length(d);
      const bool near_end =
          meets && (std::abs(t - meets->in) < 1e-6 || std::abs(t - meets->out) < 1e-6);
      if (near_end) continue;
      const Vec3 p = o + d * t;
      const bool solid = std::min({p.x, p.y, p.z}) >= -0.2 && p.x + p.y + p.z <= 0.3;
      RC_ASSERT(solid == (meets && t > meets->in && t < meets->out));
    }
  }));
}

TEST_CASE("cuts in numbers") {
  const auto meets = [](const SightShape& s, const Vec3& o, const Vec3& d, double in, double out) {
    const auto c = cut(s, o, d);
    REQUIRE(c);
    CHECK(c->in == doctest::Approx(in));
    CHECK(c->out == doctest::Approx(out));
  };
  for (const SightShape& s : {sight_box({2, 2, 2}), sight_sphere(1), sight_cylinder(1, 2)}) {
    meets(s, {-3, 0, 0}, {1, 0, 0}, 2, 4);
    meets(s, {0, 0, 0}, {0, 0, 2}, -0.5, 0.5);
    CHECK(!cut(s, {-3, 1.001, 0}, {1, 0, 0}));
    CHECK(!cut(s, {0, 0, 0}, {0, 0, 0}));
    CHECK(!cut(s, {0, 0, 0}, {NAN, 0, 0}));
  }
  meets(octahedron(1), {-3, 0, 0.5}, {1, 0, 0}, 2.5, 3.5);
  meets(sight_sphere(1), {-3, 1, 0}, {1, 0, 0}, 3, 3);  // touched counts
}
