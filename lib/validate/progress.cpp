// SPDX-License-Identifier: MIT
#include "validate/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/round_step.h"

namespace stig::validate {
namespace {

// Rows of the table over all times: enough for a smooth curve, few enough for a spreadsheet.
constexpr double kMostRows = 240;

/// The value that holds at a time, of changes in the order of time; at first 0. The nanosecond is
/// for times that were summed from steps.
int value_at(const ProgressCurve::Steps& changes, double time) {
  int out = 0;
  for (const auto& [when, value] : changes) {
    if (when <= time + 1e-9) out = value;
  }
  return out;
}

/// What is told beside the bricks.
void add_work(const std::vector<ProgressCurve>& curves, ProgressBand::Row& row) {
  double going = 0;
  for (const ProgressCurve& curve : curves) {
    // Aborted attempts are a running total, of all runs; sites and idle robots are means over those
    // that still run, since a run that has ended has neither.
    row.busy +=
        static_cast<double>(std::count_if(curve.busy.begin(), curve.busy.end(),
                                          [&](double when) { return when <= row.time + 1e-9; })) /
        static_cast<double>(curves.size());
    if (row.time > curve.end) continue;
    ++going;
    row.sites += value_at(curve.sites, row.time);
    row.idle += static_cast<double>(std::count_if(
        curve.idle.begin(), curve.idle.end(),
        [&](const TimeSpan& span) { return span.from <= row.time && row.time < span.to; }));
  }
  row.sites /= std::max(1.0, going);
  row.idle /= std::max(1.0, going);
}

}  // namespace

int ProgressCurve::at(double time) const { return value_at(steps, time); }

ProgressCurve curve_of(const BuildTarget& target, const Trial& trial, const WorkSites* sites) {
  assert(target.rules != nullptr);
  ProgressCurve curve;
  curve.seed = trial.seed;
  curve.end = trial.time;
  curve.robots = static_cast<int>(trial.robots.size());
  curve.complete = trial.verdict() == BuildVerdict::complete;
  if (sites != nullptr) curve.sites = sites->over(trial.events, target);
  for (const RobotRecord& robot : trial.robots) {
    curve.idle.insert(curve.idle.end(), robot.idle.begin(), robot.idle.end());
    curve.busy.insert(curve.busy.end(), robot.busy.begin(), robot.busy.end());
  }
  const std::size_t structures = target.sites.size();
  if (structures > 1) curve.structures.resize(structures);
  std::vector<int> bricks(structures);
  int all = 0;
  for (const BrickEvent& event : trial.events) {
    const State wanted = target.whole.at(event.cell);
    // Bricks of another colour or place are no progress, and their leaving is none lost.
    if (!is_brick(wanted) || led_of(*target.rules, wanted) != event.led) continue;
    const int more = event.kind == BrickEvent::Kind::placed ? 1 : -1;
    all += more;
    bricks[event.structure] += more;
    curve.steps.emplace_back(event.time, all);
    if (structures > 1) {
      curve.structures[event.structure].emplace_back(event.time, bricks[event.structure]);
    }
  }
  return curve;
}

ProgressBand band_of(const std::vector<ProgressCurve>& curves) {
  ProgressBand band;
  double end = 0;
  for (const ProgressCurve& curve : curves) end = std::max(end, curve.end);
  // The grid ends beyond the longest run, so that its end is on it.
  const double step = round_step(end, kMostRows);
  const auto n = static_cast<double>(curves.size());
  for (double time = 0; !curves.empty() && time < end + step; time += step) {
    ProgressBand::Row row;
    row.time = time;
    row.least = curves.front().at(time);
    for (const ProgressCurve& curve : curves) {
      const int bricks = curve.at(time);
      row.mean += bricks / n;
      row.least = std::min(row.least, bricks);
      row.most = std::max(row.most, bricks);
    }
    double squares = 0;
    for (const ProgressCurve& curve : curves) {
      const double off = curve.at(time) - row.mean;
      squares += off * off;
    }
    // The deviation is that of a sample, so n - 1 (Bessel's correction).
    row.deviation = curves.size() > 1 ? std::sqrt(squares / (n - 1)) : 0;
    add_work(curves, row);
    band.rows.push_back(row);
  }
  return band;
}

std::string progress_csv(const std::vector<ProgressCurve>& curves, const ProgressBand& band) {
  std::string out = "time,mean,deviation,least,most,sites,idle,busy";
  for (const ProgressCurve& curve : curves) {
    out += fmt::format(",seed_{}", curve.seed);
    for (std::size_t i = 0; i < curve.structures.size(); ++i) {
      out += fmt::format(",seed_{}_structure_{}", curve.seed, i + 1);
    }
  }
  out += "\n";
  for (const ProgressBand::Row& row : band.rows) {
    out += fmt::format("{:g},{:.3f},{:.3f},{},{},{:.2f},{:.2f},{:.2f}", row.time, row.mean,
                       row.deviation, row.least, row.most, row.sites, row.idle, row.busy);
    for (const ProgressCurve& curve : curves) {
      out += fmt::format(",{}", curve.at(row.time));
      for (const ProgressCurve::Steps& steps : curve.structures) {
        out += fmt::format(",{}", value_at(steps, row.time));
      }
    }
    out += "\n";
  }
  return out;
}

}  // namespace stig::validate
