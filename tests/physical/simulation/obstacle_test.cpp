// SPDX-License-Identifier: MIT
// Obstacles, and solids as obstacles and as parts of robots: what is made of pieces behaves as the
// shape that they make up.
#include "physical/scene/block_text.h"
#include "physical/simulation/loaded_scene.h"
#include "physical/simulation/simulation.h"
#include "physical/simulation/verify_trace.h"
#include "physical/support.h"
#include "robots/solid.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// A box of 0.24 x 0.16 x 0.05 m that stands on its origin, cut across x into so many pieces.
std::string slab_text(int pieces) {
  const Vec3 size{0.24, 0.16, 0.05};
  SolidModel out;
  out.name = "slab";
  out.volume = size.x * size.y * size.z;
  out.centre = {0, 0, size.z / 2};
  out.squares = scaled(size, size) * (1.0 / 12);
  for (int i = 0; i < pieces; ++i) {
    const double low = size.x * i / pieces - size.x / 2, high = low + size.x / pieces;
    out.pieces.emplace_back();
    for (int k = 0; k < 8; ++k) {
      out.pieces.back().push_back({(k & 1) != 0 ? high : low,
                                   (k & 2) != 0 ? size.y / 2 : -size.y / 2,
                                   (k & 4) != 0 ? size.z : 0});
    }
  }
  out.surface = {{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}};
  return print_solid(out, "for a test");
}

constexpr const char* kDrive =
    "function step() robot.differential_drive.set_target_velocity(0.12, -0.09) end\n";

std::string cart_text(const std::string& chassis) {
  return "stigc_robot: 1\nname: cart\ncontrol_period: 0.1\nbodies:\n  - {name: chassis, " +
         chassis + ", mass: 2, base: [0, 0, 0.02]}\n" + R"(
  - {name: left, cylinder: {radius: 0.03, height: 0.012}, mass: 0.1, center: [0.05, 0.1, 0.03],
     turn: [0, 0, -90], material: wheel, axle: [0, 0, 1], rolls_as_sphere: true}
  - {name: right, cylinder: {radius: 0.03, height: 0.012}, mass: 0.1, center: [0.05, -0.1, 0.03],
     turn: [0, 0, -90], material: wheel, axle: [0, 0, 1], rolls_as_sphere: true}
  - {name: caster, sphere: {radius: 0.01}, mass: 0.02, center: [-0.09, 0, 0.01], material: caster}
joints:
  - {parent: chassis, child: left, axes: [{turn: [0, 1, 0], actuator: velocity, most_force: 2}]}
  - {parent: chassis, child: right, axes: [{turn: [0, 1, 0], actuator: velocity, most_force: 2}]}
  - {parent: chassis, child: caster}
differential_drive: {left: [left], right: [right], wheel_radius: 0.03, track: 0.2, most_speed: 0.5}
rangefinders:
  - {name: ahead, body: chassis, at: [0.13, 0, 0.02], look: [1, 0, 0], range: 0.5}
)";
}

LoadedScene yard_of(const std::string& text) {
  Diagnostics diagnostics;
  auto loaded = load_scene({{"s.yaml", "stigc_scene: 1\n" + text},
                            {"stigmergic.yaml", block_text()},
                            {"slab.yaml", slab_text(1)},
                            {"slabs.yaml", slab_text(3)},
                            {"box-cart.yaml", cart_text("box: [0.24, 0.16, 0.05]")},
                            {"slab-cart.yaml", cart_text("solid: slab.yaml")},
                            {"slabs-cart.yaml", cart_text("solid: slabs.yaml")},
                            {"drive.lua", kDrive}},
                           1, diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(loaded);
  return std::move(*loaded);
}

struct YardRun {
  std::vector<Pose> poses;
  std::string trace;
};

YardRun ran_for(const LoadedScene& loaded, double seconds) {
  YardRun out;
  Simulation simulation(loaded.scene, loaded.placed);
  PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                         [&](std::string_view bytes) { out.trace += bytes; });
  simulation.record(writer);
  simulation.finish(simulation.until(seconds, {}));
  for (std::uint32_t i = 0; i < loaded.placed.config.bodies.size(); ++i) {
    out.poses.push_back(simulation.world().state(BodyId{i}).X_WB);
  }
  return out;
}

double way_between(const Pose& a, const Pose& b) { return length(a.p - b.p); }
double turn_between_poses(const Pose& a, const Pose& b) { return angle_of(conjugate(a.q) * b.q); }

/// Blocks let fall, askew and over an edge, and thrown against an obstacle.
std::string blocks_at(const std::string& obstacle) {
  return "blocks:\n  - {name: resting, at: [0.02, 0.01, 0.0975], turn: [20, 0, 0]}\n"
         "  - {name: thrown, at: [-0.4, 0, 0.0275], velocity: [1.5, 0, 0]}\n"
         "  - {name: over, at: [0.1, 0.08, 0.085], turn: [10, 5, 0]}\n"
         "obstacles:\n  - {" +
         obstacle + ", base: [0, 0, 0]}\n";
}

}  // namespace

TEST_CASE("blocks rest on a solid and stop at it as at the box that it is") {
  const YardRun box = ran_for(yard_of(blocks_at("box: [0.24, 0.16, 0.05]")), 1.5);
  for (const char* solid : {"solid: slab.yaml", "solid: slabs.yaml"}) {
    CAPTURE(solid);
    const YardRun ran = ran_for(yard_of(blocks_at(solid)), 1.5);
    // On top, at rest.
    CHECK(ran.poses[0].p.z == doctest::Approx(0.0775).epsilon(2e-3));
    CHECK(way_between(ran.poses[0], box.poses[0]) < 1e-3);
    CHECK(turn_between_poses(ran.poses[0], box.poses[0]) < 0.02);
    // Thrown, it comes no further than the side, and ends within some millimetres of the same
    // place.
    CHECK(ran.poses[1].p.x < -0.12 - 0.0275 + 1e-3);
    CHECK(way_between(ran.poses[1], box.poses[1]) < 5e-3);
    CHECK(std::abs(ran.poses[2].p.z - box.poses[2].p.z) < 1e-3);
  }
}

