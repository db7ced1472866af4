// SPDX-License-Identifier: MIT
// Cylinders and hulls: their mass, where they touch the others, how they rest and roll.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numbers>

#include "physical/support.h"
#include "physical/touch_oracle.h"
#include "physical/trace/pose_trace.h"
#include "support/draws.h"
#include "support/uses.h"

using namespace stig;

namespace {

std::vector<Vec3> box_corners(const Vec3& half) {
  std::vector<Vec3> out;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) out.push_back(scaled({x, y, z}, half));
    }
  }
  return out;
}

/// Without centre of symmetry.
std::vector<Vec3> tetrahedron() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

Quat turn() { return normalised(rotation(some_vector() * 3.0)); }
Placed put(const Shape& shape, const Vec3& p, const Quat& q = {}) { return {shape, p, matrix(q)}; }

Shape some_shape(int kind) {
  switch (kind) {
    case 0:
      return Shape::box({1, 2, 3});
    case 1:
      return Shape::sphere(0.8);
    case 2:
      return Shape::cylinder(0.7, 2);
    case 3:
      return Shape::hull(tetrahedron());
    default:
      return Shape::hull({{1, 0, -0.5}, {-1, 1, -0.5}, {-1, -1, -0.5}, {0, 0.2, 1}, {0.8, 0.5, 0}});
  }
}

Vec3 rest_place(const WorldConfig& config, double seconds, Quat* turned = nullptr) {
  World world(config);
  run(world, seconds);
  if (turned != nullptr) *turned = state(world, 0).X_WB.q;
  return state(world, 0).X_WB.p;
}

}  // namespace

TEST_CASE("overlaps and gaps of all pairs are what sampled directions say") {
  CHECK(rc::check("every pair of kinds", [] {
    const int ka = *rc::gen::inRange(0, 5), kb = *rc::gen::inRange(0, 5);
    const Placed a = put(some_shape(ka), some_vector() * 2.5, turn());
    const Placed b = put(some_shape(kb), {}, turn());
    // A cylinder is exact against a ball, and here a prism.
    const double rough = (ka == 2 && kb == 1) || (ka == 1 && kb == 2) ? 0.02 : 2e-4;
    const Touch t = touch(a, b, 10);
    const double sampled = sampled_separation(a, b);
    if (sampled < 0 && t.count > 0) {
      const double parted = -reach(a, -t.normal) - reach(b, t.normal);
      RC_ASSERT(parted >= sampled - rough);
      RC_ASSERT(std::abs(squared(t.normal) - 1) < 1e-9);
    }
    if (sampled > 0.05 && t.count > 0) RC_ASSERT(deepest(t) > 0);
    if (sampled < -0.05) RC_ASSERT(t.count > 0);
    if (sampled < -0.05) RC_ASSERT(deepest(t) < 0.01);
  }));
}

TEST_CASE("the order of two shapes turns the normal round and no more") {
  CHECK(rc::check("every pair of kinds", [] {
    const Placed a = put(some_shape(*rc::gen::inRange(0, 5)), some_vector() * 2, turn());
    const Placed b = put(some_shape(*rc::gen::inRange(0, 5)), {}, turn());
    const Touch one = touch(a, b, 0.1), other = touch(b, a, 0.1);
    if (one.count == 0 || other.count == 0) return;
    // Near a tie another axis may win, by the preference for faces at most.
    const auto parted = [](const Placed& x, const Placed& y, const Vec3& n) {
      return -reach(x, -n) - reach(y, n);
    };
    RC_ASSERT(std::abs(parted(a, b, one.normal) - parted(b, a, other.normal)) < 3e-4);
  }));
}

TEST_CASE("a hull that is a box touches as a box does") {
  CHECK(rc::check("against a turned box", [] {
    const Quat q = turn();
    const Vec3 p = some_vector() * 2;
    const Placed other = put(Shape::box({1, 1.5, 2}), {}, turn());
    const Touch as_box = touch(put(Shape::box({1, 2, 1.2}), p, q), other, 0.2);
    const Touch as_hull = touch(put(Shape::hull(box_corners({0.5, 1, 0.6})), p, q), other, 0.2);
    RC_ASSERT((as_box.count == 0) == (as_hull.count == 0));
    if (as_box.count == 0 || dot(as_box.normal, as_hull.normal) < 1 - 1e-9) return;
    RC_ASSERT(std::abs(deepest(as_box) - deepest(as_hull)) < 1e-9);
  }));
}

