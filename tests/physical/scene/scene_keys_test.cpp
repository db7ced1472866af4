// SPDX-License-Identifier: MIT
// Each key that scene files may have is changed, one at a time: what is read must be another
// scene. settings_test.cpp asks of settings of the world that they change nothing else.
#include "physical/scene/scene_keys.h"

#include <doctest/doctest.h>

#include "physical/dynamics/world_settings.h"
#include "physical/scene/block_text.h"
#include "physical/scene/scene.h"
#include "support/key_changes.h"
#include "support/shown.h"
#include "support/uses.h"

namespace stig {

template <>
struct MembersOf<FrictionPair> {
  static auto of(const FrictionPair& o) { return std::tie(o.a, o.b, o.coefficient); }
};
template <>
struct MembersOf<BlockSpawn> {
  static auto of(const BlockSpawn& o) {
    const auto& [kind, model, name, X_WE, count, pitch, jitter, tumble, size, turned, poses, colour,
                 fixed, velocity, spin, range] = o;
    return std::tie(kind, model, name, X_WE, count, pitch, jitter, tumble, size, turned, poses,
                    colour, fixed, velocity, spin);
  }
};
template <>
struct MembersOf<RobotSpawn> {
  static auto of(const RobotSpawn& o) {
    const auto& [model, name, X_WR, jitter, turn_jitter, program, params, range] = o;
    return std::tie(model, name, X_WR, jitter, turn_jitter, program, params);
  }
};
template <>
struct MembersOf<BodyModel> {
  static auto of(const BodyModel& o) {
    return std::tie(o.name, o.shape, o.size, o.points, o.mass, o.inertia, o.X_RB, o.material,
                    o.rgb);
  }
};
template <>
struct MembersOf<ObstacleSpawn> {
  static auto of(const ObstacleSpawn& o) {
    const auto& [bodies, fixed, range] = o;
    return std::tie(bodies, fixed);
  }
};
template <>
struct MembersOf<CacheSpawn> {
  static auto of(const CacheSpawn& o) {
    const auto& [at, radius, yaw, jitter, turn_jitter, model, stock, range] = o;
    return std::tie(at, radius, yaw, jitter, turn_jitter, model, stock);
  }
};
template <>
struct MembersOf<CameraNoise> {
  static auto of(const CameraNoise& o) {
    const auto& [pixel, missed_tags, missed_leds, false_tags, false_leds, colour, latency] = o;
    return std::tie(pixel, missed_tags, missed_leds, false_tags, false_leds, colour, latency);
  }
};
template <>
struct MembersOf<RangeNoise> {
  static auto of(const RangeNoise& o) { return std::tie(o.distance, o.latency); }
};
template <>
struct MembersOf<EncoderNoise> {
  static auto of(const EncoderNoise& o) { return std::tie(o.count); }
};
// What comes from other files is known by its name.
template <>
struct MembersOf<BlockModel> {
  static auto of(const BlockModel& o) { return std::tie(o.name); }
};
template <>
struct MembersOf<RobotModel> {
  static auto of(const RobotModel& o) { return std::tie(o.name); }
};
template <>
struct MembersOf<LuaProgram> {
  static auto of(const LuaProgram& o) { return std::tie(o.path); }
};
/// Bodies and joints, which scenes have none of, apart.
template <>
struct MembersOf<WorldConfig> {
  static auto of(const WorldConfig& o) {
    std::string all;
    visit_settings(
        [&all](const Setting& setting, const auto& value) { all += setting.path() + shown(value); },
        o);
    return std::tuple(all);
  }
};
template <>
struct MembersOf<Scene> {
  static auto of(const Scene& o) {
    const auto& [source, title, seed, duration, stop_asleep, stop_failed, settings, magnets,
                 materials, models, blocks, robot_models, robots, obstacles, caches, interface,
                 programs, program_keys, block_programs, script, stock, stock_model, lights,
                 camera_noise, range_noise, encoder_noise, files] = o;
    return std::tie(title, seed, duration, stop_asleep, stop_failed, settings, magnets, materials,
                    models, blocks, robot_models, robots, obstacles, caches, interface, programs,
                    block_programs, script, stock, stock_model, lights, camera_noise, range_noise,
                    encoder_noise);
  }
};

namespace {

/// A scene with every key.
constexpr const char* kScene = R"(stigc_scene: 1
title: full
seed: 7
duration: 5
solver: fast
step: 0.004
gravity: 9.7
floor: true
arena: 50
friction: {default: 0.6, pairs: [{of: [block, floor], is: 0.3}]}
damping: 0.1
angular_damping: 0.2
magnets: {enabled: true, cutoff: 0.03, contact: 0.005, relaxation_time: 0.004, relaxation_sweeps: 3,
  model: quasi_static, bearing_damping: 0.1, snap_force: 2}
small_steps: 8
grasps: false
sweeps: 2
sleep: {enabled: true, time: 0.3, speed: 0.003, spin: 3, waking_speed: 0.02, waking_spin: 20, waking_force: 0.2}
stop: {asleep: true, failed: true}
blocks:
  - {name: one, file: block.yaml, at: [0.1, 0.2, 0.3], turn: [10, 20, 30], color: Q1, velocity: [1, 2, 3], spin: [4, 5, 6]}
  - {at: [1, 1, 0.0275], fixed: true}
  - {at: [2, 2, 0], column: 3}
  - {at: [3, 3, 0], wall: [2, 3]}
  - {at: [4, 4, 0], pyramid: 2}
  - {at: [5, 5, 0.1], grid: [2, 3, 4], pitch: 0.1, jitter: 0.01, tumble: 5}
  - {at: [6, 6, 0], scatter: 3, size: [1, 2, 0.3], turned: upright}
  - {at: [7, 7, 0], poses: poses.csv}
robots:
  - {file: robot.yaml, name: first, at: [0.1, 0.2], heading: 30, jitter: 0.01, turn_jitter: 2, program: program.lua,
     params: {side: left}}
  - {file: robot.yaml, at: [0, 3], grid: [2, 3], pitch: 0.5}
obstacles:
  - {name: ramp, hull: [{at: [0, 0, 0]}, {at: [0.1, 0, 0]}, {at: [0, 0.1, 0]}, {at: [0, 0, 0.1]}],
     base: [0.5, 0.6, 0], turn: [10, 20, 30], material: ice, color: "#112233"}
  - {box: [0.1, 0.2, 0.3], center: [1, 2, 3], mass: 2, inertia: [0.01, 0.011, 0.012]}
  - {cylinder: {radius: 0.1, height: 0.2}, base: [1, 3, 3], density: 700}
  - {sphere: {radius: 0.1}, base: [1, 4, 3]}
  - {solid: solid.yaml, base: [1, 5, 3]}
caches:
  - {at: [0.1, 0.2, 0.3], radius: 0.3, yaw: 10, jitter: 0.01, turn_jitter: 2, file: block.yaml, stock: 5}
robot_program: program.lua
block_program: program.lua
interface: 2019
script: program.lua
stock: 6
lights: true
noise: {pixels: 0.1, missed_tags: 0.1, missed_leds: 0.1, false_tags: 0.1, false_leds: 0.1, colour: 1, camera_latency: 1,
  distance: 0.01, range_latency: 1, encoder_count: 0.001}
)";

std::string robot_text(const std::string& name) {
  return "stigc_robot: 1\nname: " + name +
         "\nbodies: [{name: body, box: [0.1, 0.1, 0.1], mass: 1, base: [0, 0, 0]}]\n";
}
std::string block_named(const std::string& name) {
  return "stigc_block: 1\nname: " + name + "\nbody: {side: 0.05, mass: 0.1, friction: 0.5}\n";
}

std::string solid_of_size(double a) {
  return fmt::format(
      "stigc_solid: 1\nname: corner\nvolume: 0.01\ncenter: [0, 0, 0]\ninertia: [1, 1, 1]\npieces:\n"
      "  - corners: [0, 0, 0, {0}, 0, 0, 0, {0}, 0, 0, 0, {0}]\n",
      a);
}

std::optional<std::string> shown_scene(const std::string& text) {
  const std::string program = "function step() end";
  Diagnostics diagnostics;
  const auto scene = read_scene(std::make_shared<const SourceFile>("s.yaml", text),
                                memory_loader({{"stigmergic.yaml", block_text()},
                                               {"block.yaml", block_named("block")},
                                               {"other-block.yaml", block_named("other")},
                                               {"robot.yaml", robot_text("robot")},
                                               {"other-robot.yaml", robot_text("other")},
                                               {"solid.yaml", solid_of_size(0.1)},
                                               {"other-solid.yaml", solid_of_size(0.2)},
                                               {"poses.csv", "0,0,1,0,0,0\n"},
                                               {"other.csv", "0,0,2,0,0,0\n"},
                                               {"program.lua", program},
                                               {"other.lua", program}}),
                                diagnostics);
  return scene ? std::optional(shown(*scene)) : std::nullopt;
}

std::string on_lines(const std::vector<std::string>& texts) {
  return fmt::format("{}", fmt::join(texts, "\n"));
}

}  // namespace

TEST_CASE("every key of a scene's file is read, and is on the page of simulations") {
  const std::vector<std::string> words{"other-block.yaml",
                                       "other-robot.yaml",
                                       "other-solid.yaml",
                                       "other.csv",
                                       "other.lua",
                                       "wheel",
                                       "2021"};
  CHECK(on_lines(unread_keys({kScene}, scene_keys(), words, shown_scene)) == "");
  FileError error;
  const auto page = read_file(STIG_SOURCE_DIR "/docs/simulate.md", 1 << 20, error);
  REQUIRE_MESSAGE(page, error.message);
  CHECK(on_lines(keys_missing_on(*page, scene_keys())) == "");
}

}  // namespace stig
