// SPDX-License-Identifier: MIT
// Mechanisms against closed forms, and what is refused.

#include "physical/dynamics/joint.h"

#include <cmath>
#include <numbers>

#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// No floor, and a step for laws of motion.
WorldConfig in_the_air(double step) {
  WorldConfig config;
  config.floor = false;
  config.sleep.enabled = false;
  config.step = step;
  return config;
}

/// Adds a small ball on a rod of given length that turns about y at a place of its parent.
/// Angle 0: it hangs straight down.
void add_pendulum(WorldConfig& config, std::uint32_t parent, const Vec3& pivot, double length,
                  double angle) {
  JointDef joint;
  joint.parent = parent;
  joint.child = static_cast<std::uint32_t>(config.bodies.size());
  joint.X_PJ.p = pivot;
  joint.X_CJ.p = {0, 0, length};
  joint.dofs = {{.axis = {0, 1, 0}, .start = angle}};
  config.bodies.push_back(solid_body(Shape::sphere(0.02), 0.5));
  config.joints.push_back(joint);
}

/// The time of `count` periods, from crossings of the lowest point.
double time_of_swings(World& world, int count) {
  double last = world.joint(JointId{0})[0].position, first_time = -1;
  for (int crossings = 0;;) {
    REQUIRE(world.step().ok);
    const double now = world.joint(JointId{0})[0].position;
    if (last < 0 && now >= 0) {
      const double step = world.time() / static_cast<double>(world.tick());
      const double exact = world.time() - now / (now - last) * step;
      if (first_time < 0)
        first_time = exact;
      else if (++crossings == count)
        return exact - first_time;
    }
    last = now;
  }
}

/// The complete elliptic integral of the first kind, by the arithmetic-geometric mean.
double elliptic_k(double k) {
  double a = 1, b = std::sqrt(1 - k * k);
  while (std::abs(a - b) > 1e-14) std::tie(a, b) = std::pair((a + b) / 2, std::sqrt(a * b));
  return std::numbers::pi / (2 * a);
}

struct Sum {
  Vec3 linear, angular;
};
Sum momentum(const World& world, const WorldConfig& config) {
  Sum sum;
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    const BodyState s = state(world, i);
    const Mat3 r = matrix(s.X_WB.q);
    const Vec3 p = s.velocity * config.bodies[i].mass;
    sum.linear += p;
    sum.angular +=
        cross(s.X_WB.p, p) + r * scaled(inertia_of(config.bodies[i]), r.transposed(s.spin));
  }
  return sum;
}

}  // namespace

TEST_CASE("a pendulum keeps the period that the elliptic integral gives") {
  for (const double angle : {0.1, 1.0, 2.5}) {
    CAPTURE(angle);
    WorldConfig config = in_the_air(0.002);
    add_pendulum(config, kWorldBody, {0, 0, 1}, 0.4, angle);
    place_links(config);
    REQUIRE(problems_of(config).empty());
    World world(config);
    // Of a ball at the end of a rod without mass: its own moment counts.
    const double inertia = 0.5 * 0.16 + inertia_of(config.bodies[0]).y;
    const double slow = 2 * std::numbers::pi * std::sqrt(inertia / (0.5 * 9.8 * 0.4));
    const double period = slow * 2 / std::numbers::pi * elliptic_k(std::sin(angle / 2));
    CHECK(time_of_swings(world, 5) == doctest::Approx(5 * period).epsilon(5e-4));
  }
}

TEST_CASE("a double pendulum keeps its energy") {
  WorldConfig config = in_the_air(0.0005);
  add_pendulum(config, kWorldBody, {0, 0, 1}, 0.3, 2);
  add_pendulum(config, 0, {0, 0, 0}, 0.2, 1);
  place_links(config);
  World world(config);
  const double start = world.energy();
  // Velocities are half a step away from positions, so what is measured swings about what
  // is kept: most it may swing by, and drift.
  double most = 0, sum = 0;
  while (world.time() < 10) {
    REQUIRE(world.step().ok);
    const double change = world.energy() - start;
    most = std::max(most, std::abs(change));
    if (world.time() > 9) sum += change * config.step;
  }
  CHECK(most < 0.08);
  CHECK(std::abs(sum) < 0.003);  // of some 7 J that go to and fro
}

