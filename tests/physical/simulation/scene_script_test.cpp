// SPDX-License-Identifier: MIT
// Scripts of experiments: what they see, change, measure, and how they fail.
#include <doctest/doctest.h>

#include "physical/robots/crew_support.h"
#include "physical/simulation/verify_trace.h"
#include "support/uses.h"

using namespace stig;

TEST_CASE("callbacks: once, at each control tick, once; they see blocks, colours and cells") {
  const Scripted out("blocks: [{name: c, column: 2, color: Q3}, {at: [1, 0, 0.0275]}]\n", R"(
local steps = 0
function on_start(world) log('start ', world.time(), ' ', world.seed(), ' ', world.blocks()) end
function on_step(world) steps = steps + 1 end
function on_end(world)
  for i = 1, world.blocks() do
    local b = world.block(i)
    log(b.name, ' ', b.color, ' ', b.lattice, ' ', b.z, ' ', b.left)
  end
  world.measure('steps', steps)
  world.measure('height', world.block(2).position.z)
end)",
                     1);
  CHECK(out.end == RunEnd::duration);
  CHECK(out.said == std::vector<std::string>{"start 0.0 1 3", "c 1 3.0 1.0 0.0 false",
                                             "c 2 3.0 1.0 1.0 false", "block 3 0.0 nil nil false"});
  CHECK(out.run.measures().at("steps") == 5);
  CHECK(out.run.measures().at("height") == doctest::Approx(0.0825).epsilon(0.001));
}

TEST_CASE("a script drops blocks from the scene's stock, pushes, and stops the run") {
  const Scripted out("stock: 1\n", R"(
function on_step(world)
  if world.time() == 0 then
    log(world.drop(vector3(0, 0, 0.1)))
    log(world.drop(vector3(0.2, 0, 0.1)))
  end
  if world.time() > 0.9 then
    world.push_block(1, vector3(200, 0, 0))
    world.stop('enough')
  end
end)",
                     5);
  CHECK(out.said == std::vector<std::string>{"1", "nilthe scene's stock is used up"});
  CHECK(out.end == RunEnd::script);
  CHECK(out.run.message() == "enough");
  CHECK(out.run.world().time() == doctest::Approx(1));
  CHECK(out.run.world().size() == 1);
  CHECK_FALSE(out.run.script_failed());
}

TEST_CASE("a script that fails, loops or is given nonsense ends the run and says where") {
  const auto message = [](const std::string& script) {
    const Scripted out("blocks: [{at: [0, 0, 0.0275]}]\n", script, 1);
    CHECK(out.end == RunEnd::script);
    CHECK(out.run.script_failed());
    return out.run.message();
  };
  CHECK(message("x = 1\nfunction on_step(world) world.block(2) end").starts_with("e.lua:2: "));
  CHECK(message("function on_step(world) while true do end end").find("e.lua:1") == 0);
  CHECK(message("function on_step(").starts_with("e.lua:1: "));
  CHECK(message("on_start = 3").find("must be a function") != std::string::npos);
  CHECK(message("function on_step(w) w.push_block(1, 3) end").find("force") != std::string::npos);
  CHECK(message("function on_step(w) robot.id = 3 end").find("robot") != std::string::npos);
}

TEST_CASE("a run with a script that is brought back goes on as if it had never stopped") {
  const LoadedScene loaded =
      Scripted::scripted_scene("stock: 2\nblocks: [{name: a, at: [1, 0, 0.0275]}]\n", R"(
local seen, moves = 0, 0
function on_start(world) seen = world.blocks() end
function on_step(world)
  local one = world.block(1)
  if one.position.x > 0.9 and math.random() < 0.3 then
    moves = moves + 1
    log(world.place('a', vector3(0.95, 0.1 * moves, 0.0275)))
  end
  if world.time() == 0.8 then
    log(world.drop(vector3(0, 0, 0.3), math.random()))
    world.push('a', vector3(1, 0, 0), 0.7)
    world.set_color('a', 2)
  end
  if world.time() == 1 then log(world.place('a', vector3(0, 0, 0.0275))) end
  world.measure('seen', seen + moves)
  if world.time() > 2.5 then world.stop('far enough') end
end)");
  Simulation straight(loaded.scene, loaded.placed);
  const CrewRun whole = recorded(straight, loaded, 3);
  REQUIRE(whole.end == RunEnd::script);
  REQUIRE(whole.lines.size() > 3);
  for (const double at : {0.1, 0.8, 1.015, 1.6, 2.6}) {
    CAPTURE(at);
    Simulation first(loaded.scene, loaded.placed);
    const CrewRun half = recorded(first, loaded, at);
    Simulation second(loaded.scene, loaded.placed);
    REQUIRE(second.resume(half.state));
    const CrewRun rest = recorded(second, loaded, 3, half.trace);
    CHECK(rest.end == RunEnd::script);
    CHECK(second.message() == "far enough");
    CHECK(second.measures() == straight.measures());
    CHECK(rest.hash == whole.hash);
    CHECK(rest.state == whole.state);
    CHECK(rest.trace == whole.trace);
  }
}

