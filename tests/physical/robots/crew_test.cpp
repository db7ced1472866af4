// SPDX-License-Identifier: MIT
// Robots and blocks with programs in a scene: the order of a tick, messages, failures, caches,
// what the trace holds.
#include "physical/robots/crew.h"

#include <doctest/doctest.h>

#include <cmath>
#include <thread>

#include "physical/render/show_json.h"
#include "physical/robots/crew_support.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// Sends what it is told to at a step, notes what it hears.
class Talker final : public BlockController {
 public:
  Talker(std::uint64_t at, Message message, std::vector<std::string>& heard)
      : at_(at), message_(std::move(message)), heard_(heard) {}
  ControllerStatus init(BlockCommands&) override { return {}; }
  ControllerStatus step(const BlockReadings& readings, BlockCommands& commands) override {
    for (std::size_t face = 0; face < readings.radios.size(); ++face) {
      for (const Message& message : readings.radios[face]) {
        heard_.push_back(std::to_string(readings.tick) + " " + std::to_string(face) + " " +
                         message);
      }
    }
    for (auto& sends : commands.sends) {
      if (readings.tick == at_) sends.push_back(message_);
    }
    return {};
  }

 private:
  std::uint64_t at_;
  Message message_;
  std::vector<std::string>& heard_;
};

/// Two blocks side by side; what each hears when they send at these steps.
std::array<std::vector<std::string>, 2> talk(std::uint64_t first, std::uint64_t second) {
  WorldConfig config = pair_scene(paper_block(), 0.005, 1);
  for (BodyDef& body : config.bodies) body.magnets.clear();
  std::array<std::vector<std::string>, 2> heard;
  CrewConfig crew;
  crew.models = {paper_block()};
  crew.blocks.push_back(
      {"a", BodyId{0}, 0, Led::off, std::make_unique<Talker>(first, "A", heard[0])});
  crew.blocks.push_back(
      {"b", BodyId{1}, 0, Led::off, std::make_unique<Talker>(second, "B", heard[1])});
  Crew team(std::move(crew), config);
  World world(config);
  for (int i = 0; i < 200; ++i) {
    team.before_step(world);
    REQUIRE(world.step().ok);
  }
  return heard;
}

constexpr std::uint64_t kNever = 1000;

/// Says as much as a program may, in every step.
struct Chatterbox final : BlockController {
  ControllerStatus init(BlockCommands&) override { return {}; }
  ControllerStatus step(const BlockReadings& /*readings*/, BlockCommands& commands) override {
    for (auto& sends : commands.sends) sends.assign(64, "a message");
    return {};
  }
};
struct Broken final : BlockController {
  ControllerStatus init(BlockCommands&) override { return {false, "broken"}; }
  ControllerStatus step(const BlockReadings& /*readings*/, BlockCommands&) override { return {}; }
};

/// Bytes of the state of two blocks, of which one talks and the other has this program, after so
/// many control steps.
std::size_t state_beside_chatter(std::unique_ptr<BlockController> listener, int steps) {
  WorldConfig config = pair_scene(paper_block(), 0.005, 1);
  for (BodyDef& body : config.bodies) body.magnets.clear();
  CrewConfig crew;
  crew.models = {paper_block()};
  crew.blocks.push_back({"a", BodyId{0}, 0, Led::off, std::make_unique<Chatterbox>()});
  crew.blocks.push_back({"b", BodyId{1}, 0, Led::off, std::move(listener)});
  Crew team(std::move(crew), config);
  World world(config);
  for (int i = 0; i < steps * 40; ++i) {
    team.before_step(world);
    REQUIRE(world.step().ok);
  }
  return team.state().size();
}

}  // namespace

TEST_CASE("what a block sends reaches the face opposite, in the next step, once") {
  // A's +x face is its radio 0, B's -x face its radio 2.
  const auto one = talk(1, kNever);
  CHECK(one[1] == std::vector<std::string>{"2 2 A"});
  CHECK(one[0].empty());
  const auto both = talk(1, 3);
  CHECK(both[1] == std::vector<std::string>{"2 2 A"});
  CHECK(both[0] == std::vector<std::string>{"4 0 B"});
}

