// SPDX-License-Identifier: MIT
// The scene in which a rule set is put to the test, as the text of a scene file: start bricks
// fixed to the floor, caches, robots that look outwards.
//
// The world is laid out about the middle of the start, as seen from above; where robots work from
// one side alone, the first robot stands in its origin, as in Allwright et al. 2017. On each side
// that robots work from, with e the farthest column of the finished structure on that side, s the
// farthest of the start, both from the start's middle:
//
//     a cache   at 0.5 m, as in the paper, where e is no more than 0.11 m, as there; otherwise at
//               e + 0.47 m: a robot that stands 0.34 m before a column, to look at it, has room to
//               turn before a block that lies in the cache. Either way blocks in the structure
//               are farther from it than the 0.35 m within which a cache has a block
//     robots    at s + 0.15 m, or s + 0.20 m where they work on several sides, in turn on each side
//     further   robots of a side, beyond its first, are to stand by (params: standby: 1, 2 ...):
//               0.06 m farther out than the cache, the first 0.32 m to its left and the second as
//               far to its right, further pairs 0.30 m farther out
//     the arena to 1.5 m, or 0.7 m beyond the farthest of these
//
// Robots and sides are dealt out in turn; of fewer robots than sides each has sides that follow
// each other, and begins at the first. Fixed allocation binds robots to their sides, unless there
// is but one robot. Each of several is told how many there are (params: crew: 2 ...).
//
// Several structures of the same rules stand in a square of rows: each in the middle of an arena of
// the size that it would have alone, with caches of its own. Robots are dealt out among them in
// turn, as even as may be.
//
// One text for all: what validate runs is what `stigc simulate` makes of the file. The layout
// itself is there too, for other simulators' files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"
#include "compiler/compile.h"
#include "validate/uses.h"

namespace stig::validate {

inline constexpr std::string_view kControllerFile = "controller.lua";
inline constexpr double kMostBuildTime = 2400;  ///< s
/// The same, s: more for a structure of more than sixteen bricks.
double most_build_time(const CompiledRules& compiled);

/// Who works on which side. dynamic_: any robot on any, and one that is obstructed again and again
/// goes to the next; fixed: each has its own for good, as in Allwright et al. 2017.
enum class Allocation : std::uint8_t { dynamic_, fixed };

struct SetUpRequest {
  int structures = 1;
  int robots = 1;  ///< at all structures together
  Allocation allocation = Allocation::fixed;
  std::string robot_file = "bebot.yaml";
  double side = 0.055;  ///< of a block, m
};

/// The number that was asked for, or for each structure the file's, or 1.
int robots_of(const RuleSet& rules, std::optional<int> asked, int structures = 1);

/// Where things stand; m, in the world's frame, z over the floor, rounded to 10 µm.
struct SetUpLayout {
  struct Block {
    Vec3 centre;
    Colour brick = 0;
  };
  struct Robot {
    Vec3 at;
    int heading = 0;                           ///< degrees
    ApproachSide side = ApproachSide::plus_x;  ///< where it begins
    std::vector<ApproachSide> bound;           ///< to these sides for good; empty: to none
    int standby = 0;  ///< of those of its side that wait until they are needed; 0: it works
    int crew = 0;     ///< robots at its structure, where they are several; 0: it is alone
  };
  struct Cache {
    Vec3 at;           ///< where blocks are dropped
    int outwards = 0;  ///< degrees, away from the structure
  };
  double arena = 0;           ///< half its side
  std::vector<Block> blocks;  ///< the starts
  std::vector<Robot> robots;
  std::vector<Cache> caches;  ///< one on each side of each structure
};
SetUpLayout lay_out(const RuleSet& rules, const CompiledRules& compiled,
                    const SetUpRequest& request);

/// "+x -y": as a robot's program is told which sides it is bound to.
std::string sides_text(const std::vector<ApproachSide>& sides);

/// YAML; robots run kControllerFile.
std::string set_up_scene(const RuleSet& rules, const CompiledRules& compiled,
                         const SetUpRequest& request);

}  // namespace stig::validate
