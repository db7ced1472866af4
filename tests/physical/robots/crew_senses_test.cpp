// SPDX-License-Identifier: MIT
// What cameras and rangefinders of robots in a scene perceive, and when their programs learn it.
#include <doctest/doctest.h>

#include <set>
#include <string>

#include "physical/robots/crew_support.h"
#include "physical/sensors/range_sensor.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr const char* kLift = R"(
function init() robot.camera_system.enable() robot.lift_system.set_position(0.135) end
function step()
  local tag = robot.camera_system.tags[1]
  if tag then log(string.format('%.4f %d', tag.center.x, robot.camera_system.detect_led(
    vector3(0.02, 0, 0):rotate(tag.orientation) + tag.position))) end
end
)";

std::string view_scene(const std::string& more) {
  return "stigc_scene: 1\nrobots: [{file: bebot.yaml, name: r, program: p.lua}]\n"
         "blocks: [{at: [0.25, 0, 0.0275], color: Q3}]\n" +
         more;
}

}  // namespace

TEST_CASE("lights off: no LED is seen, tags are") {
  const auto seen = [](const std::string& more) {
    const LoadedScene loaded = crew_scene(view_scene(more), {{"p.lua", kLift}});
    const auto said = recorded(loaded, 3).said("r");
    return said.empty() ? std::string() : said.back().substr(said.back().size() - 1);
  };
  CHECK(seen("") == "3");
  CHECK(seen("lights: false\n") == "0");
}

TEST_CASE("cameras are off until enable(), and after disable() nothing arrives any more") {
  // From the second step to the fifth there is something to see.
  const std::string program = R"(
local n = 0
local place
function init() robot.lift_system.set_position(0.135) end
function step()
  n = n + 1
  local camera = robot.camera_system
  local tag = camera.tags[1]
  if tag then place = vector3(0.02, 0, 0):rotate(tag.orientation) + tag.position end
  log(n, ' ', #camera.tags, ' ', place and camera.detect_led(place))
  if n == robot.params.on then camera.enable() elseif n == 4 then camera.disable() end
end)";
  const auto said = [&](const std::string& on, const std::string& more) {
    const std::string scene =
        "stigc_scene: 1\nrobots: [{file: bebot.yaml, name: r, program: p.lua, params: {on: " + on +
        "}}]\nblocks: [{at: [0.25, 0, 0.0275], color: Q3}]\n" + more;
    return recorded(crew_scene(scene, {{"p.lua", program}}), 1.2).said("r");
  };
  CHECK(said("0", "") ==
        std::vector<std::string>{"1 0 nil", "2 0 nil", "3 0 nil", "4 0 nil", "5 0 nil", "6 0 nil"});
  CHECK(said("2", "") ==
        std::vector<std::string>{"1 0 nil", "2 0 nil", "3 2 0", "4 1 3", "5 0 0", "6 0 0"});
  // The third image is on its way when the camera goes off.
  CHECK(said("1", "noise: {camera_latency: 1}\n") ==
        std::vector<std::string>{"1 0 nil", "2 0 nil", "3 1 0", "4 2 0", "5 0 0", "6 0 0"});
}

TEST_CASE("rangefinders that are late read that nothing is there, until the first reading comes") {
  const std::string robot = R"(stigc_robot: 1
name: post
bodies:
  - {name: a, box: [0.1, 0.1, 0.1], mass: 1, base: [0, 0, 0]}
rangefinders:
  - {name: m, body: a, at: [0.06, 0, 0.03], look: [1, 0, 0], range: 0.3}
  - {name: c, body: a, at: [0.06, 0, 0.03], look: [1, 0, 0], range: 0.3, calibration: power, coefficients: [2, 1]}
)";
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nrobots: [{file: post.yaml, name: r, program: p.lua}]\n"
      "noise: {range_latency: 2}\nblocks: [{at: [0.2, 0, 0.0275]}]\n",
      {{"post.yaml", robot}, {"p.lua", R"(
local function say()
  local r = robot.rangefinders
  log(string.format('%.2f %.0f', r.m.proximity, r.c.proximity))
end
init = say
step = say)"}});
  CHECK(recorded(loaded, 0.6).said("r") ==
        std::vector<std::string>{"0.30 0", "0.30 0", "0.30 0", "0.11 2"});
}

TEST_CASE("encoders tell whole counts, whose mean is the speed") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nrobots: [{file: bebot.yaml, name: r, program: p.lua}]\n"
      "noise: {encoder_count: 0.002}\n",
      {{"p.lua", R"(
local function say()
  robot.differential_drive.set_target_velocity(0.0303, -0.0303)
  log(string.format('%.3f', 1000 * robot.differential_drive.encoders.left))
end
init = say
step = say)"}});
  const auto said = recorded(loaded, 20).said("r");
  REQUIRE(said.size() > 90);
  double sum = 0;
  std::set<std::string> seen;
  // The first second is for getting up to speed.
  for (std::size_t i = 5; i < said.size(); ++i) {
    sum += std::stod(said[i]);
    seen.insert(said[i]);
  }
  CHECK(seen == std::set<std::string>{"30.000", "32.000"});
  CHECK(sum / static_cast<double>(said.size() - 5) == doctest::Approx(30.3).epsilon(0.01));
}

TEST_CASE("noise is a function of the seed") {
  const auto said = [](std::uint64_t seed) {
    const LoadedScene loaded =
        crew_scene(view_scene("noise: {pixels: 1}\n"), {{"p.lua", kLift}}, seed);
    return recorded(loaded, 3).said("r");
  };
  const auto one = said(1);
  CHECK(one.size() > 3);
  CHECK(said(1) == one);
  CHECK(said(2) != one);
}

TEST_CASE("robots hide and reflect in their true shapes, not in the boxes or balls about them") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nrobots: [{file: builderbot.yaml, name: r}]\n"
      "caches: [{at: [0, 0.4, 0.0275], stock: 1}]\n",
      {{"builderbot.yaml", shipped("robots/builderbot.yaml")}});
  Simulation run(loaded.scene, loaded.placed);
  const auto distance = [&run](const Vec3& from, const Vec3& way) {
    const SensorScene scene = run.crew()->sensor_scene(run.world());
    return closest_hit(SensorIndex(scene), from, way, 0.3, 12345).value_or(-1);
  };
  // The slanted side of its octagon, x + y = 0.0919239, and a straight one.
  CHECK(distance({0.2, 0.06, 0.07}, {-1, 0, 0}) == doctest::Approx(0.2 - 0.0319239));
  CHECK(distance({0.2, 0.064, 0.07}, {-1, 0, 0}) == doctest::Approx(0.2 - 0.0279239));
  CHECK(distance({-0.2, 0.02, 0.07}, {1, 0, 0}) == doctest::Approx(0.135));
  // A wheel touches the floor as a ball that reaches 1 cm farther to the side than the chassis,
  // in which the wheel itself ends; under the chassis it is as wide as it is.
  CHECK(distance({0.03, 0.2, 0.02}, {0, -1, 0}) == doctest::Approx(0.13));
  CHECK(distance({0.03, 0.2, 0.001}, {0, -1, 0}) == doctest::Approx(0.1325));
  // Blocks that come later are boxes.
  CHECK(distance({0, 0.2, 0.02}, {0, 1, 0}) == -1);
  run.until(1, {});
  REQUIRE(run.crew()->blocks() == 1);
  CHECK(distance({0, 0.2, 0.02}, {0, 1, 0}) == doctest::Approx(0.1725).epsilon(1e-3));
}
