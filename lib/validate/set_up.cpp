// SPDX-License-Identifier: MIT
// set_up.h has the figures and their reasons. All places are worked out about the start's middle
// and moved at the end so that the origin is where scenes have it, and each structure where it has
// room; then they are rounded, so that the text of a scene and the numbers handed on are the same.
#include "validate/set_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "validate/build_site.h"

namespace stig::validate {
namespace {

// Caches drop blocks from a little above the floor: 2.3 block sides, clear of one that lies there.
constexpr double kCacheWay = 0.5, kCacheWayReach = 0.11, kCacheClear = 0.47, kCacheDrop = 0.125;
constexpr double kRobotWay = 0.15, kRobotWaySeveral = 0.20;
// Beside the cache, clear of robots that fetch from it (programs/mission/standby.lua has the
// first).
constexpr double kStandbyBeyond = 0.06, kStandbyAside = 0.32, kStandbyRows = 0.30;
/// s for a brick: one robot that works on four sides takes up to 120.
constexpr double kTimeOfBrick = 150;
constexpr double kArena = 1.5, kArenaBeyond = 0.7;

/// Outwards from the structure, as the world's axes lie.
struct Direction {
  int x = 0, y = 0;
  int degrees = 0;
};

Direction direction_of(ApproachSide side) {
  switch (side) {
    case ApproachSide::plus_x:
      return {1, 0, 0};
    case ApproachSide::plus_y:
      return {0, 1, 90};
    case ApproachSide::minus_x:
      return {-1, 0, 180};
    case ApproachSide::minus_y:
      break;
  }
  return {0, -1, 270};
}

/// m; whatever rounding leaves behind zero is none. Adding 0.0 makes -0 into 0, which would print a
/// sign.
double metres(double v) { return std::round(v * 1e5) / 1e5 + 0.0; }

/// Of one structure and the robots that begin there.
class Layout {
 public:
  Layout(const RuleSet& rules, const CompiledRules& compiled, const SetUpRequest& request)
      : rules_(rules), compiled_(compiled), request_(request) {
    // From cell to cell centre, so the middle of an even row lies between two cells.
    double low_x = std::numeric_limits<double>::infinity(), low_y = low_x;
    double high_x = -low_x, high_y = -low_x;
    for (const PlacedBrick& brick : rules.start) {
      low_x = std::min(low_x, brick.at.x * request.side);
      high_x = std::max(high_x, brick.at.x * request.side);
      low_y = std::min(low_y, brick.at.y * request.side);
      high_y = std::max(high_y, brick.at.y * request.side);
    }
    middle_ = {(low_x + high_x) / 2, (low_y + high_y) / 2, 0};
    // From one side the first robot is in the origin, as the paper's figures have it.
    if (compiled.sides.size() == 1) {
      const Direction out = direction_of(compiled.sides.front());
      const double way = robot_way(out);
      origin_ = {out.x * way, out.y * way, 0};
    }
  }

  SetUpLayout layout() const { return {arena(), blocks(), robots(), caches()}; }

 private:
  bool several() const { return compiled_.sides.size() > 1; }

  /// How far the structure, or the start alone, goes from the start's middle; m.
  double reach(const Direction& out, bool start) const {
    double far = 0;
    // Start bricks come first among the target's.
    const std::size_t bricks =
        start ? compiled_.target->start_bricks() : compiled_.target->bricks();
    for (std::size_t i = 0; i < bricks; ++i) {
      const Cell cell = compiled_.target->cell(i);
      far = std::max(far, out.x * (cell.x * request_.side - middle_.x) +
                              out.y * (cell.y * request_.side - middle_.y));
    }
    return far;
  }
  double robot_way(const Direction& out) const {
    return reach(out, true) + (several() ? kRobotWaySeveral : kRobotWay);
  }
  double cache_way(const Direction& out) const {
    const double far = reach(out, false);
    return far < kCacheWayReach + 1e-6 ? kCacheWay : far + kCacheClear;
  }
  /// Of the robot that is the so many-th to stand by on its side, from the cache on outwards, m.
  static double standby_behind(int number) {
    return kStandbyBeyond + (number - 1) / 2 * kStandbyRows;
  }
  double arena() const {
    const auto sides = static_cast<int>(compiled_.sides.size());
    // Of one side: rows behind its cache.
    const int most = (request_.robots - 1) / sides;
    const double behind = most > 0 ? standby_behind(most) : 0;
    double far = 0;
    for (const ApproachSide side : compiled_.sides) {
      const Direction out = direction_of(side);
      far = std::max({far, std::abs(out.x * (cache_way(out) + behind) - origin_.x),
                      std::abs(out.y * (cache_way(out) + behind) - origin_.y)});
    }
    return std::max(kArena, far + kArenaBeyond);
  }

