// SPDX-License-Identifier: MIT
// Generators are worked out here and nowhere else: what a World gets is a plain list of bodies.
// Everything that is random is a function of the seed, the entry and the block's number, so that an
// entry which is added to a scene moves no block of another. Body numbers follow the file: blocks
// entry by entry, then robots, then what caches and scripts may drop.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "base/random.h"
#include "base/text.h"
#include "physical/scene/scene.h"

namespace stig::physics {

namespace {

constexpr std::size_t kMostBlocks = 20'000;
constexpr std::size_t kMostReported = 20;
// Bodies at rest overlap a little, within the solver's slop; begun apart they would first fall.
constexpr double kInto = 10e-6;  ///< m, that neighbours overlap: as they would lie at rest
constexpr double kTurn = 2 * 3.14159265358979323846;

Pose in_frame(const Pose& X_WE, const Pose& X_EB) {
  return {X_WE.p + matrix(X_WE.q) * X_EB.p, normalised(X_WE.q * X_EB.q)};
}

/// The blocks of a lattice whose lowest layer stands on the entry's area.
template <class Wanted>
std::vector<Pose> lattice_poses(double side, const std::array<int, 3>& from,
                                const std::array<int, 3>& to, double shift_x, Wanted wanted) {
  const double pitch = side - kInto;
  std::vector<Pose> out;
  for (int z = from[2]; z < to[2]; ++z) {
    for (int y = from[1]; y < to[1]; ++y) {
      for (int x = from[0]; x < to[0]; ++x) {
        if (!wanted(x, y, z)) continue;
        out.push_back({{(x + shift_x) * pitch, y * pitch, side / 2 - kInto + z * pitch}, {}});
      }
    }
  }
  return out;
}

std::vector<Pose> wall_poses(const BlockSpawn& spawn, double side) {
  return lattice_poses(side, {0, 0, 0}, spawn.count, -(spawn.count[0] - 1) / 2.0,
                       [](int, int, int) { return true; });
}

/// Each layer loses its outermost blocks; three layers are the paper's nine, five and one.
std::vector<Pose> pyramid_poses(const BlockSpawn& spawn, double side) {
  const int layers = spawn.count[2], half = layers / 2;
  return lattice_poses(
      side, {-half, -half, 0}, {half + 1, half + 1, layers}, 0,
      [layers](int x, int y, int z) { return std::abs(x) + std::abs(y) <= layers - 1 - z; });
}

/// Numbers in [-1, 1) that depend on the seed and the block alone.
class Noise {
 public:
  Noise(std::uint64_t seed, std::size_t entry, std::size_t block)
      : random_(seed, 0, Purpose::start, static_cast<std::uint32_t>(entry), block) {}
  double operator()() { return 2 * random_.unit() - 1; }
  double unit() { return random_.unit(); }

 private:
  Random random_;
};

std::vector<Pose> grid_poses(const BlockSpawn& spawn, double side, std::uint64_t seed,
                             std::size_t entry) {
  const double pitch = spawn.pitch > 0 ? spawn.pitch : 1.8 * side;
  const auto& n = spawn.count;
  std::vector<Pose> out;
  for (int z = 0; z < n[2]; ++z) {
    for (int y = 0; y < n[1]; ++y) {
      for (int x = 0; x < n[0]; ++x) {
        Noise noise(seed, entry, out.size());
        Vec3 p{(x - (n[0] - 1) / 2.0) * pitch, (y - (n[1] - 1) / 2.0) * pitch,
               side / 2 + z * pitch};
        p.x += noise() * spawn.jitter;
        p.y += noise() * spawn.jitter;
        Vec3 axis{noise(), noise(), noise()};
        // A vector in the cube is shortened to the ball: an angle is never more than `tumble`.
        axis *= 1 / std::max(1.0, length(axis));
        out.push_back({p, normalised(rotation(axis * spawn.tumble))});
      }
    }
  }
  return out;
}

/// Balls that keep clear of each other, found by trying places: cells of their diameter
/// hold at most a few.
class Scatter {
 public:
  explicit Scatter(double radius) : least_(2 * radius) {}

  bool add(const Vec3& p) {
    const std::array<std::int64_t, 3> at = {cell(p.x), cell(p.y), cell(p.z)};
    for (std::int64_t x = at[0] - 1; x <= at[0] + 1; ++x) {
      for (std::int64_t y = at[1] - 1; y <= at[1] + 1; ++y) {
        for (std::int64_t z = at[2] - 1; z <= at[2] + 1; ++z) {
          if (near(key(x, y, z), p)) return false;
        }
      }
    }
    cells_[key(at[0], at[1], at[2])].push_back(p);
    return true;
  }

