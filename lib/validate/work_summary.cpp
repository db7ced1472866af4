// SPDX-License-Identifier: MIT
#include "validate/work_summary.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>

namespace stig::validate {
namespace {

/// How much of a time lies between two others, s.
double within(const TimeSpan& span, double from, double to) {
  return std::max(0.0, std::min(span.to, to) - std::max(span.from, from));
}

/// Calls back with each stretch of the curve in which the number of sites is one.
template <class Use>
void each_stretch(const ProgressCurve& curve, double end, const Use& use) {
  for (std::size_t i = 0; i < curve.sites.size(); ++i) {
    const double to = i + 1 < curve.sites.size() ? curve.sites[i + 1].first : end;
    use(TimeSpan{curve.sites[i].first, std::min(to, end)}, curve.sites[i].second);
  }
}

/// Where one run's phases begin and end: 0, two bounds, the last brick. "Many" is as many sites as
/// there are robots, or the most there ever are if that is fewer; a phase that never comes has no
/// length.
std::array<double, 4> bounds_of(const ProgressCurve& curve) {
  assert(!curve.steps.empty());
  const double end = curve.steps.back().first;
  int most = 0;
  each_stretch(curve, end, [&](const TimeSpan&, int sites) { most = std::max(most, sites); });
  const int many = std::min(most, curve.robots);
  // Begins empty, at the end of the work.
  TimeSpan broad{end, end};
  each_stretch(curve, end, [&](const TimeSpan& span, int sites) {
    if (sites < many) return;
    broad.from = std::min(broad.from, span.from);
    broad.to = span.to;
  });
  return {0, broad.from, broad.to, end};
}

void add_run(const ProgressCurve& curve, double from, double to, double share, WorkPhase& phase) {
  phase.from += from * share;
  phase.to += to * share;
  each_stretch(curve, to, [&](const TimeSpan& span, int sites) {
    phase.sites += sites * within(span, from, to) * share;
  });
  int before = 0;
  for (const auto& [time, bricks] : curve.steps) {
    // A brick that ends a phase was placed in it.
    if (time > from && time <= to) phase.bricks += (bricks - before) * share;
    before = bricks;
  }
  for (const double time : curve.busy) phase.busy += time > from && time <= to ? share : 0;
  for (const TimeSpan& span : curve.idle) phase.idle += within(span, from, to) * share;
}

}  // namespace

WorkSummary summary_of(const BuildTarget& target, std::span<const Trial> trials) {
  WorkSummary out;
  // Over complete runs for times, over all for shares of time.
  out.runs = trials.size();
  std::vector<double> times;
  std::map<std::string, StateTime> states;
  for (const Trial& trial : trials) {
    const ProgressCurve curve = curve_of(target, trial);
    out.placed += static_cast<std::size_t>(curve.steps.empty() ? 0 : curve.steps.back().second);
    if (curve.complete) times.push_back(curve.steps.empty() ? 0 : curve.steps.back().first);
    out.taken +=
        (curve.complete ? times.back() : trial.time) * static_cast<double>(trial.robots.size());
    for (const RobotRecord& robot : trial.robots) {
      out.time += trial.time;
      out.ideal += robot.ideal;
      out.busy += robot.busy.size();
      out.idle += robot.idle_time();
      for (const auto& [state, seconds] : robot.spent) states[state].time += seconds;
      for (const auto& [state, seconds] : robot.idle_in) states[state].idle += seconds;
    }
  }
  out.complete = times.size();
  const auto n = static_cast<double>(times.size());
  for (const double time : times) out.finish += time / n;
  // As in progress.cpp: of a sample.
  double squares = 0;
  for (const double time : times) squares += (time - out.finish) * (time - out.finish);
  out.deviation = times.size() > 1 ? std::sqrt(squares / (n - 1)) : 0;
  for (auto& [state, spent] : states) out.states.push_back({state, spent.time, spent.idle});
  std::stable_sort(out.states.begin(), out.states.end(),
                   [](const StateTime& a, const StateTime& b) { return a.time > b.time; });
  return out;
}

std::vector<WorkPhase> phases_of(const std::vector<ProgressCurve>& curves) {
  std::array<WorkPhase, 3> phases;
  phases[0].name = "opening";
  phases[1].name = "in parallel";
  phases[2].name = "closing";
  std::vector<const ProgressCurve*> complete;
  for (const ProgressCurve& curve : curves) {
    if (curve.complete && !curve.sites.empty() && !curve.steps.empty()) complete.push_back(&curve);
  }
  // Means over runs of bounds and sums alike, so a phase's figures belong together.
  const double share = 1 / static_cast<double>(std::max<std::size_t>(1, complete.size()));
  double robots = 0;
  for (const ProgressCurve* curve : complete) {
    const std::array<double, 4> bounds = bounds_of(*curve);
    for (std::size_t i = 0; i < 3; ++i) add_run(*curve, bounds[i], bounds[i + 1], share, phases[i]);
    robots += curve->robots * share;
  }
  std::vector<WorkPhase> out;
  for (WorkPhase& phase : phases) {
    const double time = phase.to - phase.from;
    if (time <= 0) continue;
    phase.sites /= time;
    // idle was in seconds of robots; by time and robots it is a share.
    phase.idle /= std::max(1.0, robots) * time;
    out.push_back(phase);
  }
  // A single phase says nothing that the totals do not.
  return out.size() > 1 ? out : std::vector<WorkPhase>{};
}

}  // namespace stig::validate
