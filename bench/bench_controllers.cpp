// SPDX-License-Identifier: MIT
// Lua controllers: a step of a small robot's program and of idle blocks, and what their states
// hold (`bytes`). `empty` is the host alone.
#include <benchmark/benchmark.h>

#include "lua/lua_controller.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

RobotModel robot() {
  RobotModel model;
  model.bodies.resize(1);
  model.drive.emplace();
  model.lift.emplace();
  model.magnets.emplace();
  model.cameras = {{"eye", 0, {}, {640, 360, 884, 884, 320, 180}}};
  model.radios = {{"nfc", 0, {}, 0.02}};
  for (int i = 1; i <= 16; ++i) {
    model.rangefinders.push_back({std::to_string(i), 0, {}, {1, 0, 0}, 0.2, {}, {}});
  }
  return model;
}

void run(benchmark::State& state, const char* program, std::size_t tags) {
  LuaController controller({"bench.lua", program}, robot(), {});
  RobotCommands commands;
  RobotReadings readings;
  readings.cameras.resize(1);
  readings.cameras[0].tags.resize(tags);
  readings.rangefinders.assign(16, {0.04, 0});
  readings.radios.resize(1);
  if (!controller.init(commands).ok) state.SkipWithError("init");
  for (auto _ : state) {
    commands = {};
    readings.time += 0.2;
    if (!controller.step(readings, commands).ok) state.SkipWithError("step");
  }
  state.counters["bytes"] = static_cast<double>(controller.memory());
}
BENCHMARK_CAPTURE(run, empty, "function step() end", 0)->Unit(benchmark::kMicrosecond);
constexpr const char* kAvoid = R"(
  function step()
    local near = 0
    for i = 1, 12 do
      local r = robot.rangefinders[tostring(i)]
      if r.proximity < 0.05 then near = near + (i <= 6 and 1 or -1) end
    end
    for i, tag in ipairs(robot.camera_system.tags) do
      if tag.position:length() < 0.1 then near = near + 1 end
    end
    robot.differential_drive.set_target_velocity(0.05 + 0.01 * near, -0.05)
    robot.show.number('near', near)
  end)";
BENCHMARK_CAPTURE(run, avoid, kAvoid, 0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(run, avoid_4_tags, kAvoid, 4)->Unit(benchmark::kMicrosecond);

void block(benchmark::State& state) {
  FileError error;
  const auto program = read_lua_program(STIG_SOURCE_DIR "/blocks/stigmergic.lua", error);
  if (!program) {
    state.SkipWithError("no program");
    return;
  }
  LuaSettings settings;
  settings.limits = block_limits();
  LuaBlockController controller(*program, settings);
  BlockCommands commands;
  BlockReadings readings;
  readings.radios.resize(6);
  if (!controller.init(commands).ok) state.SkipWithError("init");
  for (auto _ : state) {
    commands = {};
    if (!controller.step(readings, commands).ok) state.SkipWithError("step");
  }
  state.counters["bytes"] = static_cast<double>(controller.memory());
}
BENCHMARK(block)->Name("idle_block")->Unit(benchmark::kMicrosecond);

void begin_block(benchmark::State& state) {
  LuaSettings settings;
  settings.limits = block_limits();
  for (auto _ : state) {
    LuaBlockController controller({"b.lua", ""}, settings);
    BlockCommands commands;
    benchmark::DoNotOptimize(controller.init(commands));
    state.counters["bytes"] = static_cast<double>(controller.memory());
  }
}
BENCHMARK(begin_block)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stig::bench
