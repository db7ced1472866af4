// SPDX-License-Identifier: MIT
// What scenes become: structures, loose blocks, settings.
#include "physical/scene/scene.h"
#include "physical/scene/block_text.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "physical/scene/poses_file.h"
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

Scene scene_of(const std::string& text, std::vector<SceneFile> files = {}) {
  Diagnostics diagnostics;
  files.push_back({"stigmergic.yaml", block_text()});
  const auto source = std::make_shared<const SourceFile>("s.yaml", "stigc_scene: 1\n" + text);
  auto scene = read_scene(source, memory_loader(std::move(files)), diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(scene);
  return std::move(*scene);
}

PlacedScene place(const Scene& scene, std::uint64_t seed = 1) {
  Diagnostics diagnostics;
  auto placed = place_scene(scene, seed, diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(placed);
  return std::move(*placed);
}

Vec3 at(const PlacedScene& placed, std::size_t i) { return placed.config.bodies[i].X_WB.p; }

bool same_places(const PlacedScene& a, const PlacedScene& b) {
  return std::equal(a.config.bodies.begin(), a.config.bodies.end(), b.config.bodies.begin(),
                    b.config.bodies.end(), [](const BodyDef& x, const BodyDef& y) {
                      return x.X_WB.p == y.X_WB.p && x.X_WB.q == y.X_WB.q;
                    });
}

}  // namespace

TEST_CASE("an empty scene is a scene") { CHECK(place(scene_of("")).bodies.empty()); }

TEST_CASE("settings come from the file, and otherwise are the world's") {
  const Scene scene = scene_of(
      "title: x\nseed: 7\nduration: 3\nstep: 0.002\narena: 5\ngravity: 1.6\nfloor: false\n"
      "friction: {default: 0.3, pairs: [{of: [floor, block], is: 0.1}, {of: [wheel, floor], is: "
      "1}]}\n"
      "magnets: {cutoff: 0.03, relaxation_sweeps: 4}\nsleep: {enabled: false, spin: 90}\n"
      "stop: {asleep: true}\nsolver: stock\n");
  CHECK(scene.title == "x");
  CHECK(scene.settings.solver == SolverKind::stock);
  CHECK(scene_of("solver: fast\n").settings.solver == SolverKind::fast);
  CHECK(scene.seed == 7);
  CHECK(scene.duration == 3);
  CHECK(scene.stop_asleep);
  const WorldConfig& config = scene.settings;
  CHECK(config.step == 0.002);
  CHECK(config.arena == 5);
  CHECK(config.gravity == 1.6);
  CHECK_FALSE(config.floor);
  CHECK(config.friction == 0.3);
  REQUIRE(config.frictions.size() == 3);
  CHECK(config.frictions[0].coefficient == 0.2);  // blocks, as by default
  CHECK(config.frictions[1].coefficient == 0.1);  // in place of the default, either way round
  CHECK(scene.materials == std::vector<std::string>{"block", "floor", "wheel"});
  CHECK(config.frictions[2].a == 2);
  CHECK(config.magnet_cutoff == 0.03);
  CHECK(config.relaxation.sweeps == 4);
  CHECK_FALSE(config.sleep.enabled);
  CHECK(config.sleep.spin == doctest::Approx(1.5707963));
  CHECK(config.sleep.time == SleepRules{}.time);
}

TEST_CASE("a single block: pose, colour, velocity, name") {
  const PlacedScene placed = place(
      scene_of("blocks: [{name: seed, at: [1, 2, 0.5], turn: [90, 0, 0], color: Q3, fixed: true},"
               "{at: [0, 0, 1], velocity: [1, 0, 0], spin: [0, 0, 180]}]"));
  CHECK(placed.bodies[0].name == "seed");
  CHECK(placed.bodies[1].name == "block 2");
  CHECK(placed.bodies[0].colour == Led::q3);
  CHECK(placed.config.bodies[0].fixed);
  CHECK(at(placed, 0) == Vec3{1, 2, 0.5});
  CHECK((matrix(placed.config.bodies[0].X_WB.q) * Vec3{1, 0, 0}).y == doctest::Approx(1));
  CHECK(placed.config.bodies[1].velocity == Vec3{1, 0, 0});
  CHECK(placed.config.bodies[1].spin.z == doctest::Approx(3.14159265));
  CHECK(placed.config.bodies[1].magnets.size() == 8);
}

TEST_CASE("turns are about z, the new y, the new x") {
  const Mat3 m = matrix(turned({90, 90, 0}));
  CHECK((m * Vec3{1, 0, 0}).z == doctest::Approx(-1));
  CHECK((m * Vec3{0, 0, 1}).y == doctest::Approx(1));
}

TEST_CASE("structures stand on the middle of their area, into each other by 10 µm") {
  const PlacedScene column = place(scene_of("blocks: [{column: 3, at: [1, 0, 0]}]"));
  REQUIRE(column.bodies.size() == 3);
  CHECK(at(column, 0).z == doctest::Approx(0.02749));
  CHECK(at(column, 2).z - at(column, 1).z == doctest::Approx(0.05499));
  const PlacedScene wall = place(scene_of("blocks: [{name: w, wall: [4, 2], turn: [90, 0, 0]}]"));
  REQUIRE(wall.bodies.size() == 8);
  CHECK(wall.bodies[7].name == "w 8");
  CHECK(at(wall, 0).y == doctest::Approx(-1.5 * 0.05499));
  CHECK(at(wall, 3).y == doctest::Approx(1.5 * 0.05499));
  CHECK(std::abs(at(wall, 3).x) < 1e-12);
  const PlacedScene pyramid = place(scene_of("blocks: [{pyramid: 3}]"));
  REQUIRE(pyramid.bodies.size() == 15);
  CHECK(at(pyramid, 14).z == doctest::Approx(0.02749 + 2 * 0.05499));
  CHECK(place(scene_of("blocks: [{pyramid: 1}]")).bodies.size() == 1);
}

TEST_CASE("without magnets") {
  const PlacedScene placed = place(scene_of("magnets: {enabled: false}\nblocks: [{column: 2}]"));
  CHECK(placed.config.bodies[0].magnets.empty());
}

TEST_CASE("grids and scatters depend on the seed alone") {
  const Scene scene = scene_of(
      "blocks: [{grid: [3, 2, 2], at: [0, 0, 1], jitter: 0.005, tumble: 20},"
      "{scatter: 60, size: [1, 1, 0]}, {scatter: 40, size: [0.6, 0.6, 0.6], at: [0, 0, 3], turned: "
      "any}]");
  const PlacedScene one = place(scene, 1), again = place(scene, 1), two = place(scene, 2);
  REQUIRE(one.bodies.size() == 112);
  CHECK(same_places(one, again));
  CHECK_FALSE(same_places(one, two));
  // On the floor, upright, anyhow turned about z.
  for (std::size_t i = 12; i < 72; ++i) {
    CHECK(at(one, i).z == doctest::Approx(0.0275));
    CHECK(std::abs(at(one, i).x) <= 0.5);
  }
  for (std::size_t i = 72; i < 112; ++i) CHECK(at(one, i).z > 3.04);
  // place_scene has refused overlaps of more than 1 mm already; these are apart.
  for (std::size_t i = 12; i < 112; ++i) {
    for (std::size_t j = 12; j < i; ++j) CHECK(length(at(one, i) - at(one, j)) > 0.077);
  }
}

TEST_CASE("what is off is so by the seed, and by no more than is said") {
  const Pose pose{{1, 2, 0.5}, rotation({0, 0, 0.3})};
  std::set<double> places;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Pose off = jittered(pose, 0.01, 0.2, seed, kRobotJitter, 3);
    CHECK(std::abs(off.p.x - 1) <= 0.01);
    CHECK(std::abs(off.p.y - 2) <= 0.01);
    CHECK(off.p.z == 0.5);
    CHECK(std::abs(off.q.x) + std::abs(off.q.y) < 1e-12);
    CHECK(std::abs(2 * std::atan2(off.q.z, off.q.w) - 0.3) <= 0.2 + 1e-9);
    CHECK(jittered(pose, 0.01, 0.2, seed, kRobotJitter, 3).p == off.p);
    places.insert(off.p.x);
  }
  CHECK(places.size() == 50);
  CHECK(*places.begin() < 0.995);
  CHECK(*places.rbegin() > 1.005);
  CHECK(jittered(pose, 0, 0, 1, kRobotJitter, 3).q == pose.q);
}

