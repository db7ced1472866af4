// SPDX-License-Identifier: MIT
// Several robots at lattice level, every interleaving walked: they come, look and decide, put what
// they decided on as late as they like, and leave. The walk knows nothing of pending sets; it knows
// the paper's robot in cells, the decision tree, sight and reach, and what every single robot is
// at.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "compiler/concurrent.h"
#include "support.h"
#include "support/oracle.h"
#include "support/uses.h"

namespace stig {

/// Cells behind the block that the paper's robot fills: 94 + 74 mm of 55 each.
inline constexpr int kRobotCells = 3;

struct RobotAt {
  enum class Doing : std::uint8_t { away, stands, decided } doing = Doing::away;
  ApproachSide side{};
  SideCell place;     ///< deepest of the lane; of one that has decided, the site
  Colour colour = 0;  ///< decided on
  auto operator<=>(const RobotAt&) const = default;
};

inline bool in_its_lane(const RobotAt& robot, Cell brick) {
  const SideCell at = seen_from(robot.side, brick);
  return at.u > robot.place.u && std::abs(at.v - robot.place.v) <= 1;
}
inline bool behind_it(const RobotAt& robot, Cell brick) {
  return seen_from(robot.side, brick).u > robot.place.u + kRobotCells;
}

/// Every interleaving of some robots, of which, with `own_sides`, no two are at the same side.
class Crew {
 public:
  Crew(const RuleSet& rules, const CompiledRules& compiled, std::size_t robots,
       bool own_sides = false)
      : rules_(rules), compiled_(compiled), own_sides_(own_sides) {
    meet({number(start_of(rules)), std::vector<RobotAt>(robots)});
    while (!todo_.empty()) {
      const Moment now = todo_.front();
      todo_.pop_front();
      for (std::size_t i = 0; i < robots; ++i) {
        // One of those that are at the same is enough.
        if (i == 0 || now.robots[i] != now.robots[i - 1]) move(now, i);
      }
    }
  }

  std::set<ConflictKind> failures;
  std::set<int> whole;  ///< structures met in which nothing is to be done, and which are complete

 private:
  struct Moment {
    int structure = 0;
    std::vector<RobotAt> robots;  ///< in order
    auto operator<=>(const Moment&) const = default;
  };
  /// What a robot can come to in a structure.
  struct Structure {
    BrickMap bricks;
    BrickSet set;
    std::vector<PlacedBrick> events;
    std::vector<RobotAt> arrivals;
  };

  int number(const BrickMap& bricks) {
    const auto [at, added] = numbers_.emplace(bricks, static_cast<int>(structures_.size()));
    if (added) {
      Structure one;
      one.bricks = bricks;
      one.set = BrickSet(compiled_.target->bricks());
      OracleWorld world(rules_, std::nullopt);
      for (const auto& [cell, colour] : bricks) {
        world.place({cell, colour});
        one.set.add(compiled_.target->brick_at(cell));
      }
      one.events = world.events(1);
      arrive(one);
      structures_.push_back(std::move(one));
    }
    return at->second;
  }

  void arrive(Structure& one) {
    bool something = false;
    for (const ApproachSide side : compiled_.sides) {
      std::map<int, int> foremost;
      for (const auto& [cell, colour] : one.bricks) {
        const SideCell c = seen_from(side, cell);
        int& u = foremost.emplace(c.v, c.u).first->second;
        u = std::max(u, c.u);
      }
      for (const auto& [v, u] : foremost) {
        RobotAt robot{RobotAt::Doing::stands, side, {u, v, 0}, 0};
        const auto barred = [&](const auto& brick) { return in_its_lane(robot, brick.first); };
        if (std::any_of(one.bricks.begin(), one.bricks.end(), barred)) ++robot.place.u;
        if (std::any_of(one.bricks.begin(), one.bricks.end(), barred)) continue;
        one.arrivals.push_back(robot);
        Observation seen = sight_.look(one.set, side, u, v);
        seen.side = side;
        const auto wish = decide(*compiled_.decision, seen);
        if (!wish) continue;
        robot.doing = RobotAt::Doing::decided;
        robot.colour = wish->colour;
        robot.place = {u + wish->at.du, v + wish->at.dv, wish->at.z};
        if (kind_of(*wish) == PlacementKind::raise) {
          while (one.bricks.contains(cell_from(side, robot.place))) ++robot.place.z;
        }
        if (!wanted(one, robot) || !reaches(one, robot)) {
          failures.insert(ConflictKind::misled);
          continue;
        }
        something = true;
        one.arrivals.push_back(robot);
      }
    }
    if (something) return;
    if (one.bricks.size() == compiled_.target->bricks()) {
      whole.insert(static_cast<int>(structures_.size()));
    } else {
      failures.insert(ConflictKind::stuck);
    }
  }