TEST_CASE("a block without a working program keeps a hundred messages of a radio") {
  const std::size_t message = std::string("a message").size() + 1;
  for (const bool there : {false, true}) {
    CAPTURE(there);
    const auto bytes = [there](int steps) {
      return state_beside_chatter(there ? std::make_unique<Broken>() : nullptr, steps);
    };
    // One face hears 64 in each step after the first. Ticks and lengths take a byte more or less.
    const std::size_t grown = bytes(3) - bytes(2);
    CHECK(grown > 35 * message);
    CHECK(grown < 37 * message);
    CHECK(bytes(8) - bytes(3) < message);
  }
}

TEST_CASE("half duplex: who sends does not hear") {
  const auto heard = talk(2, 2);
  CHECK(heard[0].empty());
  CHECK(heard[1].empty());
}

TEST_CASE("robots sense what is, then act, then physics goes on") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nrobots: [{file: bebot.yaml, name: a, program: a.lua}]\n", {{"a.lua", R"(
local n = 0
function step()
  n = n + 1
  log(n, ' ', robot.system.time, ' ', math.abs(robot.differential_drive.encoders.left) > 0.01)
  if n == 3 then robot.differential_drive.set_target_velocity(-0.05, 0.05) end
end)"}});
  Simulation run(loaded.scene, loaded.placed);
  std::vector<double> x;
  RunHooks hooks;
  std::vector<std::string> a;
  hooks.on_line = [&](const CrewLine& line) {
    a.push_back(line.text);
    CHECK(line.tick % 40 == 0);
  };
  hooks.after_step = [&](const World& world) { x.push_back(run.crew()->robot_pose(world, 0).p.x); };
  CHECK(run.until(0.8, hooks) == RunEnd::duration);
  CHECK(a == std::vector<std::string>{"1 0.0 false", "2 0.2 false", "3 0.4 false", "4 0.6 true"});
  CHECK(std::abs(x[79] - x[40]) < 1e-6);
  CHECK(x[119] < x[79] - 1e-3);  // commanded in tick 80
}

TEST_CASE("a robot sets a block's colour by radio, and the trace knows") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nmagnets: {enabled: false}\n"
      "robots: [{file: bebot.yaml, name: r, program: p.lua}]\n"
      "blocks: [{at: [0.0893, 0, 0.0275]}]\n",
      {{"p.lua", R"(
local n = 0
function step()
  n = n + 1
  if n == 3 then robot.simple_radios.nfc.send('2') end
end)"}});
  Simulation run(loaded.scene, loaded.placed);
  const CrewRun out = recorded(run, loaded, 1.2);
  CHECK(run.crew()->colour(0) == Led::q2);
  CHECK(run.led(0) == Led::q2);
  // Sent in the control tick at 0.4 s, read in the next, at 0.6 s.
  const auto leds = values_of(out.trace, "leds");
  REQUIRE(leds.size() == 1);
  CHECK(leds[0].tick == 120);
  CHECK(leds[0].body == 0);
  CHECK(leds[0].bytes == "2");
}

TEST_CASE("robots upon each other are reported, with no block in the scene") {
  Diagnostics diagnostics;
  const std::string two = "stigc_scene: 1\nrobots: [{file: bebot.yaml}, {file: bebot.yaml}]\n";
  CHECK_FALSE(load_scene({{"s.yaml", two},
                          {"bebot.yaml", shipped("robots/bebot.yaml")},
                          {"stigmergic.lua", shipped("blocks/stigmergic.lua")}},
                         1, diagnostics));
  CHECK(to_text(diagnostics).find("bebot 1/lower chassis' and 'bebot 2/lower chassis' overlap") !=
        std::string::npos);
}

TEST_CASE("a program that fails stops its robot alone, and says where") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nrobots:\n"
      "  - {file: bebot.yaml, name: bad, program: bad.lua}\n"
      "  - {file: bebot.yaml, name: good, program: good.lua, at: [0, 0.5]}\n",
      {{"bad.lua", R"(local n = 0
function step()
  n = n + 1
  robot.differential_drive.set_target_velocity(0.1, -0.1)
  if n == 6 then local x = nil; x.y = 1 end
end)"},
       {"good.lua",
        "function step() robot.differential_drive.set_target_velocity(0.1, -0.1) end"}});
  Simulation run(loaded.scene, loaded.placed);
  const CrewRun out = recorded(run, loaded, 2.4);
  REQUIRE(out.failures().size() == 1);
  const CrewLine failure = out.failures()[0];
  CHECK(failure.who == "bad");
  CHECK(failure.tick == 200);
  CHECK(failure.text.starts_with("bad.lua:5: "));
  CHECK(run.crew()->failed(0));
  CHECK_FALSE(run.crew()->failed(1));
  const double bad = run.crew()->robot_pose(run.world(), 0).p.x;
  const double good = run.crew()->robot_pose(run.world(), 1).p.x;
  CHECK(bad < 0.12);
  CHECK(good > 0.2);
  RunHooks none;
  run.until(3, none);
  CHECK(std::abs(run.crew()->robot_pose(run.world(), 0).p.x - bad) < 1e-4);
  CHECK(run.crew()->robot_pose(run.world(), 1).p.x > good + 0.04);
}

