// SPDX-License-Identifier: MIT
// What happens at the building site, as an observer sees it who knows every pose: which blocks
// have come to rest as bricks of the structure, when, who brought them, and which have left it.
//
// A block is a brick of a structure once it has rested for a second in a cell of its lattice,
// touches what is built there (or stands on the floor of a cell beside it) and no robot's
// end-effector is on it. It counts from when that second began. It stays one until it is out of its
// cell. Fixed blocks are bricks from the beginning on. What robots believe plays no part.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "validate/build_site.h"
#include "validate/uses.h"

namespace stig::validate {

inline constexpr std::size_t kNoRobot = SIZE_MAX;

struct WatchedBlock {
  std::size_t block = 0;  ///< a number that stays its own
  Pose X_WB;
  Led led = Led::off;
  bool fixed = false;  ///< of the start
  bool dead = false;   ///< all its LEDs are, as a run's report has it
};

/// The place over which a robot's end-effector holds: the middle of its magnets' lower ends.
struct WatchedHand {
  Vec3 p_W;
};

struct BrickEvent {
  enum class Kind : std::uint8_t { placed, left } kind = Kind::placed;
  double time = 0;
  std::size_t block = 0;
  Cell cell;
  Led led = Led::off;            ///< that it showed
  std::size_t robot = kNoRobot;  ///< that held it last
  std::size_t structure = 0;     ///< of the target's
  friend bool operator==(const BrickEvent&, const BrickEvent&) = default;
};

/// One time that a robot had a block and took it somewhere.
struct Haul {
  std::size_t robot = 0, block = 0;
  double from = 0, to = 0;     ///< s, under the end-effector
  double way = 0;              ///< m, from where it was taken to where it was let go
  Vec3 taken, put;             ///< its middle, there and there
  bool ended = false;          ///< it holds it no more
  std::optional<Cell> placed;  ///< it became a brick then
  std::size_t structure = 0;   ///< in which
};

struct StandingBrick {
  std::size_t block = 0;
  Led led = Led::off;
};

class Watch {
 public:
  /// The target must outlive it.
  explicit Watch(const BuildTarget& target) : target_(target), bricks_(target.sites.size()) {}

  /// At rising times, about five a second; blocks that have left the arena are left out.
  void look(double time, const std::vector<WatchedBlock>& blocks,
            const std::vector<WatchedHand>& hands);

  const std::vector<BrickEvent>& events() const { return events_; }
  /// Those in which the block was moved by more than 5 cm, in the order of their beginnings.
  std::vector<Haul> hauls() const;
  /// A structure's bricks now, those of the start too.
  const std::map<Cell, StandingBrick>& bricks(std::size_t structure) const {
    return bricks_[structure];
  }
  /// Of all structures together.
  std::size_t brick_count() const;
  /// Has the robot a block in its hand?
  bool holding(std::size_t robot) const;
  bool held(std::size_t block) const;
  /// Is the block one of bricks()?
  bool is_part(std::size_t block) const;

 private:
  struct Place {
    std::size_t structure = 0;
    Cell cell;
  };
  struct Known {
    Pose rest;         ///< where it rests
    double since = 0;  ///< s
    std::size_t holder = kNoRobot, last_holder = kNoRobot;
    std::optional<std::size_t> haul;  ///< open, in hauls_
    std::optional<Place> place;       ///< a brick there
  };
  void follow(double time, const WatchedBlock& block, const std::vector<WatchedHand>& hands);
  void follow_haul(double time, const WatchedBlock& block, Known& known);
  void drop_leavers(double time, const std::vector<WatchedBlock>& blocks);
  void find_new(double time, const std::vector<WatchedBlock>& blocks);
  bool joins(const WatchedBlock& block, const Place& place) const;
  void add_brick(double since, const WatchedBlock& block, const Place& place);

  const BuildTarget& target_;
  std::map<std::size_t, Known> known_;
  std::vector<std::map<Cell, StandingBrick>> bricks_;  ///< of each structure
  std::vector<BrickEvent> events_;
  std::vector<Haul> hauls_;
};

}  // namespace stig::validate
