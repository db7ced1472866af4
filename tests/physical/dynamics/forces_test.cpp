// SPDX-License-Identifier: MIT
// Forces that users add, and damping.
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

WorldConfig in_space(const BodyDef& def) {
  WorldConfig config = single(def);
  config.gravity = 0;
  config.floor = false;
  return config;
}

}  // namespace

TEST_CASE("a force function makes a spring swing as the closed form says") {
  WorldConfig config = in_space(solid_body(Shape::sphere(0.1), 2, {1, 0, 0}));
  config.step = 0.001;
  World world(config);
  world.add_force([](const World& now, Forces& forces) {
    forces.add(BodyId{0}, now.state(BodyId{0}).X_WB.p * -8.0, {});
  });
  run(world, 1.5707963);  // half of 2π √(m/k)
  CHECK(state(world, 0).X_WB.p.x == doctest::Approx(-1).epsilon(0.01));
}

TEST_CASE("force functions are called in order and see one another's world, not each other") {
  World world(in_space(solid_body(Shape::sphere(0.1), 2)));
  std::string calls;
  world.add_force([&calls](const World&, Forces& forces) {
    calls += 'a';
    forces.add_at(BodyId{0}, {0, 2, 0}, {1, 0, 0});
  });
  world.add_force([&calls](const World& now, Forces&) {
    calls += 'b';
    CHECK(now.state(BodyId{0}).velocity.y ==
          doctest::Approx(0.005 * static_cast<double>(now.tick())));
  });
  for (int i = 0; i < 3; ++i) REQUIRE(world.step().ok);
  CHECK(calls == "ababab");
  CHECK(state(world, 0).velocity.y == doctest::Approx(0.015));
  CHECK(state(world, 0).spin.z == doctest::Approx(0.015 * 2 / 0.008));
}

TEST_CASE("force functions leave sleepers and fixed bodies alone; what is no force ends the run") {
  WorldConfig config = scene_settings();
  config.bodies = {block_body(without_magnets(paper_block()), {{0, 0, 0.0275}, {}}),
                   block_body(without_magnets(paper_block()), {{1, 0, 1}, {}}),
                   block_body(without_magnets(paper_block()), {{2, 0, 1}, {}})};
  config.bodies[1].fixed = true;
  config.bodies[2].velocity = {0, 0, 20};
  World world(config);
  run(world, 1);
  REQUIRE_FALSE(state(world, 0).awake);
  const Vec3 before = state(world, 0).X_WB.p;
  world.add_force([](const World&, Forces& forces) {
    forces.add(BodyId{0}, {5, 0, 0}, {});
    forces.add(BodyId{1}, {5, 0, 0}, {});
  });
  run(world, 0.5);
  CHECK(state(world, 0).X_WB.p == before);
  CHECK(state(world, 1).X_WB.p == Vec3{1, 0, 1});
  world.add_force([](const World&, Forces& forces) {
    forces.add(BodyId{2}, {std::nan(""), 0, 0}, {});
  });
  const StepResult result = world.step();
  CHECK_FALSE(result.ok);
  CHECK(result.body == BodyId{2});
}

TEST_CASE("damping takes speed and spin as an exponential, at any rate") {
  for (const double rate : {0.5, 5.0, 5000.0}) {
    BodyDef def = solid_body(Shape::box({0.1, 0.1, 0.1}), 2);
    def.velocity = {1, 0, 0};
    def.spin = {0, 0, 2};
    WorldConfig config = in_space(def);
    config.damping = rate;
    config.angular_damping = rate;
    World world(config);
    run(world, 0.5);
    CHECK(state(world, 0).velocity.x == doctest::Approx(std::exp(-rate / 2)));
    CHECK(state(world, 0).spin.z == doctest::Approx(2 * std::exp(-rate / 2)));
  }
  WorldConfig config = in_space(solid_body(Shape::sphere(1), 1));
  config.damping = -1;
  CHECK(problems_of(config).size() == 1);
}
