// SPDX-License-Identifier: MIT
// A scene: what stands where when a simulation begins, as a file says it.
//
//     Diagnostics diagnostics;
//     const auto scene = read_scene(source, disk_loader("scenes", {"blocks"}), diagnostics);
//     const auto placed = place_scene(*scene, scene->seed, diagnostics);
//     World world(placed->config);
//
// Two forms, as with rule sets: Scene is what the author wrote, with generators ("a column
// of ten") and source ranges; PlacedScene is what a World runs on, every body in its place.
// Only the second depends on the seed. Each list of things that a scene may have is a
// member of its own, so that more kinds of things leave what is there as it is.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/file_io.h"
#include "lua/lua_settings.h"
#include "physical/dynamics/world_config.h"
#include "physical/robots/led.h"
#include "physical/robots/robot_body.h"
#include "physical/scene/uses.h"
#include "physical/sensors/sensor_noise.h"
#include "robots/block.h"

namespace stig::physics {

/// How one entry of `blocks` becomes blocks.
enum class SpawnKind : std::uint8_t { single, column, wall, pyramid, grid, scatter, poses };

/// How scattered blocks are turned: not at all, about z, or anyhow.
enum class ScatterTurn : std::uint8_t { none, upright, any };

struct BlockSpawn {
  SpawnKind kind = SpawnKind::single;
  std::size_t model = 0;  ///< in Scene::models
  std::string name;       ///< empty: blocks get numbers
  /// The entry's frame: a single block's centre; of anything else the middle of the area
  /// that it stands on.
  Pose X_WE;
  std::array<int, 3> count{1, 1, 1};  ///< along x, y, z; of a pyramid: layers in z
  double pitch = 0;                   ///< m between centres of a grid; 0: 1.8 sides
  double jitter = 0;                  ///< m, most by which a grid's places are off in x and y
  double tumble = 0;                  ///< rad, most by which its blocks are turned
  Vec3 size;                          ///< m, of the box that blocks are scattered in
  ScatterTurn turned = ScatterTurn::upright;
  std::vector<Pose> poses;  ///< in the entry's frame
  Led colour = Led::off;
  bool fixed = false;
  Vec3 velocity, spin;  ///< m/s, rad/s, world frame
  SourceRange range;
};

struct RobotSpawn {
  std::size_t model = 0;  ///< in Scene::robot_models
  std::string name;
  Pose X_WR;
  double jitter = 0, turn_jitter = 0;  ///< m and rad, most by which it stands off
  std::size_t program = kNoProgram;    ///< in Scene::programs
  std::vector<std::pair<std::string, LuaValue>> params;
  SourceRange range;

  static constexpr std::size_t kNoProgram = SIZE_MAX;
};

/// A body that is neither block nor robot.
struct ObstacleSpawn {
  std::vector<BodyModel> bodies;  ///< the body, and pieces that are fixed to it; robot frame: world
  bool fixed = true;              ///< it has no mass, and nothing moves it
  SourceRange range;
};

/// A place where blocks come from: when none lies within `radius`, a new one is dropped.
struct CacheSpawn {
  Vec3 at;  ///< where it is dropped; the radius is measured on the floor
  double radius = 0.35;
  double yaw = 0;                      ///< rad
  double jitter = 0, turn_jitter = 0;  ///< m and rad, most by which each block is off
  std::size_t model = 0;               ///< in Scene::models
  std::size_t stock = 100;             ///< blocks that it has
  SourceRange range;
};

/// A text that the scene was read from, under the name by which the scene calls it.
struct SceneFile {
  std::string name, text;
};

struct Scene {
  SourceRef source;
  std::string title;
  std::uint64_t seed = 1;
  double duration = 10;      ///< s
  bool stop_asleep = false;  ///< it ends as soon as nothing is awake
  bool stop_failed = false;  ///< it ends as soon as every robot's program has failed
  WorldConfig settings;      ///< without bodies
  bool magnets = true;       ///< false: no block has any
  /// By number; robots' bodies name theirs.
  std::vector<std::string> materials{"block", "floor"};
  std::vector<BlockModel> models;
  std::vector<BlockSpawn> blocks;
  std::vector<RobotModel> robot_models;
  std::vector<RobotSpawn> robots;
  std::vector<ObstacleSpawn> obstacles;
  std::vector<CacheSpawn> caches;
  InterfaceLevel interface = InterfaceLevel::of_2021;  ///< that its programs were written for
  std::vector<LuaProgram> programs;
  std::vector<SourceRange> program_keys;        ///< of each, what names it first
  std::vector<std::size_t> block_programs;      ///< in `programs`, one for each of `models`
  std::size_t script = RobotSpawn::kNoProgram;  ///< in `programs`, of the experiment
  std::size_t stock = 0;                        ///< blocks that the script may drop
  std::size_t stock_model = 0;                  ///< of those and of what caches drop
  bool lights = true;                           ///< false: no LED shines
  CameraNoise camera_noise;
  RangeNoise range_noise;
  EncoderNoise encoder_noise;
  std::vector<SceneFile> files;  ///< the scene's own first
};

/// What a viewer knows of a body besides its shape.
struct SceneBody {
  std::string name;
  Led colour = Led::off;
  std::size_t entry = 0;   ///< in Scene::blocks, Scene::robots or Scene::obstacles
  bool block = true;       ///< otherwise part of a robot or an obstacle
  Rgb rgb{176, 180, 186};  ///< of such a part
  bool obstacle = false;
  std::shared_ptr<const VisualMesh> visual = {};  ///< what is looked at, in place of the shape
};

struct PlacedScene {
  WorldConfig config;
  /// As config.bodies, and after them those that caches may drop, in the order in which they
  /// come, whichever cache it is.
  std::vector<SceneBody> bodies;
  std::vector<RobotBody> robots;  ///< as Scene::robots
  std::uint64_t seed = 1;
};

/// The model of the block that is that body, by its number in Scene::models.
std::size_t block_model(const Scene& scene, const PlacedScene& placed, std::size_t body);

/// Finds the text of a file by the name that a scene has for it.
using SceneLoader = FileLoader;
/// Looks beside the scene, then in the folders given.
SceneLoader disk_loader(std::string scene_folder, std::vector<std::string> folders);
/// Knows these files and no others.
SceneLoader memory_loader(std::vector<SceneFile> files);

inline constexpr std::size_t kMaxSceneBytes = std::size_t{1} << 20;

/// The scene, or nothing when an error was reported.
std::optional<Scene> read_scene(SourceRef source, const SceneLoader& load,
                                Diagnostics& diagnostics);
/// A pose off by at most `jitter` m in x and y and `turn` rad about z, by the seed; `entry` and
/// `number` tell cases apart.
Pose jittered(const Pose& pose, double jitter, double turn, std::uint64_t seed, std::uint32_t entry,
              std::uint64_t number);
/// Entries of `jittered` for what a scene has lists of.
inline constexpr std::uint32_t kRobotJitter = 1U << 24, kCacheJitter = 2U << 24;

/// Every block in its place; what cannot be (blocks that overlap, too many of them, outside
/// of the arena) is reported at the entries concerned.
std::optional<PlacedScene> place_scene(const Scene& scene, std::uint64_t seed,
                                       Diagnostics& diagnostics);

/// JSON Schema draft 7 of scene files, with a newline at the end.
std::string scene_schema();

}  // namespace stig::physics
