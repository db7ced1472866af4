// SPDX-License-Identifier: MIT
// What is said of candidates by those who know more than this layer does: the compiler, which
// knows robots, and the program that a user scores with. Both are handed in, as functions of what
// they are given alone; threads call them side by side.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "search/genome.h"
#include "search/uses.h"

namespace stig::search {

/// What `stigc compile` says of a rule set for the plan's robot.
struct RobotWork {
  int robots = 0;   ///< that may work at once; 0: refused, or nobody was asked
  int refusal = 0;  ///< number of the diagnostic P7xx that refuses it; 0: none
};

/// What a score is made of.
struct Scored {
  std::uint64_t id = 0;                    ///< number of the evaluation
  const std::vector<double>& values;       ///< of objectives(), by their numbers
  const std::vector<PlacedBrick>& bricks;  ///< in the order of cells
};

struct Judges {
  /// Asked of coordinated sets alone: others are refused as not proved.
  std::function<RobotWork(const Genome& genome)> compile{};
  /// In place of the plan's sum, when set. Nothing, with `problem` set: there is no such number.
  std::function<std::optional<double>(const Scored& one, std::string& problem)> score{};
};

/// The refusal of what is not proved: P701.
inline constexpr int kNotProved = 701;

}  // namespace stig::search
