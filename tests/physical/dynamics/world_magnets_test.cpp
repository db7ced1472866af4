// SPDX-License-Identifier: MIT
// Magnets in a world: where they act, currents that change, and snaps.
#include <rapidcheck.h>

#include "physical/support.h"
#include "support/draws.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// No floor, no weight: magnets alone.
WorldConfig afloat() {
  WorldConfig config;
  config.floor = false;
  config.gravity = 0;
  config.step = 1e-6;
  config.magnet_cutoff = 0.2;
  return config;
}

/// A box with two fixed magnets off its centre.
BodyDef magnetic_box(const Pose& X_WB) {
  BodyDef def = solid_body(Shape::box({0.03, 0.04, 0.05}), 0.1);
  def.X_WB = X_WB;
  def.magnets = {{{0.012, -0.01, 0.02}, 0.2, false, some_direction()},
                 {{-0.01, 0.015, -0.018}, 0.3, false, some_direction(), 0.01}};
  return def;
}

double energy(const WorldConfig& config, double current) {
  World world(config);
  world.set_current(BodyId{0}, 1, current);
  return world.energy();
}

/// Slope of the energy as the body moves along, or turns about, each axis.
Vec3 slope(WorldConfig config, std::uint32_t body, bool turns, double current) {
  const Pose from = config.bodies[body].X_WB;
  const double h = 1e-6;
  const auto at = [&](const Vec3& axis, double way) {
    Pose& pose = config.bodies[body].X_WB = from;
    if (turns) pose.q = normalised(rotation(axis * way) * from.q);
    if (!turns) pose.p += axis * way;
    return energy(config, current);
  };
  const auto along = [&](const Vec3& axis) { return (at(axis, h) - at(axis, -h)) / (2 * h); };
  return {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
}

/// A carrier fixed above a block on the floor, with four electromagnets that face the
/// block's upper spheres at the lift's lowest place: 17.5 mm between centres.
WorldConfig lifting_scene(double active) {
  WorldConfig config = scene_settings();
  const BlockModel block = paper_block();
  config.bodies = {block_body(block, {{0, 0, 0.0275 - 1e-5}, {}})};
  BodyDef carrier = solid_body(Shape::box({0.06, 0.06, 0.01}), 0.1, {0, 0, 0.0275 + 0.04});
  carrier.fixed = true;
  for (const double x : {-0.0225, 0.0225}) {
    for (const double y : {-0.0225, 0.0225}) {
      carrier.magnets.push_back(
          {{x, y, 0}, 165 * kMomentPerField, false, {0, 0, 1}, active * kMomentPerField});
    }
  }
  config.bodies.push_back(carrier);
  return config;
}

/// All four currents at once.
void set_currents(World& world, double current) {
  for (std::size_t k = 0; k < 4; ++k) world.set_current(BodyId{1}, k, current);
}

}  // namespace

TEST_CASE("off-centre magnets of turned bodies: force and torque are the energy's slopes") {
  CHECK(rc::check("both bodies, with and without current", [] {
    WorldConfig config = afloat();
    const Vec3 apart = some_direction() * (0.08 + 0.02 * std::abs(unit_value()));
    config.bodies = {magnetic_box({{}, normalised(rotation(some_vector() * 3))}),
                     magnetic_box({apart, normalised(rotation(some_vector() * 3))})};
    const double current = *rc::gen::element(0.0, 12.5, -40.0);
    World world(config);
    world.set_current(BodyId{0}, 1, current);
    RC_ASSERT(world.step().ok);
    for (std::uint32_t i = 0; i < 2; ++i) {
      const BodyState s = state(world, i);
      const Mat3 r = matrix(config.bodies[i].X_WB.q);
      const Vec3 force = s.velocity * (config.bodies[i].mass / config.step);
      const Vec3 torque =
          r * scaled(inertia_of(config.bodies[i]), r.transposed(s.spin)) * (1 / config.step);
      const double scale = 1e-3 * length(force) + 1e-6;
      RC_ASSERT(length(force + slope(config, i, false, current)) < scale);
      RC_ASSERT(length(torque + slope(config, i, true, current)) < scale * 0.05);
    }
  }));
}

TEST_CASE("an electromagnet with a current: the table of the paper's parameters") {
  // A block's magnet of 75 against one of 165 + current · 1, 17.5 mm apart on an axis.
  const struct {
    double current, force;
  } table[] = {{0, 0.56}, {250, 0.56 * 415 / 165}, {-250, -0.56 * 85 / 165}};
  for (const auto& row : table) {
    CAPTURE(row.current);
    WorldConfig config = afloat();
    for (const double z : {0.0, 0.0175}) {
      config.bodies.push_back(solid_body(Shape::sphere(0.003), 0.01, {0, 0, z}));
    }
    config.bodies[0].magnets = {{{}, 75 * kMomentPerField, false}};
    config.bodies[1].magnets = {{{}, 165 * kMomentPerField, false, {0, 0, 1}, kMomentPerField}};
    World world(config);
    world.set_current(BodyId{1}, 0, row.current);
    CHECK(world.current(BodyId{1}, 0) == row.current);
    REQUIRE(world.step().ok);
    const double lifted = state(world, 0).velocity.z * 0.01 / config.step;
    CHECK(lifted == doctest::Approx(row.force).epsilon(0.01));
    // The carrier feels the reaction.
    CHECK(state(world, 1).velocity.z == doctest::Approx(-state(world, 0).velocity.z));
  }
}