TEST_CASE("a ball touches a hull's face, edge and corner") {
  const Placed cube = put(Shape::hull(box_corners({1, 1, 1})), {});
  const Shape ball = Shape::sphere(0.5);
  CHECK(deepest(touch(put(ball, {0.2, 0.3, 1.6}), cube, 1)) == doctest::Approx(0.1));
  CHECK(deepest(touch(put(ball, {1.3, 0, 1.4}), cube, 1)) == doctest::Approx(0));
  CHECK(deepest(touch(put(ball, {2, 2, 2}), cube, 5)) == doctest::Approx(std::sqrt(3.0) - 0.5));
  const Touch inside = touch(put(ball, {0.9, 0, 0}), cube, 1);
  CHECK(inside.normal.x == doctest::Approx(1));
  CHECK(deepest(inside) == doctest::Approx(-0.6));
}

TEST_CASE("a ball touches a cylinder's side, cap and rim") {
  const Placed can = put(Shape::cylinder(1, 2), {});
  const Shape ball = Shape::sphere(0.5);
  const Vec3 beside{1.5 * std::cos(0.1), 1.5 * std::sin(0.1), 0};
  CHECK(deepest(touch(put(ball, beside), can, 1)) == doctest::Approx(0));
  CHECK(deepest(touch(put(ball, {0.3, 0, -1.7}), can, 1)) == doctest::Approx(0.2));
  CHECK(deepest(touch(put(ball, {1.3, 0, 1.4}), can, 1)) == doctest::Approx(0));
  CHECK(touch(put(ball, {0, 0.9, 0}), can, 1).normal.y == doctest::Approx(1));
  CHECK(deepest(touch(put(ball, {0, 0.9, 0}), can, 1)) == doctest::Approx(-0.6));
}

TEST_CASE("masses of cylinders and hulls are those of the solids") {
  const BodyDef can = solid_body(Shape::cylinder(0.2, 0.6), 3);
  CHECK(inertia_of(can).z == doctest::Approx(3 * 0.04 / 2));
  CHECK(inertia_of(can).x == doctest::Approx(3 * (3 * 0.04 + 0.36) / 12));
  const BodyDef hull = solid_body(Shape::hull(box_corners({0.1, 0.2, 0.3})), 3);
  CHECK(length(inertia_of(hull) - inertia_of(solid_body(Shape::box({0.2, 0.4, 0.6}), 3))) < 1e-12);
}

TEST_CASE("a hull that is askew finds its centre and its axes") {
  CHECK(rc::check("a box turned and moved", [] {
    const Pose X{some_vector(), turn()};
    std::vector<Vec3> points = box_corners({0.1, 0.2, 0.3});
    for (Vec3& p : points) p = X * p;
    const BodyDef def = hull_body(points, 3, {});
    RC_ASSERT(length(def.X_WB.p - X.p) < 1e-9);
    Vec3 i = def.inertia;
    if (i.x < i.y) std::swap(i.x, i.y);
    if (i.y < i.z) std::swap(i.y, i.z);
    if (i.x < i.y) std::swap(i.x, i.y);
    RC_ASSERT(length(i - Vec3{0.13, 0.1, 0.05}) < 1e-9);
    BodyDef solid = def;
    solid.inertia = {};
    RC_ASSERT(length(inertia_of(solid) - def.inertia) < 1e-9);
    WorldConfig config = single(solid);
    config.floor = false;
    RC_ASSERT(problems_of(config).empty());
  }));
}

TEST_CASE("shapes that are none are refused") {
  const auto problem = [](const Shape& shape) {
    const auto all = problems_of(single(solid_body(shape, 1, {0, 0, 5})));
    return all.empty() ? std::string() : all[0];
  };
  const std::string flat = "body 0 has no extent";
  CHECK(problem(Shape::hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})) == flat);
  CHECK(problem(Shape::hull({})) == flat);
  CHECK(problem(Shape::hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::nan("")}})) == flat);
  CHECK(problem(Shape::cylinder(0, 1)) == flat);
  CHECK(problem(Shape::cylinder(1, std::nan(""))) == flat);
  CHECK(problem(Shape::hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})).find("principal") !=
        std::string::npos);
  CHECK(problem(Shape::hull(tetrahedron())).empty());
  CHECK(problem(Shape::cylinder(0.5, 1)).empty());
}

TEST_CASE("a cylinder stays where it lies, and rolls on without stopping") {
  WorldConfig config = scene_settings({0.5, 0.5});
  BodyDef can = solid_body(Shape::cylinder(0.05, 0.08), 0.5, {0, 0, 0.05});
  can.X_WB.q = rotation({std::numbers::pi / 2, 0, 0});
  config.bodies = {can};
  CHECK(length(rest_place(config, 2) - Vec3{0, 0, 0.05}) < 1e-4);
  config.bodies[0].velocity = {0.5, 0, 0};
  config.bodies[0].spin = {0, 10, 0};
  config.sleep.enabled = false;
  const Vec3 end = rest_place(config, 2);
  CHECK(end.x == doctest::Approx(1).epsilon(0.002));
  CHECK(std::abs(end.y) < 1e-3);
  CHECK(end.z == doctest::Approx(0.05).epsilon(0.002));
  // From sliding to rolling: a third of the speed goes.
  config.bodies[0].spin = {};
  World world(config);
  run(world, 1.5);
  CHECK(state(world, 0).velocity.x == doctest::Approx(0.5 * 2 / 3).epsilon(0.01));
}

