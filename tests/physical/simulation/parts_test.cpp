// SPDX-License-Identifier: MIT
// The parts of a run, all at work at once, and brought back at once.
#include "physical/simulation/run_part.h"

#include "physical/robots/crew_support.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// A cache of two blocks that the script takes away, a push, a drop, a robot that drives, is
/// put elsewhere and switches its camera on, blocks with programs.
LoadedScene busy_scene() {
  return Scripted::scripted_scene(
      "stock: 1\n"
      "robots: [{file: bebot.yaml, name: r, program: p.lua}]\n"
      "caches: [{at: [0.5, 0.5, 0.0275], stock: 2, jitter: 0.01}]\n"
      "blocks: [{name: a, at: [1, 0, 0.0275], color: Q2}]\n",
      R"(
local calls = 0
function on_step(world)
  calls = calls + 1
  world.measure('calls', calls)
  world.measure('driven', world.robot(1).driven)
  if calls == 2 then world.push('a', vector3(2, 0.5, 0), 0.33) end
  if calls == 3 or calls == 5 then world.place(world.block(2).name, vector3(2, calls, 0.0275)) end
  if calls == 4 then
    log(world.drop(vector3(-1, 0, 0.2)))
    log(world.place('r', vector3(-0.5, 0.1, 0)))
  end
end)",
      {{"p.lua", R"(
local n = 0
function init() robot.camera_system.enable() end
function step()
  n = n + 1
  robot.differential_drive.set_target_velocity(0.1, -0.05)
  robot.show.number('n', n)
  log(n)
end)"}});
}

}  // namespace

TEST_CASE("every part of a run goes on from where it was saved") {
  const LoadedScene loaded = busy_scene();
  Simulation straight(loaded.scene, loaded.placed);
  const CrewRun whole = recorded(straight, loaded, 1.4);
  REQUIRE(straight.world().size() > loaded.placed.config.bodies.size() + 2);
  REQUIRE(straight.driven(0) > 0.02);
  for (const int tick : {1, 40, 41, 79, 97, 121, 161, 200, 279}) {
    CAPTURE(tick);
    Simulation first(loaded.scene, loaded.placed);
    const CrewRun part = recorded(first, loaded, tick * 0.005);
    Simulation second(loaded.scene, loaded.placed);
    REQUIRE(second.resume(part.state));
    CHECK(second.state() == part.state);
    CHECK(second.tally() == first.tally());
    CHECK(second.driven(0) == first.driven(0));
    CHECK(second.measures() == first.measures());
    CHECK(second.hash() == first.hash());
    const CrewRun rest = recorded(second, loaded, 1.4, part.trace);
    CHECK(rest.state == whole.state);
    CHECK(rest.trace == whole.trace);
    CHECK(rest.hash == whole.hash);
    CHECK(rest.tally == whole.tally);
    CHECK(second.driven(0) == straight.driven(0));
    CHECK(second.measures() == straight.measures());
    CHECK(second.world().size() == straight.world().size());
  }
}
