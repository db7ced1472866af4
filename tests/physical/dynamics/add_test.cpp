// SPDX-License-Identifier: MIT
// Bodies that come into a world that runs.
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

BodyDef block_at(const Vec3& place) { return block_body(paper_block(), {place, {}}); }

}  // namespace

TEST_CASE("a block dropped onto others later falls, wakes them and comes to rest") {
  World world(column_scene(paper_block(), 2));
  run(world, 1);
  REQUIRE(world.awake_count() == 0);
  const AddResult added = world.add({{block_at({0, 0, 0.2})}, {}});
  CHECK(added.problem == "");
  CHECK(added.body == BodyId{2});
  CHECK(world.size() == 3);
  bool woke = false;
  for (int i = 0; i < 100; ++i) {
    REQUIRE(world.step().ok);
    woke = woke || state(world, 0).awake;
  }
  CHECK(woke);
  run(world, 1);
  CHECK(state(world, 2).X_WB.p.z == doctest::Approx(0.0275 + 0.11).epsilon(1e-3));
  CHECK(world.awake_count() == 0);
}

TEST_CASE("what cannot come in is refused, and nothing changes") {
  World world(column_scene(paper_block(), 2));
  run(world, 0.1);
  const std::uint64_t hash = world.hash();
  const AddResult onto = world.add({{block_at({0, 0, 0.09})}, {}});
  CHECK(onto.problem == "body 0 overlaps body 1 of the world");
  CHECK(onto.overlaps);
  CHECK(onto.other == BodyId{1});
  CHECK(world.add({{block_at({1, 0, 0.2}), block_at({1, 0, 0.22})}, {}}).problem ==
        "bodies 0 and 1 overlap");
  CHECK(world.add({{block_at({1, 0, 0})}, {}}).problem == "body 0 is in the floor");
  const AddResult outside = world.add({{block_at({1e6, 0, 1})}, {}});
  CHECK(outside.problem == "body 0 is outside of the arena");
  CHECK_FALSE(outside.overlaps);
  BodyDef none = block_at({1, 0, 1});
  none.mass = 0;
  CHECK(world.add({{none}, {}}).problem == "body 0 has a mass that is not positive");
  CHECK(world.hash() == hash);
  CHECK(world.size() == 2);
}

TEST_CASE("checkpoints hold what was added, also where more was added since") {
  const WorldConfig config = column_scene(paper_block(), 2);
  World first(config);
  run(first, 0.2);
  const std::string before = first.checkpoint();
  REQUIRE(first.add({{block_at({0.01, 0, 0.2})}, {}}).problem.empty());
  run(first, 0.1);
  const std::string middle = first.checkpoint();
  run(first, 0.5);
  const std::uint64_t end = first.hash();

  World fresh(config);
  REQUIRE(fresh.resume(middle));
  CHECK(fresh.size() == 3);
  run(fresh, 0.5);
  CHECK(fresh.hash() == end);
  REQUIRE(fresh.resume(before));
  CHECK(fresh.size() == 2);
  for (std::size_t i = 0; i < middle.size(); i += 61) {
    CHECK_FALSE(fresh.resume(middle.substr(0, i)));
  }
}

TEST_CASE("a mechanism comes in whole") {
  WorldConfig config = scene_settings();
  World world(config);
  Addition addition;
  addition.bodies = {solid_body(Shape::box({0.1, 0.1, 0.1}), 1, {0, 0, 0.5}),
                     solid_body(Shape::sphere(0.05), 1, {0.2, 0, 0.5})};
  addition.joints.resize(1);
  addition.joints[0].parent = 0;
  addition.joints[0].child = 1;
  addition.joints[0].X_PJ.p = {0.2, 0, 0};
  addition.joints[0].dofs = {{.axis = {0, 1, 0}, .actuator = Actuator::velocity}};
  const AddResult one = world.add(addition);
  REQUIRE(one.problem == "");
  for (BodyDef& def : addition.bodies) def.X_WB.p.y += 1;
  const AddResult two = world.add(addition);
  REQUIRE(two.problem == "");
  CHECK(two.joint == JointId{1});
  world.drive(two.joint, 0, 3);
  run(world, 0.1);
  CHECK(world.joint(two.joint)[0].velocity == doctest::Approx(3));
  const std::string checkpoint = world.checkpoint();
  run(world, 0.3);
  World again(config);
  REQUIRE(again.resume(checkpoint));
  run(again, 0.3);
  CHECK(again.hash() == world.hash());
}
