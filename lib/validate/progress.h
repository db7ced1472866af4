// SPDX-License-Identifier: MIT
// How a structure grew over time: a curve a run, and mean and spread over many.
//
// A curve counts right bricks: those that stand in a cell of the structure in its colour, the
// start left out. After its run a curve stays where it ended.
#pragma once

#include <string>
#include <vector>

#include "validate/trial.h"

namespace stig {

struct ProgressCurve {
  std::uint64_t seed = 1;
  std::vector<std::pair<double, int>> steps;  ///< s, bricks from then on
  double end = 0;                             ///< s, of the run
  int at(double time) const;
};
ProgressCurve curve_of(const BuildTarget& target, const Trial& trial);

/// Over runs, on a grid of times.
struct ProgressBand {
  struct Row {
    double time = 0, mean = 0, deviation = 0;  ///< of the sample; 0 for one run
    int least = 0, most = 0;
  };
  std::vector<Row> rows;
};
ProgressBand band_of(const std::vector<ProgressCurve>& curves);

/// time,mean,deviation,least,most and a column for each run; a line for each time.
std::string progress_csv(const std::vector<ProgressCurve>& curves, const ProgressBand& band);
/// A drawing: every run thin, the mean and one deviation about it.
std::string progress_svg(const std::vector<ProgressCurve>& curves, const ProgressBand& band,
                         int bricks);

}  // namespace stig
