// SPDX-License-Identifier: MIT
// What robots' time went into, over one run or many: how long in which state, how long idle
// (robot_watch.h), how often in each other's way; and the phases of the work.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "validate/progress.h"
#include "validate/uses.h"

namespace stig::validate {

/// Time in one state, of all robots and runs together.
struct StateTime {
  std::string state;
  double time = 0, idle = 0;  ///< s; idle is part of time
};

struct WorkSummary {
  std::size_t runs = 0, complete = 0;
  double finish = 0, deviation = 0;  ///< s, of the last brick of complete runs; of the sample
  double time = 0, idle = 0;         ///< s, of all robots
  std::vector<StateTime> states;     ///< the longest first
  double ideal = 0;                  ///< s, of the robots for the bricks that stand: ideal_time.h
  double taken = 0;                  ///< s, of the robots until the last brick; of runs that are
                                     ///< not complete, until their end
  std::size_t placed = 0;            ///< right bricks at the end, the start left out
  std::size_t busy = 0;              ///< attempts aborted since another robot was in the way

  double idle_share() const { return time > 0 ? idle / time : 0; }
  double efficiency() const { return taken > 0 ? ideal / taken : 0; }
  double busy_per_brick() const {
    return static_cast<double>(busy) / static_cast<double>(placed > 0 ? placed : 1);
  }
};
WorkSummary summary_of(const BuildTarget& target, std::span<const Trial> trials);

/// Parts of the work, by how many sites were open (work_sites.h): *opening* until there are as
/// many as there ever are, or as robots; *in parallel*, until there are so many for the last time;
/// then *closing*. Means over complete runs, each with its own bounds.
struct WorkPhase {
  std::string_view name;
  double from = 0, to = 0;      ///< s
  double sites = 0;             ///< open, on average
  double bricks = 0, busy = 0;  ///< placed, aborted since busy; a run
  double idle = 0;              ///< share of the robots' time
};
/// None where all is one phase, as for a robot alone, or no run is complete.
std::vector<WorkPhase> phases_of(const std::vector<ProgressCurve>& curves);

}  // namespace stig::validate
