// SPDX-License-Identifier: MIT
// Robots with compasses in a scene: readings by the seed, and resumed runs.
#include <doctest/doctest.h>

#include "physical/robots/crew_support.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr const char* kPost = R"(stigc_robot: 1
name: post
bodies:
  - {name: post, box: [0.1, 0.1, 0.1], mass: 1, base: [0, 0, 0]}
rangefinders:
  - {name: ahead, body: post, at: [0.06, 0, 0.03], look: [1, 0, 0], range: 0.3}
)";
constexpr const char* kCompasses = R"(compasses:
  - {name: exact, body: post}
  - {name: shaky, body: post, noise: 0.1}
  - {name: other, body: post, noise: 0.1}
)";
constexpr const char* kTell = R"(
function step()
  local c = robot.compasses or { exact = {}, shaky = {}, other = {} }
  log(c.exact.heading, ' ', c.shaky.heading, ' ', c.other.heading)
  robot.show.number('ahead', robot.rangefinders.ahead.proximity)
end
)";

LoadedScene posts(const std::string& robot, std::uint64_t seed = 1) {
  return crew_scene(
      "stigc_scene: 1\nnoise: {distance: 0.01}\n"
      "robots: [{file: post.yaml, name: r, program: p.lua, heading: 30}]\n"
      "blocks: [{at: [0.2, 0.1, 0.0275]}]\n",
      {{"post.yaml", robot}, {"p.lua", kTell}}, seed);
}

const std::string kWithCompasses = std::string(kPost) + kCompasses;

}  // namespace

TEST_CASE("a compass tells the heading that the scene gave, with noise by seed, device and tick") {
  const LoadedScene loaded = posts(kWithCompasses);
  Simulation run(loaded.scene, loaded.placed);
  run.until(0.1, {});
  const auto first = run.crew()->readings(0).compasses;
  REQUIRE(first.size() == 3);
  CHECK(first[0].heading == doctest::Approx(30 * 3.14159265358979 / 180).epsilon(1e-6));
  CHECK(first[1].heading != first[0].heading);
  CHECK(first[2].heading != first[1].heading);
  CHECK(std::abs(first[1].heading - first[0].heading) < 0.6);
  run.until(0.3, {});
  CHECK(run.crew()->readings(0).compasses[1].heading != first[1].heading);

  const auto said = [](std::uint64_t seed) {
    return recorded(posts(kWithCompasses, seed), 0.6).said("r");
  };
  CHECK(said(1) == said(1));
  CHECK(said(1) != said(2));
}

TEST_CASE("compasses leave other sensors' noise as it is") {
  const auto shown = [](const std::string& robot) {
    std::vector<std::string> out;
    for (const TraceValue& value : values_of(recorded(posts(robot), 1).trace, "show")) {
      out.push_back(value.bytes);
    }
    return out;
  };
  const auto with = shown(kWithCompasses);
  CHECK(with.size() == 5);
  CHECK(shown(kPost) == with);
}

TEST_CASE("a run with compasses goes on from a checkpoint as it would have") {
  const LoadedScene loaded = posts(kWithCompasses);
  const CrewRun whole = recorded(loaded, 2);
  for (const int tick : {1, 41, 200}) {
    CAPTURE(tick);
    const CrewRun part = recorded(loaded, tick * 0.005);
    Simulation run(loaded.scene, loaded.placed);
    REQUIRE(run.resume(part.state));
    const CrewRun rest = recorded(run, loaded, 2, part.trace);
    CHECK(rest.hash == whole.hash);
    CHECK(rest.trace == whole.trace);
    CHECK(rest.state == whole.state);
  }
  // The state of a robot with other devices is none of this one's.
  const LoadedScene other = posts(kPost);
  Simulation run(other.scene, other.placed);
  CHECK_FALSE(run.resume(recorded(loaded, 1).state));
}
