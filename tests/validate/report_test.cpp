// SPDX-License-Identifier: MIT
#include "support/uses.h"
#include "validate/progress_svg.h"
#include "validate/report_html.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support.h"
#include "support/golden.h"

namespace stig {
namespace {

/// Three runs: two whole ones, and one that stopped early.
struct MadeUpReport : Staircase {
  ValidationReport report;

  MadeUpReport() {
    report.target = &target;
    report.compiled = &set.compiled;
    report.decision = "colour of the column's top?\n  Q1: nothing <&>\n";
    report.robots = "any number at once";
    for (std::uint64_t seed = 1; seed <= 3; ++seed) report.trials.push_back(trial(seed));
  }

  Trial trial(std::uint64_t seed) const {
    Trial out;
    out.seed = seed;
    out.events = events();
    for (BrickEvent& event : out.events) event.time *= 1 + 0.4 * static_cast<double>(seed);
    out.end = TrialEnd::built;
    std::vector<WatchedBlock> there = blocks;
    if (seed == 3) {
      out.events.resize(2);
      there.resize(3);
      out.end = TrialEnd::time;
    }
    out.time = seed == 3 ? 150 : out.events.back().time + 10;
    out.judgements = {judge(target, 0, there, out.events)};
    RobotRecord robot;
    robot.name = "robot 1";
    robot.driven = 3.25;
    robot.state = "search";
    robot.since = 40;
    robot.spent = {{"approach", 30.5}, {"search", 12}};
    robot.shown = {{"aborted", 2}, {"busy", 1}, {"placed", 5}};
    robot.idle = {{20, 26}, {30, 34.5}};
    robot.idle_in = {{"approach", 8.5}, {"search", 2}};
    robot.busy = {25};
    out.robots = {robot};
    out.hauls = {{0, 1, 2.0, 12.0, 0.5, {}, {}, true, Cell{0, 0, 1}},
                 {0, 2, 14.0, 20.0, 0.3, {}, {}, true, {}}};
    out.lines = {{1.5, "robot 1", "1 < 2 & \"so\"", false}};
    out.pictures = {{12, std::string("\x89PNG\0\xff", 6)}};
    return out;
  }
};

/// Every element that begins ends, in the right order; attributes are quoted.
std::string tag_problem(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return "a tag does not end";
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (tag.starts_with('!') || tag.ends_with('/')) continue;
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "quotes in " + tag;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (!name.starts_with('/')) {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return name + " ends, " + (open.empty() ? "nothing" : open.back()) + " is open";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back() + " never ends";
}

TEST_CASE("curves of runs, their mean and spread") {
  const MadeUpReport made;
  const std::vector<ProgressCurve> curves = curves_of(made.report);
  REQUIRE(curves.size() == 3);
  CHECK(curves[0].at(0) == 0);
  CHECK(curves[0].at(14) == 1);  // ten seconds, stretched by 1.4
  CHECK(curves[0].at(13.9) == 0);
  CHECK(curves[0].at(1000) == 5);
  CHECK(curves[2].at(1000) == 2);
  const ProgressBand band = band_of(curves);
  const ProgressBand::Row& last = band.rows.back();
  CHECK(last.mean == doctest::Approx(4));
  CHECK(last.deviation == doctest::Approx(std::sqrt(3.0)));
  CHECK(last.least == 2);
  CHECK(last.most == 5);
  CHECK(band_of({}).rows.empty());
  check_golden("tests/validate/golden/progress.csv", progress_csv(curves, band));
  const std::string svg = progress_svg(curves, band, 5);
  check_golden("tests/validate/golden/progress.svg", svg);
  CHECK(tag_problem(svg).empty());
}

TEST_CASE("a brick that leaves takes a step off the curve, a wrong one adds none") {
  const MadeUpReport made;
  Trial trial = made.report.trials[0];
  BrickEvent gone = trial.events.back();
  gone.kind = BrickEvent::Kind::left;
  gone.time += 1;
  trial.events.push_back(gone);
  trial.events.push_back({BrickEvent::Kind::placed, gone.time + 1, 9, {0, 1, 0}, Led::q1, 0});
  const ProgressCurve curve = curve_of(made.target, trial);
  CHECK(curve.at(1000) == 4);
}

TEST_CASE("the report is one well-formed file") {
  const MadeUpReport made;
  CHECK_FALSE(all_complete(made.report));
  CHECK(verdict_text(made.report) == "complete in 2 of 3 runs");
  const std::string html = report_html(made.report);
  CHECK(tag_problem(html) == "");
  CHECK(html.find("1 &lt; 2 &amp; &quot;so&quot;") != std::string::npos);
  CHECK(html.find("any number at once") != std::string::npos);
  CHECK(html.find("data:image/png;base64,iVBORwD/") != std::string::npos);
  CHECK(html.find("missing: a Q1 brick at (2, 0, 0)") != std::string::npos);
  CHECK(html.find("robot 1 is in state 'search' since 40 s") != std::string::npos);
  CHECK(html.find("time was out at 150 s") != std::string::npos);
  // Of three robots; one attempt each, and 5 + 5 + 2 bricks.
  CHECK(html.find("<td class=\"t\">approach</td><td>91.5</td>") != std::string::npos);
  CHECK(html.find("since another robot was in the way: 3, 0.25 for each") != std::string::npos);
  CHECK(html.find("src=\"http") == std::string::npos);
  CHECK(html.find("href=") == std::string::npos);
}

TEST_CASE("runs that can be played stand in place of pictures") {
  MadeUpReport made;
  for (Trial& trial : made.report.trials) trial.pictures.clear();
  made.report.player = ReportPlayer{"'sha256-x'", "b{}", "<div id=\"stig-view\"></div>", 2};
  const std::string html = report_html(made.report);
  CHECK(tag_problem(html) == "");
  CHECK(html.find("script-src 'sha256-x';") != std::string::npos);
  CHECK(html.find("<div id=\"stig-view\"></div>") != std::string::npos);
  CHECK(html.find("<a href=\"#run=2&amp;t=0\">") != std::string::npos);
  CHECK(html.find("<a href=\"#run=3&amp;t=0\">") == std::string::npos);
  CHECK(html.find("The first 2 runs can be played here") != std::string::npos);
  made.report.player.reset();
  made.report.no_player = "None & why.";
  const std::string without = report_html(made.report);
  CHECK(without.find("None &amp; why.") != std::string::npos);
  CHECK(without.find("script-src 'none';") != std::string::npos);
  CHECK(without.find("href=") == std::string::npos);
}

TEST_CASE("a single run that is complete") {
  MadeUpReport made;
  made.report.trials.resize(1);
  CHECK(all_complete(made.report));
  CHECK(verdict_text(made.report) == "complete");
  CHECK(tag_problem(report_html(made.report)) == "");
  made.report.trials[0].end = TrialEnd::interrupted;
  CHECK_FALSE(all_complete(made.report));
}

}  // namespace
}  // namespace stig
