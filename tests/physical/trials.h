// SPDX-License-Identifier: MIT
// Trials that tests hold to bounds and bench_physics prints: a scene that is run, and what
// came of it. Those with a solver as argument run on DART's step too, for comparison.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "base/degree.h"
#include "physical/dynamics/world.h"
#include "support/scenes.h"
#include "support/uses.h"

namespace stig {

BlockModel without_magnets(BlockModel block);
/// With dipole moments of so many A·m².
BlockModel with_moment(BlockModel block, double moment);

/// Steps until then, or until the world gives up.
inline void run_for(World& world, const WorldConfig& config, double seconds) {
  const auto steps = static_cast<int>(std::lround(seconds / config.step));
  for (int i = 0; i < steps && world.step().ok; ++i) continue;
}

/// Where one body stands as another sees it.
struct Misfit {
  Vec3 p;          ///< m, in the frame of the first
  double yaw = 0;  ///< rad, about its z
};
Misfit misfit(const Pose& X_WA, const Pose& X_WB);

/// Largest distance of a body from where it was spawned, m.
inline double largest_drift(const World& world, const WorldConfig& config) {
  double most = 0;
  for (std::uint32_t i = 0; i < config.bodies.size(); ++i) {
    most = std::max(most, length(world.state(BodyId{i}).X_WB.p - config.bodies[i].X_WB.p));
  }
  return most;
}

inline constexpr double kClosed = 1e-4;  ///< m: a gap below this has closed

struct Click {
  double time = -1;  ///< s until the gap has closed; -1: never
  Misfit end;        ///< of the second block against the first, a second after the start
};

/// The click of pair_scene and scenes like it.
inline Click click(const WorldConfig& config, double side) {
  World world(config);
  Click out;
  const auto now = [&] { return misfit(world.state(BodyId{0}).X_WB, world.state(BodyId{1}).X_WB); };
  const auto steps = static_cast<int>(std::lround(1 / config.step));
  double last = now().p.x - side;
  for (int i = 1; i <= steps && world.step().ok; ++i) {
    const double gap = now().p.x - side;
    // Between steps, of which one of 5 ms is a fifth of a short fall.
    const double part = (last - kClosed) / (last - gap);
    if (out.time < 0 && gap < kClosed) out.time = (i - 1 + part) * config.step;
    last = gap;
  }
  out.end = now();
  return out;
}

/// pair_scene, the second block turned about z by `angle`, with spheres at rest in the field
/// of their surroundings; `seed` decides which way they point, and shifts the second block
/// sideways by up to 1 mm.
WorldConfig settled_pair(const BlockModel& block, double gap, double friction, double angle,
                         int seed);

/// Largest differences of the quasi-static magnets at 5 ms from the integrated ones at 0.2 ms,
/// over gaps of 6, 8 and 10 mm and three seeds, at the angles given.
struct ModelGap {
  double time = 0;  ///< as a part of the reference's time to click
  double way = 0;   ///< m, of the final pose
  double yaw = 0;   ///< rad
};
ModelGap compare_magnet_models(const BlockModel& block, double friction,
                               const std::vector<double>& degrees);

/// Way of a block that slides with 0.5 m/s until it stops, m.
inline double sliding_stop(const BlockModel& block, double friction, double angle,
                           SolverKind solver = SolverKind::fast) {
  WorldConfig config = scene_settings({friction, friction});
  config.frictions.push_back({kFloorMaterial, kFloorMaterial, friction});
  BodyDef def = block_body(without_magnets(block), {{0, 0, block.side / 2 - 1e-5}, {}});
  def.velocity = Vec3{std::cos(angle), std::sin(angle), 0} * 0.5;
  config.bodies = {def};
  config.solver = solver;
  World world(config);
  run_for(world, config, 1);
  const Vec3 way = world.state(BodyId{0}).X_WB.p - def.X_WB.p;
  return std::hypot(way.x, way.y);
}

/// A block let fall from `height` onto a column of three, 4 mm and 5 degrees off: where it
/// ends against the block below it.
Misfit dropped_on_column(const BlockModel& block, double height, double friction);

/// A column that cannot fall asleep, each block off the one below by 1 mm and 2 degrees, this
/// way and that: the most that a block of it moves and turns within ten seconds, after five
/// in which it finds its place.
struct Creep {
  double way = 0;   ///< m
  double turn = 0;  ///< rad
};
Creep awake_column(const BlockModel& block, int height);

/// How far a driven rod has pushed the far side of a pyramid, m.
double pushed_pyramid(const BlockModel& block, bool sleeping);

/// Four pairs of magnets of two faces in contact, from the dipoles.
struct FaceHold {
  double pull = 0;    ///< N
  double moment = 0;  ///< N·m, about an edge of the face: opens the joint there
};
FaceHold face_hold(const BlockModel& block);

/// A load that grows until something gives.
struct BreakLoad {
  double computed = 0, measured = 0;  ///< N
};
/// A block under a fixed one, pulled down.
BreakLoad hanging_load(const BlockModel& block);
/// Two blocks in the air beside a fixed one, pulled down at the outer one's middle.
BreakLoad cantilever_load(const BlockModel& block);
/// Five in a row, the outer ones on narrow smooth supports, pulled down at the middle.
BreakLoad bridge_load(const BlockModel& block);

/// Four blocks pushed by 110 mm along the top of a row of eight that lies on the floor.
/// Without magnets, which would draw the lower row along.
struct Slide {
  double moved = 0;  ///< m, of the block that leads
  double rise = 0;   ///< m, most that one of them has risen
  double pitch = 0;  ///< rad, most that one of them has been tilted
  double drawn = 0;  ///< m, most that a block of the lower row has been moved
};
Slide row_along_row(const BlockModel& block);

/// Structures asleep: 33 pyramids and columns, 1000 blocks.
WorldConfig village(const BlockModel& block);
/// The blocks of a file of scenes/drops.
WorldConfig loose_blocks(const BlockModel& block, const std::string& csv);

/// Error of magnets' work against the energy lost, as a part of it: two dipoles that fall
/// towards each other.
double magnet_work_error();

}  // namespace stig
