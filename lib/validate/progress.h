// SPDX-License-Identifier: MIT
// How a structure grew over time: a curve a run, and mean and spread over many.
//
// A curve counts right bricks: those that stand in a cell of a structure in its colour, the start
// left out. Of several structures it is their sum, and each has one of its own besides. After its
// run a curve stays where it ended. Beside them: how many sites were open, how many robots idle,
// how often one was in another's way.
#pragma once

#include <string>
#include <vector>

#include "validate/trial.h"
#include "validate/uses.h"
#include "validate/work_sites.h"

namespace stig::validate {

struct ProgressCurve {
  std::uint64_t seed = 1;
  using Steps = std::vector<std::pair<double, int>>;
  Steps steps;                    ///< s, bricks from then on
  std::vector<Steps> structures;  ///< likewise of each, where there are several
  double end = 0;                 ///< s, of the run
  int robots = 0;
  bool complete = false;
  Steps sites;                 ///< open, likewise; empty: not known
  std::vector<TimeSpan> idle;  ///< of all robots
  std::vector<double> busy;    ///< s: attempts aborted since another robot was in the way
  int at(double time) const;
};
/// Sites are not known without `sites`.
ProgressCurve curve_of(const BuildTarget& target, const Trial& trial,
                       const WorkSites* sites = nullptr);

/// Over runs, on a grid of times.
struct ProgressBand {
  struct Row {
    double time = 0, mean = 0, deviation = 0;  ///< of the sample; 0 for one run
    int least = 0, most = 0;
    double sites = 0, idle = 0;  ///< open, robots: means of the runs that still went on
    double busy = 0;             ///< aborted so far, of all runs
  };
  std::vector<Row> rows;
};
ProgressBand band_of(const std::vector<ProgressCurve>& curves);

/// time,mean,deviation,least,most,sites,idle,busy and a column for each run, followed by one for
/// each of its structures where there are several; a line for each time.
std::string progress_csv(const std::vector<ProgressCurve>& curves, const ProgressBand& band);

}  // namespace stig::validate
