// SPDX-License-Identifier: MIT
// What a World gets is a plain list of bodies: generators are worked out (spawn_poses.cpp), and
// everything has a number. Numbers follow the file: blocks entry by entry, then robots, then
// obstacles, then what caches and scripts may drop.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>

#include "base/text.h"
#include "physical/scene/scene.h"
#include "physical/scene/spawn_poses.h"

namespace stig::physics {

namespace {

constexpr std::size_t kMostBlocks = 20'000;
constexpr std::size_t kMostReported = 20;

Pose in_frame(const Pose& X_WE, const Pose& X_EB) {
  return {X_WE.p + matrix(X_WE.q) * X_EB.p, normalised(X_WE.q * X_EB.q)};
}

/// How many blocks an entry asks for, without making them: counts come from a file and multiply, so
/// they are checked before any list is made.
std::size_t count_of(const BlockSpawn& spawn) {
  if (spawn.kind == SpawnKind::poses) return spawn.poses.size();
  std::size_t count = 1;
  for (const int n : spawn.count) count *= static_cast<std::size_t>(n);
  return count;
}

class Placer {
 public:
  Placer(const Scene& scene, std::uint64_t seed, Diagnostics& out) : scene_(scene), out_(out) {
    placed_.seed = seed;
    placed_.config = scene.settings;
    materials_.names = scene.materials;
  }

  std::optional<PlacedScene> place() {
    if (!check_count()) return std::nullopt;
    for (std::size_t i = 0; i < scene_.blocks.size(); ++i) add_entry(i);
    for (std::size_t i = 0; i < scene_.robots.size(); ++i) add_robot_entry(i);
    for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) add_obstacle(i);
    check_names();
    if (out_.has_errors()) return std::nullopt;
    add_stock();
    report_problems();
    if (out_.has_errors()) return std::nullopt;
    return std::move(placed_);
  }

 private:
  bool check_count() {
    std::size_t count = 0;
    for (const BlockSpawn& spawn : scene_.blocks) {
      count += count_of(spawn);
      if (count <= kMostBlocks) continue;
      out_.add(Code::S604, spawn.range,
               fmt::format("with this entry there are more than {} blocks", kMostBlocks));
      return false;
    }
    return true;
  }

  void add_entry(std::size_t entry) {
    const BlockSpawn& spawn = scene_.blocks[entry];
    const std::vector<Pose> poses =
        spawn_poses(spawn, scene_.models[spawn.model].side, placed_.seed, entry);
    if (spawn.kind == SpawnKind::scatter && poses.size() < count_of(spawn)) {
      out_.add(
          Code::S605, spawn.range,
          fmt::format("there is room for {} blocks, not for {}", poses.size(), count_of(spawn)));
      return;
    }
    if (spawn.kind == SpawnKind::pyramid && placed_.bodies.size() + poses.size() > kMostBlocks) {
      out_.add(Code::S604, spawn.range, "with this entry there are too many blocks");
      return;
    }
    for (std::size_t i = 0; i < poses.size(); ++i) add_block(entry, i, poses.size(), poses[i]);
  }

  void add_block(std::size_t entry, std::size_t number, std::size_t of, const Pose& X_EB) {
    const BlockSpawn& spawn = scene_.blocks[entry];
    BodyDef def = block_body(scene_.models[spawn.model], in_frame(spawn.X_WE, X_EB));
    def.fixed = spawn.fixed;
    def.velocity = spawn.velocity;
    def.spin = spawn.spin;
    placed_.config.bodies.push_back(std::move(def));
    const std::string name = spawn.name.empty() ? fmt::format("block {}", placed_.bodies.size() + 1)
                             : of == 1          ? spawn.name
                                                : fmt::format("{} {}", spawn.name, number + 1);
    placed_.bodies.push_back({name, spawn.colour, entry});
  }

  void add_robot_entry(std::size_t entry) {
    const RobotSpawn& spawn = scene_.robots[entry];
    const RobotModel& model = scene_.robot_models[spawn.model];
    const Pose X_WR =
        jittered(spawn.X_WR, spawn.jitter, spawn.turn_jitter, placed_.seed, kRobotJitter, entry);
    placed_.robots.push_back(add_robot(placed_.config, model, X_WR, materials_));
    for (const BodyModel& part : model.bodies) {
      placed_.bodies.push_back(
          {spawn.name + "/" + part.name, Led::off, entry, false, part.rgb, false, part.visual});
    }
  }

  void add_obstacle(std::size_t entry) {
    const ObstacleSpawn& spawn = scene_.obstacles[entry];
    add_fixed_together(placed_.config, spawn.bodies, spawn.fixed, materials_);
    for (const BodyModel& body : spawn.bodies) {
      placed_.bodies.push_back({body.name, Led::off, entry, false, body.rgb, true, body.visual});
    }
  }

  void check_cache(const CacheSpawn& cache) {
    const double arena = placed_.config.arena, half = scene_.models[cache.model].side / 2;
    if (std::max({std::abs(cache.at.x), std::abs(cache.at.y), std::abs(cache.at.z)}) > arena) {
      out_.add(Code::S602, cache.range, "the cache drops its blocks outside of the arena");
    } else if (placed_.config.floor && cache.at.z < half - 1e-3) {
      out_.add(Code::S603, cache.range, "the cache drops its blocks in the floor");
    }
  }