TEST_CASE("a run that its script changed to its last word is run again and compared") {
  for (const char* end : {"world.stop('enough')", "error('x')", "log('no end')"}) {
    CAPTURE(end);
    const LoadedScene loaded = Scripted::scripted_scene(
        "block_program: b.lua\nstock: 2\nblocks: [{name: a, at: [1, 0, 0.0275]}]\n",
        std::string("function on_step(world) if world.time() == 1 then world.drop(vector3(0, 0, "
                    "1)) ") +
            end + " end end\nfunction on_end(world) world.place('a', vector3(2, 0, 1)) end",
        {{"b.lua", "function step() robot.simple_radios.north.send('x') end"}});
    Simulation run(loaded.scene, loaded.placed);
    std::string bytes;
    PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                           [&](std::string_view some) { bytes += some; });
    run.record(writer);
    const RunEnd why = run.until(1.5, {});
    run.end_script({});
    run.finish(why);
    Diagnostics diagnostics;
    const auto trace = read_pose_trace("t.stigp", bytes, diagnostics);
    REQUIRE(trace);
    const TraceComparison report = verify_trace(*trace, loaded, {});
    CHECK(report.identical);
    CHECK(report.difference == "");
  }
}

TEST_CASE("answers that a script did not ask for bring nothing back") {
  const auto scene = [](const char* call) {
    return Scripted::scripted_scene("blocks: [{name: a, at: [1, 0, 0.0275]}]\n",
                                    std::string("function on_step(world) ") + call + " end");
  };
  const LoadedScene loaded = scene("world.time()"), other = scene("world.block(1)");
  Simulation run(loaded.scene, loaded.placed);
  const CrewRun half = recorded(run, loaded, 0.1);
  Simulation wrong(other.scene, other.placed);
  CHECK_FALSE(wrong.resume(half.state));
  CHECK(wrong.world().tick() == 0);
}

TEST_CASE("scripts and blocks' programs require what stands beside them") {
  const Scripted out("block_program: b.lua\nblocks: [{at: [1, 0, 0.0275]}]\n",
                     "local help = require 'help'\n"
                     "function on_start(world) log(help.word()) end\n",
                     0.1,
                     {{"help.lua", "return {word = function() return 'hello' end}"},
                      {"b.lua",
                       "local help = require 'help'\nfunction init() log(help.word()) end\n"
                       "function step() end"}});
  CHECK(out.said == std::vector<std::string>{"hello", "hello"});
}

TEST_CASE("blocks that talk build a line and a triangle") {
  const LoadedScene loaded =
      crew_scene(shipped("scenes/talking-blocks.yaml"),
                 {{"talking-blocks.lua", shipped("scenes/talking-blocks.lua")},
                  {"talking.lua", shipped("blocks/talking.lua")}});
  Simulation run(loaded.scene, loaded.placed);
  CHECK(run.until(60, {}) == RunEnd::script);
  run.end_script({});
  CHECK(run.message() == "nothing is offered any more");
  CHECK(run.measures().at("largest") == 10);
  CHECK(run.measures().at("second") == 4);
}

TEST_CASE("robots in rows; a run ends when all programs have failed; ways are measured") {
  const std::string scene =
      "stigc_scene: 1\nstop: {failed: true}\nscript: e.lua\n"
      "robots: [{file: bebot.yaml, name: r, program: p.lua, grid: [2, 1], pitch: 1}]\n";
  const LoadedScene loaded = crew_scene(scene, {{"p.lua", R"(
local n = 0
function step()
  n = n + 1
  robot.differential_drive.set_target_velocity(0.1, -0.1)
  if n == 11 then error('done') end
end)"},
                                                {"e.lua", R"(
function on_step(world)
  world.measure('robots', world.robots())
  world.measure('x', world.robot(1).position.x)
end)"}});
  Simulation run(loaded.scene, loaded.placed);
  CHECK(run.until(10, {}) == RunEnd::failed);
  CHECK(run.world().time() == doctest::Approx(2));
  REQUIRE(run.crew()->robots() == 2);
  CHECK(run.crew()->robot_name(1) == "r 2");
  CHECK(run.driven(0) == doctest::Approx(0.19).epsilon(0.1));
  CHECK(run.measures().at("robots") == 2);
  CHECK(run.measures().at("x") > -0.4);
}