TEST_CASE("a solid with a mass falls as one body, whatever it is made of") {
  const char* text =
      "obstacles:\n  - {name: a, solid: slabs.yaml, density: 500, base: [0, 0, 0.3], turn: [0, 20, "
      "0]}\n";
  const LoadedScene loaded = yard_of(text);
  REQUIRE(loaded.placed.bodies.size() == 3);
  CHECK(loaded.placed.bodies[0].obstacle);
  CHECK(loaded.placed.bodies[0].name == "a");
  CHECK(loaded.placed.bodies[0].visual->triangles.size() == 1);
  double mass = 0;
  for (const BodyDef& body : loaded.placed.config.bodies) mass += body.mass;
  CHECK(mass == doctest::Approx(500 * 0.24 * 0.16 * 0.05));
  const YardRun ran = ran_for(loaded, 2);
  CHECK(ran.poses[0].p.z == doctest::Approx(0.025).epsilon(0.01));
  for (std::size_t i : {1, 2}) {
    CHECK(way_between(ran.poses[0], ran.poses[i]) < 1e-9);
    CHECK(turn_between_poses(ran.poses[0], ran.poses[i]) < 1e-9);
  }
  // As a box of the same mass does.
  const YardRun box =
      ran_for(yard_of("obstacles:\n  - {name: a, box: [0.24, 0.16, 0.05], density: 500, base: "
                      "[0, 0, 0.3], turn: [0, 20, 0]}\n"),
              2);
  CHECK(way_between(ran.poses[0], box.poses[0]) < 5e-3);
}

TEST_CASE("a robot whose chassis is a solid drives like the one with the box") {
  const auto drive = [](const std::string& name) {
    return ran_for(yard_of("robots:\n  - {file: " + name + ", program: drive.lua}\n"), 4).poses[0];
  };
  const Pose box = drive("box-cart.yaml");
  CHECK(length(box.p) > 0.2);
  for (const char* name : {"slab-cart.yaml", "slabs-cart.yaml"}) {
    CAPTURE(name);
    const Pose solid = drive(name);
    CHECK(way_between(solid, box) < 1e-4);
    CHECK(turn_between_poses(solid, box) < 1e-3);
  }
}

TEST_CASE("a trace brings the solids that its scene and robots name") {
  const LoadedScene loaded = yard_of(
      "robots:\n  - {file: slabs-cart.yaml, program: drive.lua}\nobstacles:\n"
      "  - {name: step, solid: slab.yaml, base: [0.5, 0, 0], color: \"#203040\", material: ice}\n"
      "friction: {pairs: [{of: [ice, wheel], is: 0.1}]}\n");
  const YardRun ran = ran_for(loaded, 1.2);
  CHECK(ran_for(loaded, 1.2).trace == ran.trace);
  Diagnostics diagnostics;
  const auto trace = read_pose_trace("t.stigp", ran.trace, diagnostics);
  REQUIRE_MESSAGE(trace, to_text(diagnostics));
  const auto embedded = load_scene(trace->header.files, trace->header.seed, diagnostics);
  REQUIRE_MESSAGE(embedded, to_text(diagnostics));
  CHECK(verify_trace(*trace, *embedded, {}).identical);
  // The surface is that of the first piece; the others show nothing.
  const auto& bodies = trace->header.bodies;
  CHECK(bodies[0].visual->points.size() == 3);
  CHECK(bodies[4].name == "cart 1/chassis piece 2");
  CHECK(bodies[4].visual->triangles.empty());
  CHECK(bodies[1].visual == nullptr);
  CHECK(bodies.back().name == "step");
  CHECK(bodies.back().rgb == Rgb{0x20, 0x30, 0x40});
  CHECK(bodies.back().fixed);
}

TEST_CASE("an obstacle has a name of its own, and is where nothing else is") {
  const auto said = [](const std::string& text) {
    Diagnostics diagnostics;
    load_scene({{"s.yaml", "stigc_scene: 1\n" + text}, {"stigmergic.yaml", block_text()}}, 1,
               diagnostics);
    return to_text(diagnostics);
  };
  const std::string box = "obstacles:\n  - {name: a, box: [0.1, 0.1, 0.1], base: [0, 0, 0]}\n";
  CHECK(said(box) == "");
  CHECK(said(box + "  - {name: a, box: [0.1, 0.1, 0.1], base: [1, 0, 0]}\n").find("R208") !=
        std::string::npos);
  CHECK(said(box + "blocks: [{at: [0.05, 0, 0.0275]}]\n").find("S601") != std::string::npos);
  CHECK(said("obstacles:\n  - {box: [1, 1, 1], base: [200, 0, 0]}\n").find("S602") !=
        std::string::npos);
  CHECK(said("obstacles:\n  - {box: [1, 1, 1], mass: 1, center: [0, 0, 0]}\n").find("S603") !=
        std::string::npos);
  CHECK(said("obstacles:\n  - {box: [1, 1, 1]}\n").find("P604") != std::string::npos);
  CHECK(said("obstacles:\n  - {solid: none.yaml, base: [0, 0, 0]}\n").find("R001") !=
        std::string::npos);
  CHECK(said("obstacles:\n  - {solid: none.ply, base: [0, 0, 0]}\n").find("P617") !=
        std::string::npos);
}
