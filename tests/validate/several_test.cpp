// SPDX-License-Identifier: MIT
// Two staircases, three metres apart and turned against each other.
#include <doctest/doctest.h>

#include <algorithm>

#include "support.h"
#include "support/golden.h"
#include "support/uses.h"
#include "validate/findings.h"
#include "validate/progress_svg.h"
#include "validate/report_html.h"
#include "validate/watch.h"

namespace stig {
namespace {

struct TwoStairs : Staircase {
  std::size_t each = blocks.size();  ///< bricks; those of the second have numbers from here on

  TwoStairs() {
    target.sites.push_back({{{3.3, -0.2, 0.0275}, rotation({0, 0, 1.2})}, 0.055});
    const std::vector<WatchedBlock> first = blocks;
    for (const WatchedBlock& one : first) {
      WatchedBlock other = one;
      other.block += each;
      const Cell cell = fit_of(target.sites[0], one.X_WB).cell;
      other.X_WB = {centre_of(target.sites[1], cell), target.sites[1].X_WL.q};
      blocks.push_back(other);
    }
  }

  /// Events of both, those of the second 5 s after those of the first.
  std::vector<BrickEvent> all_events() const {
    std::vector<BrickEvent> out;
    for (const BrickEvent& event : events()) {
      out.push_back(event);
      out.push_back(event);
      out.back().time += 5;
      out.back().block += each;
      out.back().structure = 1;
    }
    return out;
  }

  Trial trial() const {
    Trial out;
    out.events = all_events();
    out.time = 65;
    out.end = TrialEnd::built;
    for (std::size_t i = 0; i < 2; ++i)
      out.judgements.push_back(judge(target, i, blocks, out.events));
    return out;
  }
};

TEST_CASE("each structure is judged by itself, by its own lattice and its own placements") {
  TwoStairs stairs;
  Trial trial = stairs.trial();
  CHECK(trial.judgements[0].verdict == BuildVerdict::complete);
  CHECK(trial.judgements[1].verdict == BuildVerdict::complete);
  CHECK(trial.verdict() == BuildVerdict::complete);
  CHECK(totals_of(trial).allowed == 10);
  CHECK(last_placement(trial, 0) == 50);
  CHECK(last_placement(trial, 1) == 55);
  // One brick of the second is off, and one of its placements comes too early.
  stairs.blocks.back().X_WB.p.z += 0.004;
  trial = stairs.trial();
  CHECK(trial.judgements[0].verdict == BuildVerdict::complete);
  CHECK(trial.judgements[1].verdict == BuildVerdict::wrong);
  CHECK(trial.verdict() == BuildVerdict::wrong);
  std::erase_if(trial.events, [&](const BrickEvent& event) {
    return event.structure == 1 && event.cell == stairs.order[0].at;
  });
  CHECK_FALSE(judge(stairs.target, 0, stairs.blocks, trial.events).against);
  CHECK(judge(stairs.target, 1, stairs.blocks, trial.events).against);
}

TEST_CASE("findings say of which structure they are") {
  TwoStairs stairs;
  stairs.blocks.pop_back();
  Trial trial = stairs.trial();
  trial.end = TrialEnd::time;
  const std::vector<std::string> findings = findings_of(stairs.target, trial);
  CHECK(std::count_if(findings.begin(), findings.end(), [](const std::string& one) {
          return one.starts_with("structure 2: missing: a ");
        }) == 1);
  CHECK(std::none_of(findings.begin(), findings.end(),
                     [](const std::string& one) { return one.starts_with("structure 1"); }));
}

TEST_CASE("a watch knows of which structure a block is a brick") {
  TwoStairs stairs;
  Watch watch(stairs.target);
  const std::vector<WatchedHand> none;
  // The starts alone at first, and a lit fixed block in no structure's reach.
  std::vector<WatchedBlock> there = {stairs.blocks[0], stairs.blocks[stairs.each]};
  there.push_back(stairs.block(99, {9, 9, 0}, Led::q1));
  there.back().fixed = true;
  watch.look(0, there, none);
  CHECK(watch.bricks(0).size() == 1);
  CHECK(watch.bricks(1).size() == 1);
  CHECK_FALSE(watch.is_part(99));
  CHECK(watch.events().empty());
  std::vector<WatchedBlock> second(stairs.blocks.begin() + static_cast<long>(stairs.each) + 1,
                                   stairs.blocks.end());
  there.insert(there.end(), second.begin(), second.end());
  for (double time = 0.2; time < 2; time += 0.2) watch.look(time, there, none);
  CHECK(watch.bricks(0).size() == 1);
  CHECK(watch.bricks(1).size() == stairs.each);
  CHECK(watch.brick_count() == stairs.each + 1);
  CHECK(stands(stairs.target, 1, watch));
  CHECK_FALSE(stands(stairs.target, 0, watch));
  CHECK_FALSE(spoilt(stairs.target, 0, watch));
  for (const BrickEvent& event : watch.events()) CHECK(event.structure == 1);
}

TEST_CASE("curves of several structures are their sum, and one of each") {
  const TwoStairs stairs;
  ValidationReport report;
  report.target = &stairs.target;
  report.compiled = &stairs.set.compiled;
  report.trials = {stairs.trial()};
  const std::vector<ProgressCurve> curves = curves_of(report);
  CHECK(curves[0].at(52) == 9);
  CHECK(curves[0].sites.front().second == 2);  // one at each start
  CHECK(curves[0].sites.back().second == 0);
  const ProgressBand band = band_of(curves);
  check_golden("tests/validate/golden/progress-of-two.csv", progress_csv(curves, band));
  check_golden("tests/validate/golden/progress-of-two.svg", progress_svg(curves, band, 10));
  const std::string html = report_html(report);
  CHECK(html.find("2 structures, each of 6 bricks, 1 at the start") != std::string::npos);
  CHECK(html.find("Bricks of structure 2 as they stand") != std::string::npos);
  CHECK(html.find("<td>12 of 12</td>") != std::string::npos);
  CHECK(html.find("<td>3.30, -0.20</td>") != std::string::npos);
}

}  // namespace
}  // namespace stig
