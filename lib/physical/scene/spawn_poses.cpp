// SPDX-License-Identifier: MIT
// Everything that is random is a function of the seed, the entry and the block's number, so that an
// entry which is added to a scene moves no block of another.
#include "physical/scene/spawn_poses.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_map>

#include "base/random.h"

namespace stig::physics {

namespace {

// Bodies at rest overlap a little, within the solver's slop; begun apart they would first fall.
constexpr double kInto = 10e-6;  ///< m, that neighbours overlap: as they would lie at rest
constexpr double kTurn = 2 * 3.14159265358979323846;

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

}  // namespace

std::vector<Pose> spawn_poses(const BlockSpawn& spawn, double side, std::uint64_t seed,
                              std::size_t entry) {
  switch (spawn.kind) {
    case SpawnKind::single:
      return {Pose{}};
    case SpawnKind::column:
    case SpawnKind::wall:
      return wall_poses(spawn, side);
    case SpawnKind::pyramid:
      return pyramid_poses(spawn, side);
    case SpawnKind::grid:
      return grid_poses(spawn, side, seed, entry);
    case SpawnKind::scatter:
      return scatter_poses(spawn, side, seed, entry);
    case SpawnKind::poses:
      return spawn.poses;
  }
  return {};
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

}  // namespace stig::physics