TEST_CASE("four electromagnets pull with 2.2 N without current, repel with 1.15 N at full") {
  // The spheres point as they did before the current was reversed.
  WorldConfig config = lifting_scene(1);
  config.floor = false;
  config.gravity = 0;
  config.step = 1e-6;
  for (MagnetDef& magnet : config.bodies[0].magnets) magnet.free = false;
  const auto force = [&](double current) {
    World world(config);
    set_currents(world, current);
    REQUIRE(world.step().ok);
    return state(world, 0).velocity.z * 0.110 / config.step;
  };
  CHECK(force(0) == doctest::Approx(2.23).epsilon(0.02));
  CHECK(force(-250) == doctest::Approx(-1.15).epsilon(0.02));
}

TEST_CASE("a block is lifted by a current, and held without one; net zero lets it fall") {
  const WorldConfig config = lifting_scene(1);
  World world(config);
  set_currents(world, -165);
  run(world, 0.5);
  CHECK(state(world, 0).X_WB.p.z < 0.0276);
  CHECK(world.awake_count() == 0);
  set_currents(world, 0);
  CHECK(world.awake_count() == 1);
  std::size_t woke = 0, snapped = 0, let_go = 0;
  for (int i = 0; i < 200; ++i) {
    REQUIRE(world.step().ok);
    woke += count(world, EventKind::woke);
    snapped += count(world, EventKind::snapped);
  }
  CHECK(woke == 1);
  CHECK(snapped == 1);
  CHECK(state(world, 0).X_WB.p.z > 0.0345);
  set_currents(world, -165);
  for (int i = 0; i < 200; ++i) {
    REQUIRE(world.step().ok);
    let_go += count(world, EventKind::let_go);
  }
  CHECK(let_go == 1);
  CHECK(state(world, 0).X_WB.p.z < 0.0276);
}

TEST_CASE("free spheres turn round after a reversed current, and are drawn again") {
  World world(lifting_scene(1));
  set_currents(world, -250);
  run(world, 0.5);
  CHECK(state(world, 0).X_WB.p.z == doctest::Approx(0.0275).epsilon(0.01));
  CHECK(world.magnet_direction(BodyId{0}, 7).z < -0.9);
}

TEST_CASE("a current that is set again wakes nobody, one that changes wakes what is near") {
  WorldConfig config = lifting_scene(1);
  config.bodies.push_back(block_body(paper_block(), {{0.3, 0, 0.0275 - 1e-5}, {}}));
  World world(config);
  set_currents(world, -165);
  run(world, 1);
  REQUIRE(world.awake_count() == 0);
  set_currents(world, -165);
  CHECK(world.awake_count() == 0);
  set_currents(world, -160);
  CHECK(world.awake_count() == 1);
  CHECK(state(world, 0).awake);
}

TEST_CASE("currents, snaps and spins are part of a checkpoint") {
  WorldConfig config = lifting_scene(1);
  config.magnets = MagnetModel::integrated;
  config.step = 0.001;
  World world(config);
  set_currents(world, 80);
  run(world, 0.05);
  const std::string checkpoint = world.checkpoint();
  World other(config);
  REQUIRE(other.resume(checkpoint));
  CHECK(other.current(BodyId{1}, 2) == 80);
  set_currents(world, -165);
  set_currents(other, -165);
  for (int i = 0; i < 100; ++i) {
    REQUIRE(world.step().ok);
    REQUIRE(other.step().ok);
    REQUIRE(world.hash() == other.hash());
    REQUIRE(world.events() == other.events());
  }
}

TEST_CASE("two blocks snap together, hold, and let go when they are pulled apart") {
  World world(pair_scene(paper_block(), 0.01, 0.2));
  std::vector<WorldEvent> snaps;
  const auto step = [&] {
    REQUIRE(world.step().ok);
    for (const WorldEvent& event : world.events()) {
      if (event.kind == EventKind::snapped || event.kind == EventKind::let_go) {
        snaps.push_back(event);
      }
    }
  };
  while (world.time() < 1) step();
  REQUIRE(snaps.size() == 1);
  CHECK(snaps[0] == WorldEvent{EventKind::snapped, BodyId{0}, BodyId{1}});
  for (int i = 0; i < 40; ++i) {
    world.push(BodyId{0}, {-12, 0, 0}, {});
    world.push(BodyId{1}, {12, 0, 0}, {});
    step();
  }
  REQUIRE(snaps.size() == 2);
  CHECK(snaps[1] == WorldEvent{EventKind::let_go, BodyId{0}, BodyId{1}});
}

TEST_CASE("blocks without magnets touch, and do not snap") {
  World world(column_scene(without_magnets(paper_block()), 2));
  for (int i = 0; i < 20; ++i) {
    REQUIRE(world.step().ok);
    CHECK(count(world, EventKind::snapped) == 0);
  }
}

TEST_CASE("blocks that hang on magnets stay when a touch wakes them in the middle of a step") {
  WorldConfig config = scene_settings({0.5, 0.5});
  config.floor = false;
  for (int i = 0; i < 3; ++i) {
    config.bodies.push_back(block_body(paper_block(), {{i * 0.05499, 0, 1}, {}}));
  }
  config.bodies[0].fixed = true;
  config.bodies.push_back(solid_body(Shape::sphere(0.005), 1e-4, {0.11, 0, 3}));
  World world(config);
  run(world, 0.55);
  REQUIRE(world.awake_count() == 1);
  std::size_t woke = 0;
  while (world.time() < 0.8) {
    REQUIRE(world.step().ok);
    woke += count(world, EventKind::woke);
    // A step without their magnets would let them fall with 49 mm/s.
    CHECK(std::abs(state(world, 1).velocity.z) < 0.01);
    CHECK(std::abs(state(world, 2).velocity.z) < 0.01);
  }
  CHECK(woke == 2);
}
