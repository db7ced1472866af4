// SPDX-License-Identifier: MIT
#include "validate/set_up.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/file_io.h"
#include "support.h"
#include "support/golden.h"

namespace stig {
namespace {

/// Robots, blocks and a program that does nothing.
std::optional<std::string> load(const std::string& name, std::size_t most, FileError& error) {
  if (name == kControllerFile) return "function step() end\n";
  return disk_loader(STIG_SOURCE_DIR "/robots", {STIG_SOURCE_DIR "/blocks"})(name, most, error);
}

struct ReadSetUp {
  Diagnostics diagnostics;
  std::optional<Scene> scene;
  std::optional<PlacedScene> placed;

  explicit ReadSetUp(const std::string& text) {
    scene = read_scene(std::make_shared<const SourceFile>("scene.yaml", text), load, diagnostics);
    if (scene) placed = place_scene(*scene, 1, diagnostics);
    INFO(to_text(diagnostics));
    REQUIRE(placed);
  }
};

std::vector<BuildSite> sites_in(const CompiledSet& set, const ReadSetUp& read,
                                Diagnostics& diagnostics) {
  return find_sites(set.rules, *set.compiled.proof.structure, set.compiled.target->floor_level(),
                    *read.scene, *read.placed, diagnostics);
}

TEST_CASE("the set-up of the staircase is the paper's") {
  const CompiledSet set("staircase");
  const std::string text = set_up_scene(set.rules, set.compiled, {});
  check_golden("tests/validate/golden/staircase-scene.yaml", text);
  const ReadSetUp read(text);
  CHECK(read.scene->duration == 2400);
  REQUIRE(read.scene->robots.size() == 1);
  CHECK(length(read.scene->robots[0].X_WR.p) < 1e-9);
  REQUIRE(read.scene->caches.size() == 1);
  CHECK(read.scene->caches[0].at.x == doctest::Approx(0.35));
  Diagnostics diagnostics;
  const auto sites = sites_in(set, read, diagnostics);
  REQUIRE(sites.size() == 1);
  CHECK(length(centre_of(sites[0], {0, 0, 0}) - Vec3{-0.15, 0, 0.0275}) < 1e-9);
  CHECK(length(centre_of(sites[0], {1, 0, 2}) - Vec3{-0.095, 0, 0.1375}) < 1e-9);
}

TEST_CASE("two robots share four sides that follow each other, or are bound to none") {
  const CompiledSet set("stepped-pyramid");
  SetUpRequest request;
  request.robots = 2;
  const std::string fixed = set_up_scene(set.rules, set.compiled, request);
  CHECK(fixed.find("params: {side: \"+x\", sides: \"+x +y\", crew: 2}") != std::string::npos);
  CHECK(fixed.find("params: {side: \"-x\", sides: \"-x -y\", crew: 2}") != std::string::npos);
  request.allocation = Allocation::dynamic_;
  const std::string dynamic = set_up_scene(set.rules, set.compiled, request);
  CHECK(dynamic.find("params: {side: \"+x\", crew: 2}") != std::string::npos);
  CHECK(dynamic.find("params: {side: \"-x\", crew: 2}") != std::string::npos);
  CHECK(dynamic.find("sides:") == std::string::npos);
  request.robots = 5;
  request.structures = 2;
  const SetUpLayout layout = lay_out(set.rules, set.compiled, request);
  REQUIRE(layout.robots.size() == 5);
  for (std::size_t i = 0; i < layout.robots.size(); ++i)
    CHECK(layout.robots[i].crew == (i < 3 ? 3 : 2));
  request.robots = 2;
  for (const auto& robot : lay_out(set.rules, set.compiled, request).robots) CHECK(robot.crew == 0);
}

TEST_CASE("the set-up of the pyramid for four robots") {
  const CompiledSet set("stepped-pyramid");
  SetUpRequest request;
  request.robots = 4;
  const std::string text = set_up_scene(set.rules, set.compiled, request);
  check_golden("tests/validate/golden/pyramid-scene.yaml", text);
  const ReadSetUp read(text);
  REQUIRE(read.scene->robots.size() == 4);
  for (const RobotSpawn& robot : read.scene->robots) {
    CHECK(length(robot.X_WR.p) == doctest::Approx(0.2));
    // Outwards.
    CHECK(dot(rotate(robot.X_WR.q, {1, 0, 0}), robot.X_WR.p) == doctest::Approx(0.2));
  }
  CHECK(read.scene->caches.size() == 4);
  for (const CacheSpawn& cache : read.scene->caches) {
    CHECK(std::hypot(cache.at.x, cache.at.y) == doctest::Approx(0.5));
  }
}

TEST_CASE("robots beyond one a side stand by beside its cache") {
  const CompiledSet set("stepped-pyramid");
  SetUpRequest request;
  request.robots = 13;  // three each, and a fourth on the first side
  const SetUpLayout layout = lay_out(set.rules, set.compiled, request);
  const ReadSetUp read(set_up_scene(set.rules, set.compiled, request));
  REQUIRE(layout.robots.size() == 13);
  REQUIRE(read.scene->robots.size() == 13);
  for (std::size_t i = 0; i < 13; ++i) {
    const SetUpLayout::Robot& robot = layout.robots[i];
    CHECK(robot.standby == static_cast<int>(i / 4));
    CHECK(robot.bound == std::vector{robot.side});
    const auto& params = read.scene->robots[i].params;
    CHECK(params.back().first == "crew");
    CHECK((params[params.size() - 2].first == "standby") == (i >= 4));
    CHECK(std::max(std::abs(robot.at.x), std::abs(robot.at.y)) < layout.arena - 0.2);
    for (std::size_t j = 0; j < i; ++j) CHECK(length(robot.at - layout.robots[j].at) > 0.24);
    // Which direction its side's cache is in, as the robot's program takes it to be.
    const Vec3 cache =
        rotate(conjugate(read.scene->robots[i].X_WR.q), layout.caches[i % 4].at - robot.at);
    if (i < 4) {
      CHECK(std::abs(cache.y) < 1e-5);
    } else {
      CHECK(cache.x == doctest::Approx(i < 12 ? -0.06 : -0.36));
      CHECK(cache.y == doctest::Approx(robot.standby % 2 == 1 ? -0.32 : 0.32));
    }
  }
  request.allocation = Allocation::dynamic_;
  const SetUpLayout shared = lay_out(set.rules, set.compiled, request);
  for (std::size_t i = 0; i < 13; ++i) {
    CHECK(shared.robots[i].standby == layout.robots[i].standby);
    CHECK(length(shared.robots[i].at - layout.robots[i].at) < 1e-9);
    CHECK(shared.robots[i].bound.empty());
  }
}

TEST_CASE("many robots stand apart, and no cache counts blocks of the structure as its own") {
  for (const char* name : {"staircase", "stepped-pyramid"}) {
    const CompiledSet set(name);
    SetUpRequest request;
    request.robots = 12;
    const ReadSetUp read(set_up_scene(set.rules, set.compiled, request));
    CHECK(read.scene->robots.size() == 12);
    Diagnostics diagnostics;
    const auto sites = sites_in(set, read, diagnostics);
    REQUIRE(sites.size() == 1);
    for (const PlacedBrick& brick : set.compiled.proof.structure->bricks()) {
      for (const CacheSpawn& cache : read.scene->caches) {
        const Vec3 away = centre_of(sites[0], brick.at) - cache.at;
        CHECK(std::hypot(away.x, away.y) > cache.radius);
      }
    }
  }
}

TEST_CASE("the start is found wherever a scene has it, and missed where it is not") {
  const CompiledSet set("staircase");
  const auto site_in = [&](const std::string& blocks, Diagnostics& diagnostics) {
    const auto sites = sites_in(set, ReadSetUp("stigc_scene: 1\nblocks:\n" + blocks), diagnostics);
    CHECK(sites.size() < 2);
    return sites.empty() ? std::nullopt : std::optional(sites[0]);
  };
  Diagnostics good, loose, dark, floating;
  const auto site = site_in(
      "  - {at: [1, 2, 0.0275], turn: [100, 0, 0], color: Q3, fixed: true}\n"
      "  - {at: [0, 0, 0.0275], color: Q3}\n",
      good);
  REQUIRE(site);
  CHECK(length(centre_of(*site, {0, 0, 0}) - Vec3{1, 2, 0.0275}) < 1e-9);
  // The nearest of its quarter turns: 10 degrees.
  const double ten = M_PI / 18;
  CHECK(length(centre_of(*site, {1, 0, 0}) -
               Vec3{1 + 0.055 * std::cos(ten), 2 + 0.055 * std::sin(ten), 0.0275}) < 1e-9);
  CHECK_FALSE(site_in("  - {at: [0, 0, 0.0275], color: Q3}\n", loose));
  REQUIRE(loose.all().size() == 1);
  CHECK(loose.all()[0].code == Code::V801);
  CHECK_FALSE(site_in("  - {at: [0, 0, 0.0275], fixed: true}\n", dark));
  CHECK_FALSE(site_in("  - {at: [0, 0, 0.0775], color: Q3, fixed: true}\n", floating));
  REQUIRE(floating.all().size() == 1);
  CHECK(floating.all()[0].code == Code::V801);
  CHECK(floating.all()[0].message.find("50.0 mm over the floor") != std::string::npos);
}

TEST_CASE("every start is found, each with its own lattice, in the scene's order") {
  const CompiledSet set("staircase");
  Diagnostics diagnostics;
  const ReadSetUp read(
      "stigc_scene: 1\nblocks:\n"
      "  - {at: [1, 2, 0.0275], turn: [30, 0, 0], color: Q3, fixed: true}\n"
      "  - {at: [-1, 0, 0.0275], color: Q3, fixed: true}\n");
  const auto sites = sites_in(set, read, diagnostics);
  REQUIRE(sites.size() == 2);
  CHECK(diagnostics.all().empty());
  CHECK(length(sites[0].X_WL.p - Vec3{1, 2, 0.0275}) < 1e-9);
  CHECK(length(centre_of(sites[0], {2, 0, 0}) -
               Vec3{1 + 0.11 * std::cos(M_PI / 6), 2.055, 0.0275}) < 1e-9);
  CHECK(length(centre_of(sites[1], {2, 0, 0}) - Vec3{-0.89, 0, 0.0275}) < 1e-9);
}

TEST_CASE("a fixed block in a structure's cell is a brick of it and begins none") {
  const CompiledSet set("staircase");
  Diagnostics diagnostics;
  // The staircase is along +x; two cells to the other side there is room for another's start.
  const ReadSetUp within(
      "stigc_scene: 1\nblocks:\n"
      "  - {at: [0, 0, 0.0275], color: Q3, fixed: true}\n"
      "  - {at: [0.055, 0, 0.0275], color: Q3, fixed: true}\n");
  CHECK(sites_in(set, within, diagnostics).size() == 1);
  CHECK(diagnostics.all().empty());
}

TEST_CASE("structures that would meet are refused, and starts that are not whole are told") {
  const CompiledSet set("staircase");
  const auto in = [&](const char* at, Diagnostics& diagnostics) {
    return sites_in(set,
                    ReadSetUp("stigc_scene: 1\nblocks:\n"
                              "  - {at: [0, 0, 0.0275], color: Q3, fixed: true}\n"
                              "  - {at: " +
                              std::string(at) + ", color: Q3, fixed: true}\n"),
                    diagnostics);
  };
  Diagnostics near, apart, high;
  // From the last column, two cells off, to the other start: one side of a block, and two.
  CHECK(in("[0.165, 0, 0.0275]", near).empty());
  REQUIRE(near.all().size() == 1);
  CHECK(near.all()[0].code == Code::V803);
  CHECK(near.all()[0].message.find("(0.00, 0.00) and (0.17, 0.00) m") != std::string::npos);
  CHECK(near.all()[0].message.find("55 mm from brick to brick") != std::string::npos);
  CHECK(in("[0.22, 0, 0.0275]", apart).size() == 2);
  CHECK(apart.all().empty());
  CHECK(in("[2, 1, 0.1]", high).size() == 1);
  REQUIRE(high.all().size() == 1);
  CHECK(high.all()[0].code == Code::V804);
  CHECK(high.all()[0].message.find("at (2.00, 1.00) m") != std::string::npos);
}

TEST_CASE("several structures have the room that one has, and robots are dealt out among them") {
  const CompiledSet set("stepped-pyramid");
  SetUpRequest request;
  request.structures = 5;
  request.robots = 11;
  const SetUpLayout layout = lay_out(set.rules, set.compiled, request);
  CHECK(layout.arena == doctest::Approx(4.5));  // three in a row
  CHECK(layout.blocks.size() == 5);
  CHECK(layout.caches.size() == 20);
  REQUIRE(layout.robots.size() == 11);
  std::vector<int> robots(5);
  for (const SetUpLayout::Robot& robot : layout.robots) {
    for (std::size_t i = 0; i < 5; ++i) {
      robots[i] += length(robot.at - layout.blocks[i].centre) < 0.3 ? 1 : 0;
    }
  }
  CHECK(robots == std::vector{3, 2, 2, 2, 2});
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CHECK(length(layout.blocks[i].centre - layout.blocks[j].centre) > 2.999);
    }
  }
  const ReadSetUp read(set_up_scene(set.rules, set.compiled, request));
  Diagnostics diagnostics;
  const auto sites = sites_in(set, read, diagnostics);
  REQUIRE(sites.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(length(sites[i].X_WL.p - layout.blocks[i].centre) < 1e-9);
  }
}

TEST_CASE("with fewer robots than structures there is more time, and one alone is not bound") {
  const CompiledSet set("stepped-pyramid");
  SetUpRequest request;
  request.structures = 3;
  request.robots = 2;
  const std::string text = set_up_scene(set.rules, set.compiled, request);
  CHECK(text.find("duration: 4800\n") != std::string::npos);
  CHECK(text.find("sides:") == std::string::npos);
  CHECK(ReadSetUp(text).scene->robots.size() == 2);
}

}  // namespace
}  // namespace stig