 private:
  std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / least_)); }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto bits = [](std::int64_t v) { return static_cast<std::uint64_t>(v) & 0x1fffff; };
    return bits(x) << 42 | bits(y) << 21 | bits(z);
  }
  bool near(std::uint64_t key, const Vec3& p) const {
    // Only one key is asked for, so the order of an unordered map never shows.
    const auto found = cells_.find(key);
    return found != cells_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](const Vec3& o) { return squared(o - p) < least_ * least_; });
  }

  double least_;
  std::unordered_map<std::uint64_t, std::vector<Vec3>> cells_;
};

/// Half of the least distance between centres at which two blocks so turned are apart. Upright
/// cubes on one level need the diagonal of a square between them, any others that of a cube.
double clearance(ScatterTurn turned, const Vec3& size, double side) {
  const bool flat = size.z < side && turned != ScatterTurn::any;
  return side / 2 * std::sqrt(flat ? 2.0 : 3.0) * 1.001;
}

/// Fewer poses than asked for when there is no room.
std::vector<Pose> scatter_poses(const BlockSpawn& spawn, double side, std::uint64_t seed,
                                std::size_t entry) {
  const double radius = clearance(spawn.turned, spawn.size, side);
  const double lowest = spawn.turned == ScatterTurn::any ? radius : side / 2;
  const auto wanted = static_cast<std::size_t>(spawn.count[0]);
  Scatter scatter(radius);
  std::vector<Pose> out;
  std::size_t tries = 10'000 + 50 * wanted;
  for (std::size_t i = 0; out.size() < wanted && tries > 0; ++i, --tries) {
    Noise noise(seed, entry, i);
    const Vec3& size = spawn.size;
    const Vec3 p{noise() * size.x / 2, noise() * size.y / 2, lowest + noise.unit() * size.z};
    if (!scatter.add(p)) continue;
    Quat q;
    if (spawn.turned == ScatterTurn::upright) q = rotation({0, 0, noise.unit() * kTurn});
    if (spawn.turned == ScatterTurn::any) {
      // Uniform over rotations (Shoemake 1992).
      const double u = noise.unit(), a = noise.unit() * kTurn, b = noise.unit() * kTurn;
      const double s = std::sqrt(1 - u), t = std::sqrt(u);
      q = {t * std::cos(b), s * std::sin(a), s * std::cos(a), t * std::sin(b)};
    }
    out.push_back({p, normalised(q)});
  }
  return out;
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
    const std::vector<Pose> poses = poses_of(entry);
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

  std::vector<Pose> poses_of(std::size_t entry) const {
    const BlockSpawn& spawn = scene_.blocks[entry];
    const double side = scene_.models[spawn.model].side;
    switch (spawn.kind) {
      case SpawnKind::single:
        return {Pose{}};
      case SpawnKind::column:
      case SpawnKind::wall:
        return wall_poses(spawn, side);
      case SpawnKind::pyramid:
        return pyramid_poses(spawn, side);
      case SpawnKind::grid:
        return grid_poses(spawn, side, placed_.seed, entry);
      case SpawnKind::scatter:
        return scatter_poses(spawn, side, placed_.seed, entry);
      case SpawnKind::poses:
        return spawn.poses;
    }
    return {};
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
      placed_.bodies.push_back({spawn.name + "/" + part.name, Led::off, entry, false, part.rgb});
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
      return !a.block && !b.block && !robots.emplace(a.entry, b.entry).second;
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
      return one.block ? scene_.blocks[one.entry].range : scene_.robots[one.entry].range;
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

Pose jittered(const Pose& pose, double jitter, double turn, std::uint64_t seed, std::uint32_t entry,
              std::uint64_t number) {
  assert(jitter >= 0 && turn >= 0);
  if (jitter == 0 && turn == 0) return pose;
  Noise noise(seed, entry, number);
  Pose out = pose;
  out.p.x += noise() * jitter;
  out.p.y += noise() * jitter;
  out.q = normalised(rotation({0, 0, noise() * turn}) * pose.q);
  return out;
}

std::optional<PlacedScene> place_scene(const Scene& scene, std::uint64_t seed,
                                       Diagnostics& diagnostics) {
  Diagnostics own;
  auto placed = Placer(scene, seed, own).place();
  diagnostics.append(own);
  return placed;
}

}  // namespace stig::physics