  static bool wanted(const Structure& here, const RobotAt& robot) {
    const PlacedBrick brick{cell_from(robot.side, robot.place), robot.colour};
    return std::find(here.events.begin(), here.events.end(), brick) != here.events.end();
  }
  bool reaches(const Structure& here, const RobotAt& robot) const {
    return reach(*compiled_.target, here.set, cell_from(robot.side, robot.place), robot.side,
                 abilities_)
               .obstruction == Obstruction::none;
  }

  void meet(Moment moment) {
    std::sort(moment.robots.begin(), moment.robots.end());
    if (met_.insert(moment).second) todo_.push_back(std::move(moment));
  }

  void move(const Moment& now, std::size_t i) {
    const RobotAt robot = now.robots[i];
    if (robot.doing == RobotAt::Doing::decided) return place(now, i);
    Moment next = now;
    if (robot.doing == RobotAt::Doing::away) {
      const std::vector<RobotAt> arrivals = structures_[at(now.structure)].arrivals;
      for (const RobotAt& arrival : arrivals) {
        if (own_sides_ && is_taken(arrival.side, now)) continue;
        next.robots[i] = arrival;
        meet(next);
      }
      return;
    }
    next.robots[i] = {};
    meet(next);
  }

  static bool is_taken(ApproachSide side, const Moment& now) {
    return std::any_of(now.robots.begin(), now.robots.end(), [&](const RobotAt& other) {
      return other.doing != RobotAt::Doing::away && other.side == side;
    });
  }

  void place(const Moment& now, std::size_t i) {
    Moment next = now;
    RobotAt& robot = next.robots[i];
    const Cell cell = cell_from(robot.side, robot.place);
    const Structure here = structures_[at(now.structure)];
    const Colour colour = robot.colour;
    robot.doing = RobotAt::Doing::stands;
    robot.colour = 0;
    // The site is seen to be filled: the block goes elsewhere.
    if (here.bricks.contains(cell)) return meet(std::move(next));
    if (!wanted(here, now.robots[i])) {
      failures.insert(ConflictKind::outdated);
      return;
    }
    if (!reaches(here, robot)) {
      failures.insert(ConflictKind::barred);
      return;
    }
    for (std::size_t k = 0; k < now.robots.size(); ++k) {
      const RobotAt& other = now.robots[k];
      if (k == i || other.doing == RobotAt::Doing::away || !in_its_lane(other, cell)) continue;
      if (behind_it(other, cell)) {
        failures.insert(ConflictKind::walled_in);
        next.robots[k] = {};  // and is carried away by hand
      } else if (other.doing == RobotAt::Doing::stands) {
        return;  // it stands where the brick is to go, and has to leave first
      }
    }
    BrickMap bricks = here.bricks;
    bricks.emplace(cell, colour);
    next.structure = number(bricks);
    meet(std::move(next));
  }

  static std::size_t at(int number) { return static_cast<std::size_t>(number); }

  const RuleSet& rules_;
  const CompiledRules& compiled_;
  const bool own_sides_;
  Abilities abilities_ = paper_robot();
  Sight sight_{*compiled_.target, abilities_};
  std::map<BrickMap, int> numbers_;
  std::deque<Structure> structures_;
  std::set<Moment> met_;
  std::deque<Moment> todo_;
};

}  // namespace stig
