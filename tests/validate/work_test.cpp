// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "support.h"
#include "support/golden.h"
#include "support/uses.h"
#include "validate/progress_svg.h"
#include "validate/work_sites.h"
#include "validate/work_summary.h"

namespace stig {
namespace {

/// Two robots; a site at first, two or three from 20 s to 60 s, then one until the sixth brick.
ProgressCurve made_up(double late) {
  ProgressCurve curve;
  curve.robots = 2;
  curve.complete = true;
  for (int i = 1; i <= 6; ++i) curve.steps.emplace_back(20.0 * i + (i == 6 ? late : 0), i);
  curve.end = 130 + late;
  curve.sites = {{0, 1}, {20, 2}, {40, 3}, {60, 1}, {80, 1}, {100, 1}, {120 + late, 0}};
  curve.idle = {{0, 10}, {15, 25}, {110, 130}};
  curve.busy = {5, 20, 50, 125};
  return curve;
}

TEST_CASE("phases begin and end with the sites that are open") {
  const std::vector<WorkPhase> phases = phases_of({made_up(0), made_up(40)});
  REQUIRE(phases.size() == 3);
  CHECK(phases[0].name == "opening");
  CHECK(phases[0].to == doctest::Approx(20));
  CHECK(phases[0].sites == doctest::Approx(1));
  CHECK(phases[0].bricks == doctest::Approx(1));
  CHECK(phases[0].busy == doctest::Approx(2));
  CHECK(phases[0].idle == doctest::Approx(15.0 / 40));
  CHECK(phases[1].from == doctest::Approx(20));
  CHECK(phases[1].to == doctest::Approx(60));
  CHECK(phases[1].sites == doctest::Approx(2.5));
  CHECK(phases[1].bricks == doctest::Approx(2));
  CHECK(phases[1].busy == doctest::Approx(1));
  CHECK(phases[1].idle == doctest::Approx(5.0 / 80));
  // Of 60 and 100 s; what comes after the last brick belongs to no phase.
  CHECK(phases[2].to == doctest::Approx(140));
  CHECK(phases[2].busy == doctest::Approx(0.5));
  CHECK(phases[2].idle == doctest::Approx((10.0 + 20) / 2 / (2 * 80)));
}

TEST_CASE("there are no phases of a robot alone, of what is not complete, or without sites") {
  ProgressCurve curve = made_up(0);
  curve.robots = 1;
  CHECK(phases_of({curve}).empty());
  curve = made_up(0);
  curve.complete = false;
  CHECK(phases_of({curve}).empty());
  // It counts for nothing beside one that is.
  CHECK(phases_of({curve, made_up(0)}).at(1).to == doctest::Approx(60));
  curve = made_up(0);
  curve.sites.clear();
  CHECK(phases_of({curve}).empty());
}

TEST_CASE("more robots than there are ever sites: in parallel while there are as many as ever") {
  ProgressCurve curve = made_up(0);
  curve.robots = 8;
  const std::vector<WorkPhase> phases = phases_of({curve});
  REQUIRE(phases.size() == 3);
  CHECK(phases[1].from == doctest::Approx(40));
  CHECK(phases[1].to == doctest::Approx(60));
}

TEST_CASE("the drawing has the phases, and sites and idle robots below") {
  const std::vector<ProgressCurve> curves = {made_up(0), made_up(40)};
  const ProgressBand band = band_of(curves);
  check_golden("tests/validate/golden/work.csv", progress_csv(curves, band));
  check_golden("tests/validate/golden/work.svg", progress_svg(curves, band, 6));
}

TEST_CASE("the pyramid's sites: the column, then four wings, then fewer") {
  const CompiledSet set("stepped-pyramid");
  const WorkSites sites(set.compiled);
  std::vector<BrickEvent> events;
  const auto place = [&](Cell cell, Led led) {
    const double time = 10.0 * static_cast<double>(events.size() + 1);
    events.push_back({BrickEvent::Kind::placed, time, events.size(), cell, led, 0});
  };
  place({0, 0, 1}, Led::q3);
  place({0, 0, 2}, Led::q3);
  for (const Cell foot : {Cell{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}) {
    place(foot, Led::q2);
    place({foot.x, foot.y, 1}, Led::q2);
    place({2 * foot.x, 2 * foot.y, 0}, Led::q1);
  }
  const BuildTarget target{&set.rules, *set.compiled.proof.structure, {BuildSite{}}};
  std::vector<int> open;
  for (const auto& [time, count] : sites.over(events, target)) open.push_back(count);
  CHECK(open == std::vector<int>{1, 1, 4, 4, 4, 3, 3, 3, 2, 2, 2, 1, 1, 1, 0});
}

TEST_CASE("a brick that leaves opens its site again, a wrong one changes nothing") {
  const Staircase made;
  const WorkSites sites(made.set.compiled);
  std::vector<BrickEvent> events = made.events();
  events.push_back({BrickEvent::Kind::placed, 60, 9, {0, 1, 0}, Led::q1, 0});
  BrickEvent gone = events[4];
  gone.kind = BrickEvent::Kind::left;
  gone.time = 70;
  events.push_back(gone);
  const auto open = sites.over(events, made.target);
  REQUIRE(open.size() == 7);
  CHECK(open[0] == std::pair(0.0, 1));
  CHECK(open[5] == std::pair(50.0, 0));
  CHECK(open[6] == std::pair(70.0, 1));
}

TEST_CASE("states, idle time and congestion are summed over robots and runs") {
  const Staircase made;
  Trial trial;
  trial.events = made.events();
  trial.time = 60;
  trial.judgements = {judge(made.target, 0, made.blocks, trial.events)};
  RobotRecord robot;
  robot.spent = {{"look", 20}, {"wait", 35}};
  robot.idle = {{10, 30}, {40, 50}};
  robot.idle_in = {{"wait", 30}};
  robot.busy = {12, 44};
  trial.robots = {robot, robot};
  Trial other = trial;
  other.events.resize(3);
  other.judgements[0].verdict = BuildVerdict::incomplete;
  other.robots[1].busy.clear();
  const std::vector<Trial> trials = {trial, trial, other};
  const WorkSummary all = summary_of(made.target, trials);
  CHECK(all.runs == 3);
  CHECK(all.complete == 2);
  CHECK(all.finish == doctest::Approx(50));
  CHECK(all.deviation == doctest::Approx(0));
  CHECK(all.time == doctest::Approx(360));
  CHECK(all.idle_share() == doctest::Approx(0.5));
  REQUIRE(all.states.size() == 2);
  CHECK(all.states[0].state == "wait");
  CHECK(all.states[0].time == doctest::Approx(210));
  CHECK(all.states[0].idle == doctest::Approx(180));
  CHECK(all.states[1].idle == doctest::Approx(0));
  CHECK(all.placed == 13);
  CHECK(all.busy == 10);
  CHECK(all.busy_per_brick() == doctest::Approx(10.0 / 13));
}

}  // namespace
}  // namespace stig
