// SPDX-License-Identifier: MIT
// Controllers in C++ are handed into a run, and get what programs in Lua get: scenes, traces,
// checkpoints, resume, and a comparison of their traces.
#include "physical/scene/controller_factory.h"

#include "physical/robots/crew_support.h"
#include "physical/simulation/verify_trace.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// Drives in bends that depend on what it has counted and seen, and fails at last.
class Weaver final : public RobotController {
 public:
  explicit Weaver(int steps) : steps_(steps) {}
  ControllerStatus init(RobotCommands& commands) override {
    for (auto& camera : commands.camera_enabled) camera = true;
    commands.lift = {LiftCommand::Kind::position, 0.135};
    commands.log.push_back("begun");
    return {};
  }
  ControllerStatus step(const RobotReadings& readings, RobotCommands& commands) override {
    if (++count_ == steps_) return {false, "enough"};
    for (const CameraReading& camera : readings.cameras) seen_ += camera.tags.size();
    const double turn = 0.002 * static_cast<double>((count_ + seen_) % 5);
    commands.wheels = std::pair{turn, -turn};
    commands.user.numbers.emplace_back("steps", count_);
    commands.log.push_back(std::to_string(count_) + " " + std::to_string(seen_));
    return {};
  }

 private:
  int steps_;
  int count_ = 0;
  std::size_t seen_ = 0;  ///< tags
};

/// Shows the number of its step, and sends it.
class Counter final : public BlockController {
 public:
  ControllerStatus init(BlockCommands&) override { return {}; }
  ControllerStatus step(const BlockReadings& readings, BlockCommands& commands) override {
    for (const auto& heard : readings.radios) count_ += heard.size();
    commands.all_leds = static_cast<std::uint8_t>(++count_ % 5);
    for (auto& sends : commands.sends) sends.push_back(std::to_string(count_));
    return {};
  }

 private:
  std::size_t count_ = 0;
};

ControllerFactory in_cpp(int steps = 16) {
  return {
      [steps](const Scene&, const PlacedScene&, std::size_t) {
        return std::make_unique<Weaver>(steps);
      },
      [](const Scene&, const PlacedScene&, std::size_t) { return std::make_unique<Counter>(); }};
}

/// Whether a run that is saved at a tick and resumed ends as one that was not interrupted.
void check_resumed(const LoadedScene& loaded, const ControllerFactory& factory, int tick,
                   double duration, const CrewRun& whole) {
  CAPTURE(tick);
  Simulation first(loaded.scene, loaded.placed, true, factory);
  const CrewRun part = recorded(first, loaded, tick * 0.005);
  Simulation second(loaded.scene, loaded.placed, true, factory);
  REQUIRE(second.resume(part.state));
  CHECK(second.hash() == part.hash);
  const CrewRun rest = recorded(second, loaded, duration, part.trace);
  CHECK(rest.state == whole.state);
  CHECK(rest.trace == whole.trace);
  CHECK(rest.hash == whole.hash);
  CHECK(rest.end == whole.end);
  CHECK(part.lines.size() + rest.lines.size() == whole.lines.size());
}

}  // namespace

TEST_CASE("blocks with controllers in C++, those too that a cache drops, are saved and resumed") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nblocks: [{at: [0, 0, 0.0275]}, {at: [0.0552, 0, 0.0275]}]\n"
      "caches: [{at: [0.5, 0.5, 0.0275]}]\n");
  const ControllerFactory factory = in_cpp();
  Simulation straight(loaded.scene, loaded.placed, true, factory);
  REQUIRE(straight.crew() != nullptr);
  const CrewRun whole = recorded(straight, loaded, 1.6);
  REQUIRE(straight.crew()->blocks() == 3);
  CHECK(straight.crew()->colour(2) == Led::q3);  // nobody talks to it: the eighth step
  CHECK(values_of(whole.trace, "leds").size() > 20);
  for (const int tick : {1, 40, 121, 200}) check_resumed(loaded, factory, tick, 1.6, whole);
}

TEST_CASE("a cache alone may drop blocks with controllers in C++") {
  const LoadedScene loaded = crew_scene("stigc_scene: 1\ncaches: [{at: [0.5, 0.5, 0.0275]}]\n");
  Simulation with(loaded.scene, loaded.placed, true, in_cpp());
  REQUIRE(with.crew() != nullptr);
  CHECK(with.until(0.5, {}) == RunEnd::duration);
  CHECK(with.led(0) == Led::q3);
  const Simulation without(loaded.scene, loaded.placed, true, ControllerFactory{});
  CHECK(without.crew() == nullptr);
}

TEST_CASE("a robot's controller in C++ is resumed at any step, and its trace compared") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nstop: {failed: true}\n"
      "noise: {pixels: 0.5, camera_latency: 1}\n"
      "robots: [{file: bebot.yaml, name: r}]\n"
      "blocks: [{at: [0.25, 0, 0.0275], color: Q3}]\n");
  const ControllerFactory factory = in_cpp();
  Simulation straight(loaded.scene, loaded.placed, true, factory);
  const CrewRun whole = recorded(straight, loaded, 5);
  CHECK(whole.end == RunEnd::failed);
  REQUIRE(whole.failures().size() == 1);
  CHECK(whole.failures()[0].text == "enough");
  const std::vector<std::string> said = whole.said("r");
  REQUIRE(said.size() == 16);
  CHECK(said.front() == "begun");
  CHECK(said.back() != "15 0");  // it saw the block
  CHECK(values_of(whole.trace, "show").size() == 16);
  for (const int tick : {1, 40, 41, 79, 400, 561}) check_resumed(loaded, factory, tick, 5, whole);
  const PoseTrace trace = trace_of(whole.trace);
  CHECK(verify_trace(trace, loaded, {}, factory).identical);
  CHECK_FALSE(verify_trace(trace, loaded, {}, in_cpp(6)).identical);
}

TEST_CASE("a controller in C++ may stand beside programs in Lua") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nrobots:\n"
      "  - {file: bebot.yaml, name: lua, program: p.lua}\n"
      "  - {file: bebot.yaml, name: cpp, program: p.lua, at: [0, 0.5]}\n",
      {{"p.lua", "function step() log(robot.id) end"}});
  ControllerFactory factory = lua_controllers();
  factory.robot = [lua = factory.robot](const Scene& scene, const PlacedScene& placed,
                                        std::size_t robot) -> std::unique_ptr<RobotController> {
    if (scene.robots[robot].name == "cpp") return std::make_unique<Weaver>(100);
    return lua(scene, placed, robot);
  };
  Simulation run(loaded.scene, loaded.placed, true, factory);
  const CrewRun out = recorded(run, loaded, 0.3);
  CHECK(out.said("lua") == std::vector<std::string>{"lua", "lua"});
  CHECK(out.said("cpp") == std::vector<std::string>{"begun", "1 0", "2 0"});
}