  Vec3 place(double x, double y, double z) const { return Vec3{x, y, z} - origin_; }

  std::vector<SetUpLayout::Block> blocks() const {
    std::vector<SetUpLayout::Block> out;
    for (const PlacedBrick& brick : rules_.start) {
      // Half a level up: centres, over the level that stands on the floor.
      const double level = brick.at.z - compiled_.target->floor_level() + 0.5;
      out.push_back({place(brick.at.x * request_.side - middle_.x,
                           brick.at.y * request_.side - middle_.y, level * request_.side),
                     brick.brick});
    }
    return out;
  }

  /// The sides that a robot works from; it begins at the first.
  std::vector<ApproachSide> sides_of(int robot) const {
    // The sides are in the order in which they follow each other around the structure, so each
    // robot's stretch is in one piece.
    const auto& sides = compiled_.sides;
    const auto count = static_cast<int>(sides.size());
    if (request_.robots >= count) return {sides[static_cast<std::size_t>(robot % count)]};
    const auto first = sides.begin() + robot * count / request_.robots;
    const auto last = sides.begin() + (robot + 1) * count / request_.robots;
    return {first, last};
  }

  std::vector<SetUpLayout::Robot> robots() const {
    std::vector<SetUpLayout::Robot> out;
    const auto sides = static_cast<int>(compiled_.sides.size());
    for (int i = 0; i < request_.robots; ++i) {
      const std::vector<ApproachSide> own = sides_of(i);
      const Direction d = direction_of(own.front());
      // That many of its side are before it, and it waits until it is needed.
      const int beyond = i / sides;
      const double way = beyond > 0 ? cache_way(d) + standby_behind(beyond) : robot_way(d);
      const double left = beyond == 0 ? 0 : beyond % 2 == 1 ? kStandbyAside : -kStandbyAside;
      // A robot alone goes where there is work.
      const bool several_robots = request_.robots > 1;
      const bool fixed = request_.allocation == Allocation::fixed;
      out.push_back({place(d.x * way - d.y * left, d.y * way + d.x * left, 0), d.degrees,
                     own.front(), fixed && several_robots ? own : std::vector<ApproachSide>{},
                     beyond, several_robots ? request_.robots : 0});
    }
    return out;
  }

  std::vector<SetUpLayout::Cache> caches() const {
    std::vector<SetUpLayout::Cache> out;
    for (const ApproachSide side : compiled_.sides) {
      const Direction d = direction_of(side);
      out.push_back({place(d.x * cache_way(d), d.y * cache_way(d), kCacheDrop), d.degrees});
    }
    return out;
  }