TEST_CASE("a fast top precesses as it should") {
  // Held at its tip by three axes; the third is its own.
  WorldConfig config = in_the_air(0.0005);
  const double length = 0.1, spin = 400, tilt = 0.5;
  BodyDef top = solid_body(Shape::box({0.06, 0.06, 0.02}), 0.2);
  config.bodies = {top};
  JointDef joint;
  joint.X_PJ.p = {0, 0, 1};
  joint.X_CJ.p = {0, 0, -length};
  const Vec3 inertia = inertia_of(top);
  const double across = inertia.x + top.mass * length * length, own = inertia.z;
  // Steady: across cos(tilt) w² - own spin w + m g l = 0, with the whole spin about
  // the own axis; the slower of the two.
  const double a = across * std::cos(tilt);
  const double b = own * spin, c = top.mass * 9.8 * length;
  const double steady = (b - std::sqrt(b * b - 4 * a * c)) / (2 * a);
  joint.dofs = {{.axis = {0, 0, 1}, .start_speed = steady},
                {.axis = {0, 1, 0}, .start = tilt},
                {.axis = {0, 0, 1}, .start_speed = spin - steady * std::cos(tilt)}};
  config.joints = {joint};
  place_links(config);
  REQUIRE(problems_of(config).empty());
  World world(config);
  run(world, 2);
  const auto end = world.joint(JointId{0});
  CHECK(end[0].position == doctest::Approx(2 * steady).epsilon(0.005));
  CHECK(end[1].position == doctest::Approx(tilt).epsilon(0.01));
  CHECK(std::abs(end[2].velocity + end[0].velocity * std::cos(end[1].position)) ==
        doctest::Approx(spin).epsilon(0.001));
}

TEST_CASE("a slide falls between its stops, and stays on the lower one") {
  WorldConfig config = in_the_air(0.005);
  config.bodies = {solid_body(Shape::box({0.1, 0.1, 0.1}), 2)};
  JointDef joint;
  joint.X_PJ.p = {0, 0, 1};
  joint.dofs = {{.linear = true, .lower = -0.3, .upper = 0.1}};
  config.joints = {joint};
  place_links(config);
  World world(config);
  run(world, 0.2);
  CHECK(world.joint(JointId{0})[0].position == doctest::Approx(-4.9 * 0.04).epsilon(0.03));
  run(world, 0.3);
  CHECK(world.joint(JointId{0})[0].position == doctest::Approx(-0.3).epsilon(1e-4));
  world.push(BodyId{0}, {0, 0, 2000}, {});
  run(world, 0.1);
  CHECK(world.joint(JointId{0})[0].position < 0.1 + 1e-6);
}

TEST_CASE("a motor keeps its speed until the load is more than its effort") {
  // Lifts 2 kg: 19.6 N.
  for (const auto& [effort, lifts] : {std::pair(25.0, true), std::pair(15.0, false)}) {
    CAPTURE(effort);
    WorldConfig config = in_the_air(0.005);
    config.bodies = {solid_body(Shape::box({0.1, 0.1, 0.1}), 2)};
    JointDef joint;
    joint.dofs = {{.linear = true, .lower = 0, .actuator = Actuator::velocity, .effort = effort}};
    config.joints = {joint};
    World world(config);
    world.drive(JointId{0}, 0, 0.2);
    run(world, 1);
    const DofState end = world.joint(JointId{0})[0];
    CHECK(end.position == doctest::Approx(lifts ? 0.2 : 0).epsilon(0.05));
    CHECK(end.velocity == doctest::Approx(lifts ? 0.2 : 0));
    CHECK(end.force == doctest::Approx(lifts ? 19.6 : 15));
  }
}

TEST_CASE("a position motor arrives at its speed, holds against gravity, and sleeps") {
  WorldConfig config = in_the_air(0.005);
  config.sleep.enabled = true;
  config.bodies = {solid_body(Shape::box({0.1, 0.1, 0.1}), 1)};
  JointDef joint;
  joint.dofs = {{.linear = true,
                 .lower = 0,
                 .upper = 0.5,
                 .actuator = Actuator::position,
                 .effort = 20,
                 .speed = 0.1}};
  config.joints = {joint};
  World world(config);
  world.drive(JointId{0}, 0, 0.3);
  run(world, 2);
  CHECK(world.joint(JointId{0})[0].position == doctest::Approx(0.2).epsilon(0.02));
  run(world, 2);
  CHECK(world.joint(JointId{0})[0].position == doctest::Approx(0.3).epsilon(1e-4));
  CHECK(world.awake_count() == 0);
  world.drive(JointId{0}, 0, 5);  // no farther than its stop
  CHECK(world.awake_count() == 1);
  run(world, 4);
  CHECK(world.joint(JointId{0})[0].position == doctest::Approx(0.5).epsilon(1e-4));
}