TEST_CASE("poses from a file, in the entry's frame") {
  const Scene scene =
      scene_of("blocks: [{poses: p.csv, at: [1, 0, 0]}]",
               {{"p.csv", "x,y,z,rz,ry,rx\n0,0,0.0275,0,0,0\r\n\n 0.5 ,1, 2,90,0,0\n"}});
  const PlacedScene placed = place(scene);
  REQUIRE(placed.bodies.size() == 2);
  CHECK(at(placed, 1) == Vec3{1.5, 1, 2});
  // All that the scene was read from is kept, for traces.
  REQUIRE(scene.files.size() == 3);
  CHECK(scene.files[0].name == "s.yaml");
  CHECK(scene.files[1].name == "stigmergic.yaml");
  CHECK(scene.files[2].name == "p.csv");
}

TEST_CASE("files of poses have comments, before the names of columns and among the rows") {
  const char* text =
      "# measured, 3 of 5\n\nx,y,z,rz,ry,rx\n0,0,1,0,0,0\n  # 0,0,2,0,0,0\n\t\n0,0,3,0,0,0\n#";
  const PlacedScene placed = place(scene_of("blocks: [{poses: p.csv}]", {{"p.csv", text}}));
  REQUIRE(placed.bodies.size() == 2);
  CHECK(at(placed, 1) == Vec3{0, 0, 3});
  for (const char* bad : {"0,0,1,0,0,0 # behind\n", "0,0,1,0,0,0\nx,y,z,rz,ry,rx\n", "# nothing\n",
                          "x,y,z\nx,y,z\n0,0,1,0,0,0\n"}) {
    CAPTURE(bad);
    Diagnostics diagnostics;
    const auto source = std::make_shared<const SourceFile>("p.csv", bad);
    CHECK_FALSE(read_poses_file(source, diagnostics));
    CHECK(diagnostics.all().size() == 1);
  }
}

TEST_CASE("the shipped scenes can be read and placed") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STIG_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    CAPTURE(entry.path().string());
    ++count;
    FileError error;
    const auto source = std::make_shared<const SourceFile>(
        entry.path().string(), read_file(entry.path().string(), kMaxSceneBytes, error).value());
    Diagnostics diagnostics;
    const auto scene = read_scene(source,
                                  disk_loader(STIG_SOURCE_DIR "/scenes",
                                              {STIG_SOURCE_DIR "/blocks", STIG_SOURCE_DIR "/robots",
                                               STIG_SOURCE_DIR "/programs"}),
                                  diagnostics);
    REQUIRE(scene);
    CHECK_FALSE(scene->title.empty());
    CHECK(place_scene(*scene, scene->seed, diagnostics));
    CHECK(diagnostics.all().empty());
  }
  CHECK(count >= 6);
}