TEST_CASE("a cylinder stands on its end, and an octagon on its face") {
  WorldConfig config = scene_settings();
  config.bodies = {solid_body(Shape::cylinder(0.03, 0.06), 0.2, {0, 0, 0.05})};
  Quat q;
  CHECK(length(rest_place(config, 2, &q) - Vec3{0, 0, 0.03}) < 2e-4);
  CHECK(angle_of(q) < 0.01);
  std::vector<Vec3> octagon;
  for (int i = 0; i < 8; ++i) {
    const double a = (i + 0.5) * std::numbers::pi / 4;
    octagon.push_back({0.07 * std::cos(a), 0.07 * std::sin(a), 0.02});
    octagon.push_back({0.07 * std::cos(a), 0.07 * std::sin(a), -0.02});
  }
  config.bodies = {solid_body(Shape::hull(octagon), 0.3, {0, 0, 0.04})};
  CHECK(length(rest_place(config, 2, &q) - Vec3{0, 0, 0.02}) < 2e-4);
  CHECK(angle_of(q) < 0.01);
}

TEST_CASE("a heap of all shapes comes to rest and falls asleep") {
  WorldConfig config = scene_settings({0.5, 0.5});
  std::vector<Vec3> points = tetrahedron();
  for (Vec3& p : points) p = p * 0.03;
  const Shape brick = Shape::hull(box_corners({0.02, 0.03, 0.025}));
  for (int i = 0; i < 4; ++i) {
    const double z = 0.05 + 0.07 * i, x = 0.004 * i;
    config.bodies.push_back(solid_body(Shape::cylinder(0.03, 0.05), 0.1, {x, 0, z}));
    config.bodies.push_back(solid_body(Shape::hull(points), 0.1, {x, 0.1, z}));
    config.bodies.push_back(solid_body(brick, 0.1, {0.1, x, z}));
    config.bodies.push_back(solid_body(Shape::box({0.05, 0.05, 0.05}), 0.1, {0.1, 0.1 + x, z}));
  }
  World world(config);
  while (world.awake_count() > 0 && world.time() < 10) REQUIRE(world.step().ok);
  CHECK(world.awake_count() == 0);
  for (std::uint32_t i = 0; i < world.size(); ++i) CHECK(state(world, i).X_WB.p.z > 0.008);
}

TEST_CASE("hulls and cylinders go through checkpoints and traces") {
  WorldConfig config = scene_settings();
  config.bodies = {solid_body(Shape::sphere(0.03), 0.1, {0, 0, 0.1})};
  World first(config), second(config);
  const BodyDef can = solid_body(Shape::cylinder(0.03, 0.05), 0.1, {0.1, 0, 0.1});
  const BodyDef hull =
      hull_body({{0, 0, 0}, {0.05, 0, 0}, {0, 0.05, 0}, {0, 0, 0.05}}, 0.1, {{0.2, 0, 0.1}, {}});
  REQUIRE(first.add({{can, hull}, {}}).problem.empty());
  run(first, 0.1);
  REQUIRE(second.resume(first.checkpoint()));
  run(first, 0.2);
  run(second, 0.2);
  CHECK(first.hash() == second.hash());

  PoseTraceHeader header;
  for (const BodyDef* def : {&can, &hull}) {
    header.bodies.emplace_back();
    header.bodies.back().name = "body";
    header.bodies.back().shape = def->shape;
  }
  std::string bytes;
  PoseTraceWriter writer(header, [&bytes](std::string_view more) { bytes += more; });
  TraceFrame frame;
  frame.bodies = {trace_state(state(first, 1)), trace_state(state(first, 2))};
  writer.frame(frame);
  writer.finish({});
  Diagnostics diagnostics;
  const auto trace = read_pose_trace("test", bytes, diagnostics);
  REQUIRE(trace);
  CHECK(trace->header.bodies[0].shape.kind == ShapeKind::cylinder);
  CHECK(trace->header.bodies[0].shape.half == can.shape.half);
  REQUIRE(trace->header.bodies[1].shape.kind == ShapeKind::hull);
  CHECK(trace->header.bodies[1].shape.convex->points == hull.shape.convex->points);
}
