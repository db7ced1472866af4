// SPDX-License-Identifier: MIT
// Robots that carry a block, brought back; robots that talk to each other.

#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.h"
#include "physical/robots/crew_support.h"
#include "physical/simulation/verify_trace.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// Two robots, each with a block under its magnets: picked up, lifted, driven about.
const std::string kScene =
    "noise: {pixels: 0.5, missed_tags: 0.1, camera_latency: 2}\n"
    "robots:\n  - {file: bebot.yaml, name: a, program: p.lua}\n"
    "  - {file: bebot.yaml, name: b, program: p.lua, at: [0, 0.5], heading: 90}\n"
    "blocks:\n  - {name: of a, at: [0.093755, 0, 0.0275]}\n"
    "  - {name: of b, at: [0, 0.593755, 0.0275]}\n";
constexpr const char* kProgram = R"(
local n = 0
function step()
  n = n + 1
  if n == 1 then robot.electromagnet_system.set_discharge_mode('constructive') end
  if n == 8 then robot.lift_system.set_position(0.05) end
  if n > 25 and n % 3 == 0 then
    robot.differential_drive.set_target_velocity(0.06 * math.random(), -0.06 * math.random())
  end
  if n % 5 == 0 then robot.simple_radios.nfc.send { 48 + n % 4 } end
  local tags = robot.camera_system.tags
  if #tags > 0 then log(n, ' ', tags[1].position.x) end
end)";

double height(const Simulation& simulation, std::size_t block) {
  return simulation.world().state(simulation.crew()->block_body(block)).X_WB.p.z;
}

}  // namespace

TEST_CASE("robots that carry blocks, brought back at any tick, go on to the byte") {
  const LoadedScene loaded = crew_scene("stigc_scene: 1\n" + kScene, {{"p.lua", kProgram}});
  Simulation straight(loaded.scene, loaded.placed);
  const CrewRun whole = recorded(straight, loaded, 8);
  for (std::size_t block = 0; block < 2; ++block) CHECK(height(straight, block) > 0.06);
  Random random(1, 0, Purpose::test, 0, 0);
  for (int i = 0; i < 5; ++i) {
    const double at = static_cast<double>(1 + random.below(1599)) * 0.005;
    check_brought_back(loaded, at, 8, whole);
  }
}

TEST_CASE("faults by hand: a block slips, a robot breaks down while it carries") {
  const Scripted out(kScene, R"(
local at
function on_step(world)
  if world.time() == 4 then
    local p = world.block(1).position
    world.measure('carried', p.z)
    log(world.place('of a', vector3(p.x, p.y, 0.0275)))
    world.halt('b')
  end
  if world.time() == 4.4 then at = world.robot(2).position end
end
function on_end(world)
  world.measure('slipped', world.block(1).position.z)
  world.measure('held', world.block(2).position.z)
  world.measure('moved', (world.robot(2).position - at):length())
end)",
                     8, {{"p.lua", kProgram}});
  CHECK(out.run.measures().at("carried") > 0.06);
  CHECK(out.run.measures().at("slipped") < 0.03);
  CHECK(out.run.measures().at("held") > 0.06);
  CHECK(out.run.measures().at("moved") < 1e-4);
  CHECK(std::count(out.said.begin(), out.said.end(), "halted") == 1);
}

TEST_CASE("a block is taken out of a robot's hold by hand, and is on replay") {
  const LoadedScene loaded = crew_scene("stigc_scene: 1\n" + kScene, {{"p.lua", kProgram}});
  std::string bytes;
  Simulation run(loaded.scene, loaded.placed);
  PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                         [&](std::string_view more) { bytes += more; });
  run.record(writer);
  run.until(4, {});
  REQUIRE(height(run, 0) > 0.06);
  HandAction take;
  take.number = static_cast<std::uint32_t>(run.crew()->block_body(0));
  take.at = run.world().state(run.crew()->block_body(0)).X_WB.p + Vec3{0.3, 0.3, 0};
  CHECK(run.intervene(take) == "");
  const RunEnd end = run.until(6, {});
  run.finish(end);
  CHECK(height(run, 0) < 0.03);
  CHECK(height(run, 1) > 0.06);
  const PoseTrace trace = trace_of(bytes);
  CHECK(trace.hands.size() == 1);
  const TraceComparison again = verify_trace(trace, loaded, {});
  CHECK_MESSAGE(again.identical, again.difference);
}

TEST_CASE("robots hear each other by radio, one step later, within the sender's range alone") {
  // 0.3 m is the range of the cart's radio.
  const CrewRun out = recorded(
      crew_scene("stigc_scene: 1\nrobots:\n"
                 "  - {file: gripper_cart.yaml, name: a, program: p.lua}\n"
                 "  - {file: gripper_cart.yaml, name: b, program: p.lua, at: [0, 0.28]}\n"
                 "  - {file: gripper_cart.yaml, name: c, program: p.lua, at: [0, -0.32]}\n",
                 {{"gripper_cart.yaml", shipped("robots/gripper_cart.yaml")}, {"p.lua", R"(
local n = 0
function step()
  n = n + 1
  local talk = robot.simple_radios.talk
  for _, m in ipairs(talk.recv) do log(n, ' ', string.char(table.unpack(m))) end
  if robot.id == 'a' and n == 3 then talk.send('one') talk.send('two') end
  if robot.id == 'b' and n == 5 then talk.send('back') end
  if n == 8 and robot.id ~= 'c' then talk.send('both at once') end
end)"}}),
      1.2);
  CHECK(out.failures().empty());
  CHECK(out.said("a") == std::vector<std::string>{"6 back"});
  CHECK(out.said("b") == std::vector<std::string>{"4 one", "4 two"});
  CHECK(out.said("c").empty());
}