TEST_CASE("force motors and damping balance") {
  WorldConfig config = in_the_air(0.005);
  config.gravity = 0;
  config.bodies = {solid_body(Shape::box({0.1, 0.1, 0.1}), 1)};
  JointDef joint;
  joint.dofs = {{.linear = true, .actuator = Actuator::force, .effort = 3, .damping = 4}};
  config.joints = {joint};
  World world(config);
  world.drive(JointId{0}, 0, 10);
  run(world, 3);
  CHECK(world.joint(JointId{0})[0].velocity == doctest::Approx(0.75));
  CHECK(world.joint(JointId{0})[0].force == doctest::Approx(3));
}

TEST_CASE("a mechanism that nothing holds keeps its momentum") {
  WorldConfig config = in_the_air(0.005);
  config.gravity = 0;
  config.bodies = {solid_body(Shape::box({0.2, 0.1, 0.1}), 1)};
  config.bodies[0].velocity = {0.1, 0.2, 0.3};
  config.bodies[0].spin = {2, 1, 3};
  add_pendulum(config, 0, {0.2, 0, 0}, 0.2, 0.5);
  add_pendulum(config, 1, {0, 0, 0}, 0.2, -1);
  config.joints[0].dofs[0].actuator = Actuator::velocity;
  config.joints[0].dofs[0].start_speed = -1;
  config.joints[1].dofs[0].axis = {1, 0, 0};
  config.joints[1].dofs[0].start_speed = 5;
  place_links(config);
  REQUIRE(problems_of(config).empty());
  World world(config);
  world.drive(JointId{0}, 0, 4);
  const Sum before = momentum(world, config);
  run(world, 2);
  const Sum after = momentum(world, config);
  CHECK(length(after.linear - before.linear) < 1e-12);
  CHECK(length(after.angular - before.angular) < 1e-11);
  CHECK(std::abs(world.joint(JointId{0})[0].velocity) > 1);
}

TEST_CASE("fixed joints make one rigid body of exact mass and moments") {
  // Two halves of a box against the whole.
  WorldConfig halves = in_the_air(0.005), whole = halves;
  const Vec3 spin{3, 2, 1};
  halves.bodies = {solid_body(Shape::box({0.1, 0.1, 0.1}), 1, {-0.05, 0, 0}),
                   solid_body(Shape::box({0.1, 0.1, 0.1}), 1, {0.05, 0, 0})};
  for (BodyDef& def : halves.bodies) {
    def.velocity = cross(spin, def.X_WB.p);
    def.spin = spin;
  }
  halves.joints.resize(1);
  halves.joints[0].parent = 0;
  halves.joints[0].child = 1;
  halves.joints[0].X_PJ.p = {0.1, 0, 0};
  whole.bodies = {solid_body(Shape::box({0.2, 0.1, 0.1}), 2)};
  whole.bodies[0].spin = spin;
  halves.gravity = whole.gravity = 0;
  halves.step = whole.step = 0.001;
  REQUIRE(problems_of(halves).empty());
  World two(halves), one(whole);
  run(two, 1);
  run(one, 1);
  const Vec3 middle = (state(two, 0).X_WB.p + state(two, 1).X_WB.p) * 0.5;
  CHECK(length(middle) < 1e-4);
  const Mat3 r = matrix(state(two, 0).X_WB.q), s = matrix(state(one, 0).X_WB.q);
  CHECK(length(r.x - s.x) < 2e-3);
  CHECK(length(r.z - s.z) < 2e-3);
}