  const RuleSet& rules_;
  const CompiledRules& compiled_;
  const SetUpRequest& request_;
  Vec3 middle_;  ///< of the start, in the lattice's frame
  Vec3 origin_;  ///< of the world, from the start's middle
};

std::string scene_head(const RuleSet& rules, double duration, double arena) {
  const std::string& title = rules.title.empty() ? rules.name : rules.title;
  std::string quoted;
  // The title is the user's; YAML in double quotes has these two characters to escape.
  for (const char c : title)
    quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return fmt::format(
      "# The set-up of `stigc validate`; controller.lua is what the robots run.\n"
      "stigc_scene: 1\n"
      "title: \"{}\"\n"
      "duration: {:g}\n"
      "arena: {:g}\n",
      quoted, duration, arena);
}

}  // namespace

double most_build_time(const CompiledRules& compiled) {
  assert(compiled.target != nullptr);
  // Structures of more than 16 bricks get more time than the usual.
  return std::max(kMostBuildTime, kTimeOfBrick * static_cast<double>(compiled.target->bricks()));
}

int robots_of(const RuleSet& rules, std::optional<int> asked, int structures) {
  return asked.value_or(structures * (rules.physical ? rules.physical->robots.value_or(1) : 1));
}

SetUpLayout lay_out(const RuleSet& rules, const CompiledRules& compiled,
                    const SetUpRequest& request) {
  assert(request.robots > 0 && request.structures > 0 && !compiled.sides.empty());
  std::vector<SetUpLayout> structures;
  double arena = 0;  // of one
  for (int i = 0; i < request.structures; ++i) {
    SetUpRequest own = request;
    own.robots = (request.robots + request.structures - 1 - i) / request.structures;
    structures.push_back(Layout(rules, compiled, own).layout());
    arena = std::max(arena, structures.back().arena);
  }
  const int columns = static_cast<int>(std::ceil(std::sqrt(request.structures)));
  const int rows = (request.structures + columns - 1) / columns;
  SetUpLayout out;
  out.arena = metres(columns * arena);
  for (int i = 0; i < request.structures; ++i) {
    const Vec3 middle{(2 * (i % columns) - columns + 1) * arena,
                      (2 * (i / columns) - rows + 1) * arena, 0};
    const auto take = [&](auto& all, auto& own, auto place) {
      for (auto& one : own) {
        const Vec3 at = one.*place + middle;
        one.*place = {metres(at.x), metres(at.y), metres(at.z)};
        all.push_back(std::move(one));
      }
    };
    SetUpLayout& one = structures[static_cast<std::size_t>(i)];
    take(out.blocks, one.blocks, &SetUpLayout::Block::centre);
    take(out.robots, one.robots, &SetUpLayout::Robot::at);
    take(out.caches, one.caches, &SetUpLayout::Cache::at);
  }
  return out;
}

std::string sides_text(const std::vector<ApproachSide>& sides) {
  std::string out;
  for (const ApproachSide side : sides) {
    out += fmt::format("{}{}", out.empty() ? "" : " ", to_string(side));
  }
  return out;
}

std::string set_up_scene(const RuleSet& rules, const CompiledRules& compiled,
                         const SetUpRequest& request) {
  const SetUpLayout layout = lay_out(rules, compiled, request);
  // Fewer robots than structures build them one after the other.
  const int rounds = (request.structures + request.robots - 1) / request.robots;
  std::string out =
      scene_head(rules, rounds * most_build_time(compiled), layout.arena) + "blocks:\n";
  int number = 0;
  for (const SetUpLayout::Block& block : layout.blocks) {
    out += fmt::format("  - {{name: start {}, at: [{:g}, {:g}, {:g}], color: {}, fixed: true}}\n",
                       ++number, block.centre.x, block.centre.y, block.centre.z,
                       rules.brick(block.brick).led);
  }
  out += "robots:\n";
  number = 0;
  for (const SetUpLayout::Robot& robot : layout.robots) {
    const std::string sides = sides_text(robot.bound);
    std::string bound = sides.empty() ? "" : fmt::format(", sides: \"{}\"", sides);
    if (robot.standby > 0) bound += fmt::format(", standby: {}", robot.standby);
    if (robot.crew > 0) bound += fmt::format(", crew: {}", robot.crew);
    // Noise of starting poses: 1 cm and 5°, so that runs with different seeds differ.
    out += fmt::format(
        "  - {{name: robot {}, file: {}, at: [{:g}, {:g}], heading: {}, jitter: 0.01, "
        "turn_jitter: 5, program: {}, params: {{side: \"{}\"{}}}}}\n",
        ++number, request.robot_file, robot.at.x, robot.at.y, robot.heading, kControllerFile,
        to_string(robot.side), bound);
  }
  out += "caches:\n";
  for (const SetUpLayout::Cache& cache : layout.caches) {
    out += fmt::format("  - {{at: [{:g}, {:g}, {:g}], jitter: 0.02, turn_jitter: 45}}\n",
                       cache.at.x, cache.at.y, cache.at.z);
  }
  return out +
         "# What sensors do in practice: a pixel off by a half, 1 % of colours taken for none or "
         "another,\n"
         "# pictures a tick late, ranges off by a millimetre, encoders that tell whole counts.\n"
         "noise: {pixels: 0.5, missed_tags: 0.02, colour: 8, camera_latency: 1, distance: 0.001, "
         "encoder_count: 0.0012875}\n";
}

}  // namespace stig::validate
