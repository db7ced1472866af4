// SPDX-License-Identifier: MIT
// What a script does to blocks and robots by hand: places, pushes, halts, colours.
#include <doctest/doctest.h>

#include <cmath>

#include "physical/robots/crew_support.h"
#include "support/uses.h"

using namespace stig;

namespace {

const std::string kBlocks =
    "blocks: [{name: low, at: [0, 0, 0.0275]}, {name: high, at: [0, 0, 0.0825]},\n"
    "         {name: far, at: [1, 0, 0.0275]}]\n";

}  // namespace

TEST_CASE("a script takes a block away, by name, and is told where there is no room") {
  const Scripted out(kBlocks, R"(
function on_step(world)
  if world.time() == 1 then
    log(world.place('low', vector3(1, 0, 0.05)))
    log(world.place('low', vector3(1, 0, 0)))
    log(world.place('low', vector3(1e3, 0, 0)))
    log(world.place('low', vector3(0.5, 0, 0.0275), quaternion(math.pi / 4, vector3(0, 0, 1))))
    log(world.block(1).position.x)
  end
end
function on_end(world)
  world.measure('high', world.block(2).position.z)
  world.measure('turn', 2 * math.acos(world.block(1).orientation.w))
end)",
                     2);
  CHECK(out.said ==
        std::vector<std::string>{"false'low' would overlap 'far'", "falseit would be in the floor",
                                 "falseit would be outside of the arena", "true", "0.5"});
  CHECK(out.run.measures().at("high") == doctest::Approx(0.0275).epsilon(0.001));
  CHECK(out.run.measures().at("turn") == doctest::Approx(0.7854).epsilon(0.001));
}

TEST_CASE("what is fixed stays, a quaternion of any length turns, drops are told why not by name") {
  const Scripted out(
      "stock: 3\nblocks: [{name: rock, at: [0, 0, 0.0275], fixed: true},\n"
      "         {name: cache block 1, at: [1, 0, 0.0275]}]\n",
      R"(
function on_start(world)
  log(world.place('rock', vector3(0.5, 0, 0.0275)))
  log(world.place('cache block 1', vector3(1, 0, 0.0275), quaternion(0, 0, 0, 7)))
  log(world.block(2).orientation.z)
  log(world.drop(vector3(0, 0, 0.05)))
  log(world.drop(vector3(0, 1, 0)))
  log(world.drop(vector3(0, 1e3, 1)))
  log(world.block(world.drop(vector3(0, 1, 0.1))).name)
end)",
      0.1);
  CHECK(out.said ==
        std::vector<std::string>{"falseit is fixed in the world", "true", "1.0",
                                 "nilit would overlap 'rock'", "nilit would be in the floor",
                                 "nilit would be outside of the arena", "cache block 2"});
}

TEST_CASE("a push lasts as long as it says") {
  // Along a floor without friction: v = F t / m.
  const Scripted out(
      "friction: {pairs: [{of: [block, floor], is: 0}]}\n"
      "blocks: [{name: a, at: [0, 0, 0.0275]}, {at: [0, 1, 0.0275]}]\n",
      R"(
local first
function on_start(world)
  world.push('a', vector3(0.1, 0, 0), 0.5)
  world.push_block(2, vector3(0.1, 0, 0))
end
function on_step(world)
  if world.time() == 1 then first = world.block(1).position.x end
  if world.time() == 2 then world.measure('long', world.block(1).position.x - first) end
end
function on_end(world) world.measure('short', world.block(2).position.x) end)",
      3);
  const double mass = 0.110;  // of the paper's block, as its file says
  CHECK(out.run.measures().at("long") == doctest::Approx(0.1 * 0.5 / mass).epsilon(0.02));
  CHECK(out.run.measures().at("short") < 0.02);
}

TEST_CASE("a block's colour changes, and is in the trace") {
  const LoadedScene loaded = Scripted::scripted_scene(kBlocks, R"(
function on_step(world)
  if world.time() == 0.4 then world.set_color('far', 3) end
  if world.time() == 0.6 then log(world.block(3).color .. ' ' .. world.block(2).color) end
end)");
  const CrewRun out = recorded(loaded, 1);
  REQUIRE(out.lines.size() == 1);
  CHECK(out.lines[0].text == "3.0 0.0");
  const auto values = values_of(out.trace, "leds");
  REQUIRE(values.size() == 1);
  CHECK(values[0].bytes == "3");
}

TEST_CASE("nonsense by hand ends the run and says where") {
  const auto message = [](const std::string& call) {
    const Scripted out(kBlocks, "function on_step(world) " + call + " end", 1);
    CHECK(out.run.script_failed());
    return out.run.message();
  };
  CHECK(message("world.place('nobody', vector3())").find("nothing is called 'nobody'") !=
        std::string::npos);
  CHECK(message("world.place('low', 3)").find("position") != std::string::npos);
  CHECK(
      message("world.place('low', vector3(0, 0, 1), quaternion(0, 0, 0, 0))").find("orientation") !=
      std::string::npos);
  CHECK(message("world.push('low', vector3(1, 0, 0), -1)").find("seconds") != std::string::npos);
  CHECK(message("while true do world.push('low', vector3(), 9) end").find("too many pushes") !=
        std::string::npos);
  CHECK(message("world.halt('low')").find("'low' is no robot") != std::string::npos);
  CHECK(message("world.set_color('low', 5)").find("color") != std::string::npos);
}

namespace {

const std::string kDrives = R"(
function step()
  robot.differential_drive.set_target_velocity(0.1, -0.1)
  robot.simple_radios[next(robot.simple_radios)].send('x')
end)";
const std::string kRobot =
    "robots: [{file: bebot.yaml, name: r, program: p.lua, at: [0, 0]}]\n"
    "blocks: [{name: b, at: [0, 1, 0.0275]}]\n";

}  // namespace

TEST_CASE("a robot is put elsewhere, turned, and drives on from there") {
  const Scripted out(kRobot, R"(
function on_step(world)
  if world.time() == 1 then
    log(world.place('r', vector3(0, 1, 0)))
    log(world.place('r', vector3(2, 0, 0), quaternion(math.pi / 2, vector3(0, 0, 1))))
    log(world.robot(1).position.x)
  end
end
function on_end(world)
  world.measure('x', world.robot(1).position.x)
  world.measure('y', world.robot(1).position.y)
  world.measure('driven', world.robot(1).driven)
end)",
                     2, {{"p.lua", kDrives}});
  REQUIRE(out.said.size() == 3);
  CHECK(out.said[0].find("would overlap 'b'") != std::string::npos);
  CHECK(out.said[1] == "true");
  CHECK(out.said[2] == "2.0");
  CHECK(out.run.measures().at("x") == doctest::Approx(2).epsilon(0.005));
  CHECK(out.run.measures().at("y") == doctest::Approx(0.1).epsilon(0.1));
  CHECK(out.run.measures().at("driven") == doctest::Approx(0.19).epsilon(0.1));
}

TEST_CASE("a robot that is halted stands from then on, and is said to be") {
  const Scripted out(kRobot + "stop: {failed: true}\n", R"(
local at
function on_step(world)
  if world.time() == 1 then world.halt('r') world.halt('r') end
end
function on_end(world)
  world.measure('halted', world.robot(1).halted and world.robot(1).failed and 1 or 0)
end)",
                     2, {{"p.lua", kDrives}});
  CHECK(out.end == RunEnd::failed);
  CHECK(out.said == std::vector<std::string>{"halted"});
  CHECK(out.run.measures().at("halted") == 1);
}