  /// Scripts and reports tell blocks and robots by their names. Each pair of entries once.
  void check_names() {
    std::map<std::string_view, const SourceRange*> first;
    std::set<std::pair<const SourceRange*, const SourceRange*>> reported;
    const auto check = [&](std::string_view name, const SourceRange& range) {
      const auto [known, fresh] = first.emplace(name, &range);
      if (fresh || !reported.emplace(known->second, &range).second) return;
      out_.add(Code::R208, range, fmt::format("{} is the name of two things", in_quotes(name)))
          .note(*known->second, "the first of them is here");
    };
    for (const SceneBody& body : placed_.bodies) {
      if (body.block) check(body.name, scene_.blocks[body.entry].range);
      if (body.obstacle) check(body.name, scene_.obstacles[body.entry].range);
    }
    for (const RobotSpawn& robot : scene_.robots) check(robot.name, robot.range);
  }

  /// What caches may drop has a name already, though no place yet.
  void add_stock() {
    std::set<std::string> taken;
    for (const SceneBody& body : placed_.bodies) taken.insert(body.name);
    for (const RobotSpawn& robot : scene_.robots) taken.insert(robot.name);
    std::size_t number = 0;
    const auto add = [&] {
      std::string name;
      do {
        name = fmt::format("cache block {}", ++number);
      } while (taken.count(name) > 0);
      placed_.bodies.push_back({std::move(name), Led::off, 0});
    };
    for (const CacheSpawn& cache : scene_.caches) {
      check_cache(cache);
      for (std::size_t i = 0; i < cache.stock; ++i) add();
    }
    for (std::size_t i = 0; i < scene_.stock; ++i) add();
  }

  void report_problems() {
    std::vector<ConfigProblem> problems = find_problems(placed_.config);
    // Two robots in one place overlap in dozens of parts: once is enough.
    std::set<std::pair<std::size_t, std::size_t>> robots;
    std::erase_if(problems, [&](const ConfigProblem& problem) {
      if (problem.bodies.size() != 2) return false;
      const SceneBody &a = placed_.bodies[problem.bodies[0]],
                      &b = placed_.bodies[problem.bodies[1]];
      return !a.block && !b.block && !a.obstacle && !b.obstacle &&
             !robots.emplace(a.entry, b.entry).second;
    });
    for (std::size_t i = 0; i < problems.size() && i < kMostReported; ++i) report(problems[i]);
    if (problems.size() <= kMostReported) return;
    out_.add(
        Code::S609, first_range(),
        fmt::format("{} more things are where they cannot be", problems.size() - kMostReported));
  }

  SourceRange first_range() const {
    if (!scene_.blocks.empty()) return scene_.blocks.front().range;
    return scene_.robots.empty() ? SourceRange{} : scene_.robots.front().range;
  }

  void report(const ConfigProblem& problem) {
    const auto name = [&](std::uint32_t body) { return "'" + placed_.bodies[body].name + "'"; };
    const auto range = [&](std::uint32_t body) {
      const SceneBody& one = placed_.bodies[body];
      return one.block      ? scene_.blocks[one.entry].range
             : one.obstacle ? scene_.obstacles[one.entry].range
                            : scene_.robots[one.entry].range;
    };
    if (problem.bodies.empty()) {
      // It is about joints, or a solver that cannot have them.
      const bool robots = !placed_.config.joints.empty() && !scene_.robots.empty();
      out_.add(Code::S609, robots ? scene_.robots.front().range : first_range(), problem.what);
    } else if (problem.bodies.size() == 1) {
      const std::uint32_t body = problem.bodies[0];
      const Code code = problem.what == "is outside of the arena" ? Code::S602
                        : problem.what == "is in the floor"       ? Code::S603
                                                                  : Code::S609;
      out_.add(code, range(body), fmt::format("{} {}", name(body), problem.what));
    } else {
      const std::uint32_t first = problem.bodies[0], second = problem.bodies[1];
      out_.add(Code::S601, range(second),
               fmt::format("{} and {} {}", name(first), name(second), problem.what))
          .note(range(first), name(first) + " is from here");
    }
  }

  const Scene& scene_;
  Diagnostics& out_;
  PlacedScene placed_;
  Materials materials_;
};

}  // namespace

std::size_t block_model(const Scene& scene, const PlacedScene& placed, std::size_t body) {
  assert(body < placed.bodies.size());
  // What comes while the scene runs has no entry of its own.
  return body < placed.config.bodies.size() ? scene.blocks[placed.bodies[body].entry].model
                                            : scene.stock_model;
}

std::optional<PlacedScene> place_scene(const Scene& scene, std::uint64_t seed,
                                       Diagnostics& diagnostics) {
  Diagnostics own;
  auto placed = Placer(scene, seed, own).place();
  diagnostics.append(own);
  return placed;
}

}  // namespace stig::physics