TEST_CASE("mechanisms resume bit by bit, in threads too") {
  WorldConfig config = scene_settings();
  config.bodies = {solid_body(Shape::box({0.2, 0.1, 0.05}), 1, {0, 0, 0.3})};
  add_pendulum(config, 0, {0.2, 0, 0}, 0.1, 0.5);
  config.joints[0].dofs[0].actuator = Actuator::velocity;
  config.joints[0].dofs[0].effort = 0.3;
  place_links(config);
  REQUIRE(problems_of(config).empty());
  World first(config);
  first.drive(JointId{0}, 0, 6);
  std::vector<std::uint64_t> hashes;
  std::vector<std::string> checkpoints;
  for (int i = 0; i < 300; ++i) {
    REQUIRE(first.step().ok);
    hashes.push_back(first.hash());
    checkpoints.push_back(first.checkpoint());
  }
  for (const std::size_t at : {0U, 60U, 150U}) {
    World world(config);
    REQUIRE(world.resume(checkpoints[at]));
    for (std::size_t i = at + 1; i < hashes.size(); ++i) {
      REQUIRE(world.step().ok);
      REQUIRE(world.hash() == hashes[i]);
    }
  }
}

TEST_CASE("joints that make no mechanism are refused, by number") {
  const auto complaint = [](auto change) {
    WorldConfig config;
    config.bodies = {solid_body(Shape::sphere(0.1), 1, {0, 0, 1}),
                     solid_body(Shape::sphere(0.1), 1, {0, 0, 2}),
                     solid_body(Shape::sphere(0.1), 1, {0, 0, 3})};
    config.joints.resize(2);
    for (std::uint32_t i = 0; i < 2; ++i) {
      config.joints[i].parent = i;
      config.joints[i].child = i + 1;
      config.joints[i].X_PJ.p = {0, 0, 1};
      config.joints[i].dofs = {{.axis = {1, 0, 0}}};
    }
    change(config.joints, config);
    const auto problems = problems_of(config);
    return problems.empty() ? std::string() : problems[0];
  };
  using Joints = std::vector<JointDef>;
  const double nan = std::nan("");
  CHECK(complaint([](Joints&, auto&) {}) == "");
  CHECK(complaint([](Joints& j, auto&) { j[0].parent = 2; }) ==
        "joint 0 is part of a circle: a mechanism is a tree");
  CHECK(complaint([](Joints& j, auto&) { j[1].child = 1, j[1].parent = 2; }) ==
        "body 1 is the child of joints 0 and 1: a mechanism is a tree");
  CHECK(complaint([](Joints& j, auto&) { j[0].child = 9; }) ==
        "joint 0 has a child that is no body");
  CHECK(complaint([](Joints& j, auto&) { j[0].parent = 9; }) ==
        "joint 0 has a parent that is no body");
  CHECK(complaint([](Joints& j, auto&) { j[0].child = 0; }) == "joint 0 joins a body to itself");
  CHECK(complaint([](Joints&, auto& c) { c.bodies[1].fixed = true; }) ==
        "joint 0 has a child that is fixed");
  CHECK(complaint([](Joints&, auto& c) { c.bodies[0].fixed = true; }) ==
        "joint 0 has a parent that is fixed: hang it in the world");
  CHECK(complaint([](Joints& j, auto&) { j[1].X_CJ.p.x = 0.01; }) ==
        "joint 1 does not fit the poses of its bodies");
  CHECK(complaint([&](Joints& j, auto&) { j[1].X_CJ.p.x = nan; }) ==
        "joint 1 has a pose that is none");
  CHECK(complaint([](Joints& j, auto&) { j[1].dofs[0].axis = {}; }) ==
        "joint 1 has an axis that is no unit vector");
  CHECK(complaint([](Joints& j, auto&) { j[1].dofs[0].lower = 1; }) ==
        "joint 1 starts outside of its limits");
  CHECK(complaint([](Joints& j, auto&) { j[1].dofs[0].lower = 1, j[1].dofs[0].upper = -1; }) ==
        "joint 1 has limits in the wrong order");
  CHECK(complaint([&](Joints& j, auto&) { j[1].dofs[0].effort = nan; }) ==
        "joint 1 has an effort that is negative or none");
  CHECK(complaint([](Joints& j, auto&) { j[0].dofs.resize(70, j[0].dofs[0]); }) ==
        "the mechanism of body 0 has more than 64 degrees of freedom");
  CHECK(complaint([](Joints& j, auto&) { j[0] = {}, j[0].child = 1; }) ==
        "joint 0 has no degree of freedom and hangs in the world: say that its body is fixed");
}