TEST_CASE("a cache drops a block when none lies near, has a stock, and waits for room") {
  const auto bodies = [](const std::string& text) {
    const LoadedScene loaded = crew_scene("stigc_scene: 1\n" + text);
    Simulation run(loaded.scene, loaded.placed);
    CHECK(run.until(2, {}) == RunEnd::duration);
    return run.world().size();
  };
  const std::string cache = "caches: [{at: [0.35, 0, 0.0275], radius: 0.1";
  CHECK(bodies(cache + "}]\n") == 1);
  CHECK(bodies(cache + ", stock: 0}]\n") == 0);
  CHECK(bodies(cache + "}]\nblocks: [{at: [0.3, 0, 0.0275]}]\n") == 1);
  // One that slides away makes room for another.
  CHECK(bodies(cache + "}]\nblocks: [{at: [0.35, 0, 0.0275], velocity: [2, 0, 0]}]\n") == 2);
  // Beyond the radius, but in the way.
  CHECK(bodies("caches: [{at: [0.35, 0, 0.0275], radius: 0.03}]\n"
               "blocks: [{at: [0.39, 0, 0.0275], fixed: true}]\n") == 1);
}

TEST_CASE("log lines and what programs show are in the trace; lines that are alike too") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\nrobots: [{file: bebot.yaml, name: r, program: p.lua}]\n", {{"p.lua", R"(
function step()
  log('again')
  robot.show.number('time', math.floor(robot.system.time))
  robot.show.text('mood', 'good')
  robot.show.arrow(vector3(), vector3(0.1, 0, 0), 'red')
end)"}});
  const CrewRun out = recorded(loaded, 2);
  CHECK(out.said("r") == std::vector<std::string>(10, "again"));
  const auto log = values_of(out.trace, "log");
  REQUIRE(log.size() == 10);
  for (std::size_t i = 0; i < log.size(); ++i) {
    CHECK(log[i].bytes == "r: again");
    CHECK(log[i].tick == i * 40);
  }
  const auto show = values_of(out.trace, "show");
  REQUIRE(show.size() == 2);  // once for each new value
  CHECK(show[0].tick == 0);
  CHECK(show[1].tick == 200);
  CHECK(
      show[0].bytes.starts_with(R"({"numbers":{"time":0.0},"texts":{"mood":"good"},"arrows":[[[)"));
  CHECK(show_lines(show[0].bytes, {}).size() == 3);
  CHECK(show_lines("[1, 2", {}).empty());
  CHECK(show_lines(R"({"arrows": [1, [[0], "x", 3], [{}, [], "#ff0000"]]})", {}).size() == 1);
}

TEST_CASE("a robot that leaves the arena is reported, and the run goes on") {
  const LoadedScene loaded = crew_scene(
      "stigc_scene: 1\narena: 0.5\n"
      "robots: [{file: bebot.yaml, name: r, program: p.lua, at: [0.34, 0]}]\n",
      {{"p.lua", R"(
function step()
  robot.differential_drive.set_target_velocity(0.16, -0.16)
  log(robot.system.time)
end)"}});
  const CrewRun out = recorded(loaded, 3);
  CHECK(out.end == RunEnd::duration);
  CHECK_FALSE(out.tally.left.empty());
  CHECK(out.failures().empty());
}

namespace {

constexpr const char* kBusy = R"(
local n = 0
function step()
  n = n + 1
  local turn = math.random() * 0.05
  robot.differential_drive.set_target_velocity(0.08 + turn, -0.08 + turn)
  if n % 3 == 0 then robot.simple_radios.nfc.send(tostring(n % 5)) end
  if n == 2 then robot.lift_system.set_position(0.05) end
  if n == 4 then robot.electromagnet_system.set_discharge_mode('constructive') end
  if n == 5 then robot.camera_system.disable() end
  if n == 7 then robot.camera_system.enable() end
  robot.show.number('n', n + #robot.camera_system.tags)
  if robot.params.fails and n == robot.params.fails then error('enough') end
  log(n, ' ', robot.rangefinders['1'].proximity)
end
)";

constexpr const char* kBusyScene =
    "stigc_scene: 1\n"
    "noise: {pixels: 0.5, missed_tags: 0.1, camera_latency: 2, distance: 0.001, range_latency: 1}\n"
    "robots:\n"
    "  - {file: bebot.yaml, name: a, program: p.lua, at: [0, 0]}\n"
    "  - {file: bebot.yaml, name: b, program: p.lua, at: [0.1, 0.4], heading: 200,"
    " params: {fails: 6}}\n"
    "blocks: [{at: [0.0893, 0, 0.0275]}, {at: [0.3, 0.1, 0.0275], color: Q3}]\n"
    "caches: [{at: [0.5, 0.5, 0.0275]}]\n";

}  // namespace

TEST_CASE("the same bytes each time, and in threads") {
  const LoadedScene loaded = crew_scene(kBusyScene, {{"p.lua", kBusy}});
  const CrewRun first = recorded(loaded, 1.6);
  std::array<std::string, 2> traces;
  std::array<std::uint64_t, 2> hashes{};
  std::array<std::thread, 2> threads;
  for (std::size_t i = 0; i < 2; ++i) {
    threads[i] = std::thread([&, i] {
      Simulation run(loaded.scene, loaded.placed);
      PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                             [&](std::string_view bytes) { traces[i] += bytes; });
      run.record(writer);
      run.finish(run.until(1.6, {}));
      hashes[i] = run.hash();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(traces[i] == first.trace);
    CHECK(hashes[i] == first.hash);
  }
}

TEST_CASE("programs resumed anywhere: the same state, trace and checkpoint as uninterrupted") {
  const LoadedScene loaded = crew_scene(kBusyScene, {{"p.lua", kBusy}});
  const CrewRun whole = recorded(loaded, 2);
  REQUIRE(whole.failures().size() == 1);
  for (const int tick : {1, 40, 81, 200, 241, 397}) {
    CAPTURE(tick);
    const CrewRun part = recorded(loaded, tick * 0.005);
    Simulation run(loaded.scene, loaded.placed);
    REQUIRE(run.resume(part.state));
    CHECK(run.hash() == part.hash);
    const CrewRun rest = recorded(run, loaded, 2, part.trace);
    CHECK(rest.hash == whole.hash);
    CHECK(rest.tally == whole.tally);
    CHECK(rest.state == whole.state);
    CHECK(rest.trace == whole.trace);
    CHECK(part.lines.size() + rest.lines.size() == whole.lines.size());
  }
  // A trace that is longer than the run was at the checkpoint does as well.
  const CrewRun part = recorded(loaded, 1);
  Simulation run(loaded.scene, loaded.placed);
  REQUIRE(run.resume(part.state));
  CHECK(recorded(run, loaded, 2, whole.trace).trace == whole.trace);
}

TEST_CASE("states of other runs and damaged ones are refused or harmless, never a crash") {
  const LoadedScene loaded = crew_scene(kBusyScene, {{"p.lua", kBusy}});
  const std::string state = recorded(loaded, 0.5).state;
  Simulation run(loaded.scene, loaded.placed);
  const std::uint64_t before = run.hash();
  for (const std::size_t size : {std::size_t{0}, state.size() / 2, state.size() - 1}) {
    CHECK_FALSE(run.resume(state.substr(0, size)));
  }
  CHECK_FALSE(run.resume(state + "x"));
  const LoadedScene other = crew_scene("stigc_scene: 1\nblocks: [{at: [0, 0, 1]}]\n");
  CHECK_FALSE(run.resume(recorded(other, 0.5).state));
  CHECK(run.hash() == before);
  for (std::size_t i = 0; i < state.size(); i += 1 + state.size() / 400) {
    std::string bad = state;
    bad[i] = static_cast<char>(bad[i] ^ 0x41);
    Simulation hurt(loaded.scene, loaded.placed);
    // What is taken up is all that was given.
    if (hurt.resume(bad)) CHECK(hurt.state() == bad);
  }
}
