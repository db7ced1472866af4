// SPDX-License-Identifier: MIT
#include "physical/trials.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>

#include "base/random.h"
#include "support/uses.h"

namespace stig {

namespace {

/// The friction of the paper, which holds blocks that hang on magnets from sliding down.
constexpr double kPaperFriction = 0.5;

constexpr Material kSmooth = 2;

double weight(const BlockModel& block) { return 9.8 * block.mass(); }

/// Grows the load by 0.5 N a second, after half a second without; the load under which
/// `body` has come down by 3 mm.
double grow_load(const WorldConfig& config, std::uint32_t body, double most) {
  World world(config);
  const double height = config.bodies[body].X_WB.p.z;
  double load = 0;
  while (load < most) {
    load = std::max(0.0, world.time() - 0.5) * 0.5;
    world.push(BodyId{body}, {0, 0, -load}, {});
    if (!world.step().ok || world.state(BodyId{body}).X_WB.p.z < height - 3e-3) break;
  }
  return load;
}

WorldConfig in_the_air() {
  WorldConfig config = scene_settings({kPaperFriction, kPaperFriction});
  config.floor = false;
  return config;
}

/// Blocks of a row along x, one metre up.
void add_row(WorldConfig& config, const BlockModel& block, int count) {
  for (int i = 0; i < count; ++i) {
    config.bodies.push_back(block_body(block, {{i * (block.side - kInto), 0, 1}, {}}));
  }
}

/// Directions of the spheres after a while in blocks that are held where they are.
void settle_spheres(WorldConfig& config) {
  WorldConfig held = config;
  for (BodyDef& def : held.bodies) def.fixed = true;
  World world(held);
  for (int i = 0; i < 100; ++i) {
    // A fixed body that is driven keeps the world from resting.
    world.set_velocity(BodyId{0}, {0, 0, i % 2 == 0 ? 1e-9 : -1e-9}, {});
    static_cast<void>(world.step());
  }
  for (std::uint32_t i = 0; i < config.bodies.size(); ++i) {
    const Mat3 r = matrix(config.bodies[i].X_WB.q);
    for (std::size_t k = 0; k < config.bodies[i].magnets.size(); ++k) {
      config.bodies[i].magnets[k].direction = r.transposed(world.magnet_direction(BodyId{i}, k));
    }
  }
}

}  // namespace

BlockModel without_magnets(BlockModel block) {
  block.body_mass = block.mass();
  block.magnet_offset = 0;
  return block;
}

BlockModel with_moment(BlockModel block, double moment) {
  block.magnet_field = moment / kMomentPerField;
  return block;
}

Misfit misfit(const Pose& X_WA, const Pose& X_WB) {
  const Mat3 a = matrix(X_WA.q), b = matrix(X_WB.q);
  return {a.transposed(X_WB.p - X_WA.p), std::atan2(dot(a.y, b.x), dot(a.x, b.x))};
}

WorldConfig settled_pair(const BlockModel& block, double gap, double friction, double angle,
                         int seed) {
  WorldConfig config = pair_scene(block, gap, friction);
  Random random(static_cast<std::uint64_t>(seed), 0, Purpose::start, 0, 0);
  const auto noise = [&random] { return 2 * random.unit() - 1; };
  Pose& pose = config.bodies[1].X_WB;
  pose.q = rotation({0, 0, angle});
  // The nearest corner stays `gap` away.
  pose.p.x += block.side / 2 * (std::cos(angle) + std::abs(std::sin(angle)) - 1);
  pose.p.y += 1e-3 * noise();
  for (BodyDef& def : config.bodies) {
    for (MagnetDef& magnet : def.magnets) {
      magnet.direction = normalised(Vec3{noise(), noise(), 1.5 + noise()});
    }
  }
  settle_spheres(config);
  return config;
}

ModelGap compare_magnet_models(const BlockModel& block, double friction,
                               const std::vector<double>& degrees) {
  ModelGap worst;
  for (const double angle : degrees) {
    for (int i = 0; i < 9; ++i) {
      WorldConfig config =
          settled_pair(block, 0.006 + 0.002 * (i % 3), friction, angle * kDegree, i / 3 + 1);
      const Click fast = click(config, block.side);
      config.magnets = MagnetModel::integrated;
      config.step = 0.0002;
      const Click reference = click(config, block.side);
      const bool both = fast.time > 0 && reference.time > 0;
      const double time = both ? std::abs(fast.time / reference.time - 1) : 1;
      worst.time = std::max(worst.time, time);
      worst.way = std::max(worst.way, length(fast.end.p - reference.end.p));
      worst.yaw = std::max(worst.yaw, std::abs(fast.end.yaw - reference.end.yaw));
    }
  }
  return worst;
}

Misfit dropped_on_column(const BlockModel& block, double height, double friction) {
  WorldConfig config = column_scene(block, 3);
  config.friction = friction;
  const Vec3 top = config.bodies[2].X_WB.p;
  config.bodies.push_back(
      block_body(block, {top + Vec3{4e-3, 0, block.side + height}, rotation({0, 0, 5 * kDegree})}));
  World world(config);
  run_for(world, config, 2);
  return misfit(world.state(BodyId{2}).X_WB, world.state(BodyId{3}).X_WB);
}

Creep awake_column(const BlockModel& block, int height) {
  WorldConfig config = column_scene(block, height);
  config.sleep.enabled = false;
  for (std::size_t i = 1; i < config.bodies.size(); ++i) {
    Pose& pose = config.bodies[i].X_WB;
    const Pose& below = config.bodies[i - 1].X_WB;
    const double way = static_cast<double>(i) * 2.4;  // about the column, never twice the same
    pose.p.x = below.p.x + 1e-3 * std::cos(way);
    pose.p.y = below.p.y + 1e-3 * std::sin(way);
    pose.q = rotation({0, 0, i % 2 == 0 ? 0 : 2 * kDegree});
  }
  World world(config);
  run_for(world, config, 5);
  const auto poses = [&] {
    std::vector<Pose> out;
    for (std::uint32_t i = 0; i < config.bodies.size(); ++i) {
      out.push_back(world.state(BodyId{i}).X_WB);
    }
    return out;
  };
  const std::vector<Pose> before = poses();
  run_for(world, config, 10);
  const std::vector<Pose> after = poses();
  Creep out;
  for (std::size_t i = 0; i < before.size(); ++i) {
    out.way = std::max(out.way, length(after[i].p - before[i].p));
    out.turn = std::max(out.turn, angle_of(conjugate(before[i].q) * after[i].q));
  }
  return out;
}

double pushed_pyramid(const BlockModel& block, bool sleeping) {
  WorldConfig config = pyramid_scene(block);
  config.sleep.enabled = sleeping;
  BodyDef rod = solid_body(Shape::box({0.02, 0.2, 0.02}), 1, {-0.12, 0, 0.03});
  rod.fixed = true;
  config.bodies.push_back(rod);
  World world(config);
  run_for(world, config, 1);
  world.set_velocity(BodyId{15}, {0.05, 0, 0}, {});
  run_for(world, config, 2);
  world.set_velocity(BodyId{15}, {}, {});
  run_for(world, config, 1);
  return world.state(BodyId{7}).X_WB.p.x - config.bodies[7].X_WB.p.x;
}

FaceHold face_hold(const BlockModel& block) {
  const double d = block.side - 2 * block.magnet_offset;
  const Vec3 m{block.magnet_moment(), 0, 0};
  const double pull = -dipole_wrench(m, m, {d, 0, 0}).force.x;
  // Two pairs near the edge that stays closed, two near the one that opens.
  const double half = block.side / 2, near = half - block.magnet_offset;
  return {4 * pull, 2 * pull * (near + half + block.magnet_offset)};
}

BreakLoad hanging_load(const BlockModel& block) {
  WorldConfig config = in_the_air();
  config.bodies = {block_body(block, {{0, 0, 1}, {}}),
                   block_body(block, {{0, 0, 1 - block.side + kInto}, {}})};
  config.bodies[0].fixed = true;
  const double computed = face_hold(block).pull - weight(block);
  return {computed, grow_load(config, 1, 2 * computed)};
}

BreakLoad cantilever_load(const BlockModel& block) {
  WorldConfig config = in_the_air();
  add_row(config, block, 3);
  config.bodies[0].fixed = true;
  // About the lower edge of the joint with the fixed block.
  const double own = weight(block) * (0.5 + 1.5) * block.side;
  const double computed = (face_hold(block).moment - own) / (1.5 * block.side);
  return {computed, grow_load(config, 2, 3 * computed)};
}

BreakLoad bridge_load(const BlockModel& block) {
  WorldConfig config = in_the_air();
  config.frictions.push_back({kBlockMaterial, kSmooth, 0});
  add_row(config, block, 5);
  for (const std::size_t i : {std::size_t{0}, std::size_t{4}}) {
    const Vec3 below{0, 0, -block.side / 2 - 0.01 + kInto};
    BodyDef support =
        solid_body(Shape::box({0.002, 0.05, 0.02}), 1, config.bodies[i].X_WB.p + below);
    support.fixed = true;
    // Rough ones would take up a thrust, and bear as an arch does.
    support.material = kSmooth;
    config.bodies.push_back(support);
  }
  // About the upper edge of a joint of the middle block: half of the load and of 5 blocks
  // acts at the support, 1.5 blocks away; two blocks hang between.
  const double own = weight(block) * block.side * (2.5 * 1.5 - 1.5 - 0.5);
  const double computed = (face_hold(block).moment - own) / (0.5 * 1.5 * block.side);
  return {computed, grow_load(config, 2, 3 * computed)};
}

Slide row_along_row(const BlockModel& magnetic) {
  const BlockModel block = without_magnets(magnetic);
  WorldConfig config = scene_settings();
  const double pitch = block.side - kInto, low = block.side / 2 - kInto;
  for (int i = 0; i < 8; ++i) {
    config.bodies.push_back(block_body(block, {{i * pitch, 0, low}, {}}));
  }
  for (int i = 0; i < 4; ++i) {
    config.bodies.push_back(block_body(block, {{i * pitch, 0, low + pitch}, {}}));
  }
  BodyDef rod =
      solid_body(Shape::box({0.01, 0.05, 0.02}), 1, {-block.side / 2 - 0.0051, 0, low + pitch});
  rod.fixed = true;
  rod.velocity = {0.05, 0, 0};
  config.bodies.push_back(rod);
  World world(config);
  Slide out;
  while (world.time() < 0.11 / 0.05 && world.step().ok) {
    for (std::uint32_t i = 0; i < 12; ++i) {
      const Pose pose = world.state(BodyId{i}).X_WB;
      const Vec3 way = pose.p - config.bodies[i].X_WB.p;
      if (i < 8) out.drawn = std::max(out.drawn, length(way));
      if (i >= 8) out.rise = std::max(out.rise, way.z);
      if (i >= 8) out.pitch = std::max(out.pitch, std::acos(std::min(1.0, matrix(pose.q).z.z)));
      if (i == 11) out.moved = way.x;
    }
  }
  return out;
}

WorldConfig village(const BlockModel& block) {
  WorldConfig config = scene_settings();
  const auto add = [&config](const WorldConfig& part, double x, double y) {
    for (BodyDef def : part.bodies) {
      def.X_WB.p += Vec3{x, y, 0};
      config.bodies.push_back(def);
    }
  };
  // 32 walls of 6 by 5, and 40 blocks in the last one.
  for (int i = 0; i < 32; ++i) {
    add(wall_scene(block, 6, 5), i % 6 * 0.6, static_cast<double>(i / 6) * 0.3);
  }
  add(wall_scene(block, 8, 5), 2 * 0.6, 1.8);
  return config;
}

WorldConfig loose_blocks(const BlockModel& block, const std::string& csv) {
  WorldConfig config = scene_settings();
  std::ifstream in(csv);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    Vec3 p;
    double z = 0, y = 0, x = 0;
    numbers >> p.x >> p.y >> p.z >> z >> y >> x;
    const Quat q = rotation({0, 0, z * kDegree}) * rotation({0, y * kDegree, 0}) *
                   rotation({x * kDegree, 0, 0});
    config.bodies.push_back(block_body(block, {p, normalised(q)}));
  }
  return config;
}

double magnet_work_error() {
  // Fixed directions, so that nothing is lost in bearings.
  WorldConfig config;
  config.floor = false;
  config.gravity = 0;
  config.step = 0.00005;
  config.magnet_cutoff = 0.1;
  for (const double x : {-0.02, 0.02}) {
    BodyDef def = solid_body(Shape::sphere(0.003), 0.01, {x, 0, 0});
    def.magnets = {{{}, 0.2, false, {0.8, 0.6, 0}}};
    config.bodies.push_back(def);
  }
  World world(config);
  const double start = world.energy();
  double gained = 0;
  const auto apart = [&world] {
    return length(world.state(BodyId{0}).X_WB.p - world.state(BodyId{1}).X_WB.p);
  };
  while (world.time() < 1 && apart() > 0.012 && world.step().ok) {
    const BodyState s = world.state(BodyId{0});
    gained = 0.01 * squared(s.velocity) + 0.4 * 0.01 * 9e-6 * squared(s.spin);
  }
  return std::abs(world.energy() - start) / gained;
}

}  // namespace stig
