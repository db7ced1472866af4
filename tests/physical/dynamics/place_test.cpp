// SPDX-License-Identifier: MIT
// Bodies that a hand puts elsewhere while the world runs.
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {}  // namespace

TEST_CASE("a block put elsewhere falls as one that begins there") {
  const Pose there{{0.3, -0.2, 0.2}, rotation({0.3, 0, 0.5})};
  World world(column_scene(paper_block(), 1));
  run(world, 0.2);
  const PlaceResult placed = world.place(BodyId{0}, there);
  CHECK(placed.problem == "");
  WorldConfig config = column_scene(paper_block(), 1);
  config.bodies[0].X_WB = there;
  World other(config);
  for (int i = 0; i < 100; ++i) {
    REQUIRE(world.step().ok);
    REQUIRE(other.step().ok);
    const BodyState one = state(world, 0), two = state(other, 0);
    REQUIRE(length(one.X_WB.p - two.X_WB.p) < 1e-9);
    REQUIRE(length(one.spin - two.spin) < 1e-6);
  }
}

TEST_CASE("what stood on it wakes and falls; what snapped to it has let go") {
  World world(column_scene(paper_block(), 3));
  run(world, 1);
  REQUIRE(world.awake_count() == 0);
  REQUIRE(world.place(BodyId{1}, {{0.5, 0, 0.0275}, {}}).problem == "");
  CHECK(world.awake_count() == 3);
  REQUIRE(world.step().ok);
  CHECK(count(world, EventKind::woke) == 3);
  CHECK(count(world, EventKind::let_go) == 2);
  run(world, 1);
  CHECK(state(world, 2).X_WB.p.z == doctest::Approx(0.0825).epsilon(1e-3));
  CHECK(length(state(world, 1).X_WB.p - Vec3{0.5, 0, 0.0275}) < 1e-4);
  CHECK(world.awake_count() == 0);
}

TEST_CASE("put upon a sleeper or beside its magnets, it wakes it") {
  WorldConfig config = column_scene(paper_block(), 1);
  config.bodies.push_back(block_body(paper_block(), {{1, 0, 0.0275}, {}}));
  World world(config);
  run(world, 1);
  REQUIRE(world.awake_count() == 0);
  SUBCASE("upon it") {
    REQUIRE(world.place(BodyId{1}, {{0.01, 0, 0.0825}, {}}).problem == "");
    CHECK(state(world, 0).awake);
  }
  SUBCASE("within the reach of its magnets: they come together") {
    REQUIRE(world.place(BodyId{1}, {{0.060, 0, 0.0275}, {}}).problem == "");
    CHECK(state(world, 0).awake);
    run(world, 1);
    CHECK(state(world, 1).X_WB.p.x - state(world, 0).X_WB.p.x ==
          doctest::Approx(0.055).epsilon(1e-3));
  }
  SUBCASE("far from it: it sleeps on") {
    REQUIRE(world.place(BodyId{1}, {{0.5, 0, 0.0275}, {}}).problem == "");
    CHECK_FALSE(state(world, 0).awake);
  }
}

TEST_CASE("where it cannot be it is not put, and nothing changes") {
  WorldConfig config = column_scene(paper_block(), 2);
  config.bodies.push_back(block_body(paper_block(), {{1, 0, 0.0275}, {}}));
  config.bodies.push_back(block_body(paper_block(), {{2, 0, 0.5}, {}}));
  config.bodies.back().velocity = {0, 90, 0};
  config.arena = 10;
  World world(config);
  run(world, 1);
  REQUIRE(state(world, 3).left);
  const std::uint64_t hash = world.hash();
  const PlaceResult onto = world.place(BodyId{2}, {{0.02, 0, 0.06}, {}});
  CHECK(onto.overlaps);
  CHECK(onto.body == BodyId{2});
  CHECK(onto.other == BodyId{0});
  CHECK(onto.problem == "body 2 would overlap body 0");
  const PlaceResult sunk = world.place(BodyId{2}, {{1, 0, 0.02}, {}});
  CHECK(sunk.problem == "it would be in the floor");
  CHECK_FALSE(sunk.overlaps);
  CHECK(world.place(BodyId{2}, {{11, 0, 1}, {}}).problem == "it would be outside of the arena");
  CHECK(world.place(BodyId{2}, {{1e308 * 10, 0, 1}, {}}).problem ==
        "it would be outside of the arena");
  CHECK(world.place(BodyId{3}, {{2, 0, 1}, {}}).problem == "it has left the arena");
  CHECK(world.hash() == hash);
}

TEST_CASE("a world brought back goes on as the one in which a body was put elsewhere") {
  const WorldConfig config = column_scene(paper_block(), 3);
  World world(config), back(config);
  run(world, 0.5);
  REQUIRE(world.place(BodyId{0}, {{0.3, 0, 0.1}, rotation({0.1, 0.2, 0.3})}).problem == "");
  REQUIRE(back.resume(world.checkpoint()));
  run(world, 0.5);
  run(back, 0.5);
  CHECK(world.hash() == back.hash());
}

TEST_CASE("a mechanism goes as one piece and is at rest; one that hangs in the world does not") {
  WorldConfig config;
  config.bodies = {solid_body(Shape::box({0.2, 0.1, 0.04}), 1, {0, 0, 0.02}),
                   solid_body(Shape::box({0.1, 0.02, 0.02}), 0.1, {0.08, 0, 0.08})};
  JointDef joint;
  joint.parent = 0;
  joint.child = 1;
  joint.X_PJ.p = {0.03, 0, 0.06};
  joint.X_CJ.p = {-0.05, 0, 0};
  DofDef dof;
  dof.axis = {0, 0, 1};
  dof.start = 0.4;
  dof.start_speed = 2;
  joint.dofs = {dof};
  config.joints = {joint};
  SUBCASE("free") {
    place_links(config);
    World world(config);
    run(world, 0.2);
    const Pose X_01 = inverse(state(world, 0).X_WB) * state(world, 1).X_WB;
    const Pose there{{1, 2, 0.0201}, rotation({0, 0, 2})};
    REQUIRE(world.place(BodyId{0}, there).problem == "");
    const Pose moved = inverse(state(world, 0).X_WB) * state(world, 1).X_WB;
    CHECK(length(state(world, 0).X_WB.p - there.p) < 1e-12);
    CHECK(length(moved.p - X_01.p) < 1e-12);
    CHECK(world.joint(JointId{0})[0].velocity == 0);
    CHECK(length(state(world, 1).velocity) == 0);
    run(world, 0.5);
    CHECK(length(state(world, 0).X_WB.p - there.p) < 1e-3);
  }
  SUBCASE("held by the world") {
    config.joints.push_back({});
    config.joints[1].parent = kWorldBody;
    config.joints[1].child = 0;
    config.joints[1].X_PJ.p = {0, 0, 0.02};
    config.joints[1].dofs = {DofDef{}};
    place_links(config);
    World world(config);
    CHECK(world.place(BodyId{1}, {{1, 2, 0.3}, {}}).problem == "it is fixed in the world");
  }
}
