// SPDX-License-Identifier: MIT
// One file that can be mailed: style, curves and pictures are in it, nothing is fetched. All that
// comes from files or programs goes through `escaped`, since titles, names and log lines are
// whatever their authors wrote.
#include "validate/report_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>

#include "base/base64.h"
#include "base/degree.h"
#include "base/text.h"
#include "rules/cell_text.h"
#include "validate/findings.h"
#include "validate/progress_svg.h"

namespace stig::validate {
namespace {

// Braces of the style are doubled, since fmt reads them; {0} is the title, {1} the source of the
// player's script and {2} its style, which the report's comes after. Nothing is ever loaded, and no
// other script is run.
constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src {1}; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>{0}</title>
<style>{2}
:root {{ --text: #222; --soft: #555; --page: #fff; --rule: #ddd; --box: #f5f5f5; --good: #276749;
  --bad: #9b2c2c; --link: #1f5f99; color-scheme: light dark }}
@media (prefers-color-scheme: dark) {{
  :root {{ --text: #dde3ea; --soft: #9aa7b5; --page: #14181e; --rule: #36404d; --box: #1f2630;
    --good: #7bd3a0; --bad: #f29a9a; --link: #6db3f2 }}
}}
body {{ font: 15px/1.45 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em;
  color: var(--text); background: var(--page); overflow-wrap: break-word }}
a {{ color: var(--link) }}
body > table {{ display: block; overflow-x: auto; width: fit-content; max-width: 100%;
  border-collapse: collapse; margin: .6em 0 1.4em }}
body > table th, body > table td {{ padding: .2em .7em; text-align: right;
  border-bottom: 1px solid var(--rule) }}
body > table th:first-child, body > table td:first-child, td.t, th.t {{ text-align: left }}
figure {{ display: inline-block; margin: .3em }}
figure img {{ width: 20em; max-width: 100%; border: 1px solid var(--rule) }}
.good {{ color: var(--good) }}
.bad {{ color: var(--bad) }}
.soft {{ color: var(--soft) }}
body > pre {{ background: var(--box); padding: .8em; overflow: auto }}
body > svg {{ max-width: 100%; height: auto; background: #fff; border-radius: 4px }}
</style>
</head>
<body class="report">
)";

std::string escaped(std::string_view text) { return escaped_markup(printable(text)); }

/// Several lines, as they are. printable() would take line ends for control characters.
std::string escaped_lines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += escaped(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

class Page {
 public:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }
  /// Cells that begin with '@' are texts and stand to the left, numbers to the right, so that their
  /// digits stand under each other. '@' can stand in no number, and texts get it before they are
  /// escaped.
  void row(std::string_view tag, const std::vector<std::string>& cells) {
    out_ += "<tr>";
    for (const std::string& cell : cells) {
      const bool words = cell.starts_with('@');
      add("<{0}{1}>{2}</{0}>", tag, words ? " class=\"t\"" : "",
          escaped(std::string_view(cell).substr(words ? 1 : 0)));
    }
    out_ += "</tr>\n";
  }
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows) {
    // A table without rows is left out, with its head.
    if (rows.empty()) return;
    out_ += "<table>\n";
    row("th", head);
    for (const auto& cells : rows) row("td", cells);
    out_ += "</table>\n";
  }
  void raw(std::string_view text) { out_ += text; }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

// + 0.0 takes the sign off a zero.
std::string fixed(double v, int digits) { return fmt::format("{:.{}f}", v + 0.0, digits); }

void runs(const ValidationReport& report, Page& page) {
  std::vector<std::vector<std::string>> rows;
  for (const Trial& trial : report.trials) {
    const TrialTotals all = totals_of(trial);
    rows.push_back({std::to_string(trial.seed), fmt::format("@{}", to_string(trial.verdict())),
                    fmt::format("@{}", to_string(trial.end)), fixed(trial.time, 0),
                    fmt::format("{} of {}", all.there, all.wanted), fixed(all.worst_way * 1e3, 2),
                    fixed(all.worst_turn / kDegree, 2),
                    fmt::format("{} of {}", all.allowed, all.placements)});
  }
  page.table(
      {"seed", "@verdict", "@end", "time / s", "bricks", "worst / mm", "worst / °", "by the rules"},
      rows);
}

/// Over all runs: phases, states, what came of waiting for each other.
void work(const ValidationReport& report, const std::vector<ProgressCurve>& curves, Page& page) {
  const WorkSummary all = summary_of(*report.target, report.trials);
  page.raw("<h2>What robots' time went into</h2>\n");
  // The share is that of summed times: a long run counts more than a short one.
  page.add(
      "<p>Of all robots' time {:.1f} % idle: neither wheels nor lift in motion and no current in "
      "the electromagnets, for more than {:g} s in a row. Attempts aborted since another robot "
      "was in the way: {}, {:.2f} for each brick placed.</p>\n",
      100 * all.idle_share(), kIdleAfter, all.busy, all.busy_per_brick());
  page.add(
      "<p>Efficiency {:.2f}: {:.0f} s of robots' time for what {:.0f} s are ideal for, by straight "
      "ways and with nothing in the way.</p>\n",
      all.efficiency(), all.taken, all.ideal);
  std::vector<std::vector<std::string>> rows;
  for (const WorkPhase& phase : phases_of(curves)) {
    rows.push_back({fmt::format("@{}", phase.name), fixed(phase.from, 0), fixed(phase.to, 0),
                    fixed(phase.sites, 1), fixed(phase.bricks, 1), fixed(phase.busy, 1),
                    fixed(100 * phase.idle, 1)});
  }
  page.table({"@phase", "from / s", "to / s", "sites open", "bricks", "busy", "idle / %"}, rows);
  rows.clear();
  for (const StateTime& one : all.states) {
    rows.push_back({"@" + one.state, fixed(one.time, 1), fixed(100 * one.time / all.time, 1),
                    fixed(one.idle, 1)});
  }
  page.table({"@state", "time / s", "share / %", "idle / s"}, rows);
}

/// What became of each of several.
void structures(const BuildTarget& target, const Trial& trial, Page& page) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    const Judgement& j = trial.judgements[i];
    const Vec3& at = target.sites[i].X_WL.p;
    const auto last = last_placement(trial, i);
    rows.push_back({std::to_string(i + 1), fmt::format("{:.2f}, {:.2f}", at.x, at.y),
                    fmt::format("@{}", to_string(j.verdict)),
                    fmt::format("{} of {}", j.bricks.size() - j.missing(), j.bricks.size()),
                    last ? fixed(*last, 0) : "–", fixed(j.worst_way * 1e3, 2),
                    fixed(j.worst_turn / kDegree, 2),
                    fmt::format("{} of {}", j.allowed, j.placements)});
  }
  page.table({"structure", "at / m", "@verdict", "bricks", "last brick / s", "worst / mm",
              "worst / °", "by the rules"},
             rows);
}

void bricks(const BuildTarget& target, const Judgement& judgement, Page& page) {
  std::vector<std::vector<std::string>> rows;
  for (const BrickCheck& brick : judgement.bricks) {
    const std::string wanted(to_string(led_of(*target.rules, brick.wanted)));
    if (!brick.block) {
      rows.push_back({cell_text(brick.cell), "@" + wanted, "@missing", "", "", "", "", ""});
      continue;
    }
    // Millimetres and degrees, as tolerances are given.
    rows.push_back({cell_text(brick.cell), "@" + wanted,
                    brick.start      ? "@start"
                    : brick.coloured ? "@right colour"
                                     : fmt::format("@shows {}", to_string(brick.led)),
                    fixed(brick.off.x * 1e3, 2), fixed(brick.off.y * 1e3, 2),
                    fixed(brick.off.z * 1e3, 2), fixed(brick.yaw / kDegree, 2),
                    fixed(length(brick.drift) * 1e3, 2)});
  }
  page.table({"cell", "@brick", "@is", "x / mm", "y / mm", "z / mm", "yaw / °", "drift / mm"},
             rows);
  page.add(
      "<p>x, y, z and yaw: from the lattice that fits all bricks best; drift: from that of the "
      "start. Neighbours are off against each other by {:.2f} mm and {:.2f}° at most.</p>\n",
      judgement.worst_joint_way * 1e3, judgement.worst_joint_turn / kDegree);
}

void placements(const BuildTarget& target, const Trial& trial, Page& page) {
  std::vector<std::vector<std::string>> rows;
  for (const BrickEvent& event : trial.events) {
    rows.push_back(
        {fixed(event.time, 1),
         event.kind == BrickEvent::Kind::placed ? "@came to rest" : "@left its cell",
         "@" + brick_text(*target.rules, event.led, event.cell) +
             of_structure(target, event.structure),
         event.robot < trial.robots.size() ? "@" + trial.robots[event.robot].name : "@nobody"});
  }
  page.raw("<h3>Bricks as they came</h3>\n");
  page.table({"time / s", "@what", "@brick", "@by"}, rows);
}

void hauls(const BuildTarget& target, const Trial& trial, Page& page) {
  std::vector<std::vector<std::string>> rows;
  for (const Haul& haul : trial.hauls) {
    const std::string outcome =
        haul.placed  ? "placed at " + cell_text(*haul.placed) + of_structure(target, haul.structure)
        : haul.ended ? std::string("let go elsewhere")
                     : std::string("still held");
    rows.push_back({fmt::format("@{}", trial.robots[haul.robot].name), fixed(haul.from, 1),
                    fixed(haul.to, 1), fixed(haul.way, 2), "@" + outcome});
  }
  page.add("<p>Blocks: {}.</p>\n", escaped(count_text(trial.blocks)));
  page.raw("<h3>Attempts: every block that a robot took</h3>\n");
  page.table({"@robot", "from / s", "to / s", "way / m", "@and then"}, rows);
}

void robots(const Trial& trial, Page& page) {
  std::vector<std::vector<std::string>> rows, states;
  // A run that ended at once has no shares; no division by zero.
  const double whole = std::max(trial.time, 1e-9);
  for (const RobotRecord& robot : trial.robots) {
    // Numbers that the library's programs show (programs/mission/record.lua); others' need not.
    const auto shown = [&](const char* name) {
      const auto found = robot.shown.find(name);
      return found == robot.shown.end() ? std::string("–") : fmt::format("{:g}", found->second);
    };
    rows.push_back({robot.name, fixed(robot.driven, 2), shown("placed"), shown("aborted"),
                    shown("busy"), fixed(robot.still, 0), fixed(robot.idle_time(), 0),
                    fixed(100 * (1 - robot.idle_time() / whole), 0), fixed(robot.energy.wheels, 1),
                    fixed(robot.energy.lift, 1), fixed(robot.energy.current_time, 0)});
    for (const auto& [state, seconds] : robot.spent) {
      states.push_back(
          {robot.name, "@" + state, fixed(seconds, 1), fixed(100 * seconds / whole, 1)});
    }
  }
  page.raw("<h3>Robots</h3>\n");
  page.table({"robot", "driven / m", "placed", "aborted", "busy", "still / s", "idle / s",
              "at work / %", "wheels / J", "lift / J", "current / s"},
             rows);
  page.raw("<h3>Time in each state</h3>\n");
  page.table({"robot", "@state", "time / s", "share / %"}, states);
}

/// What there is to look at: the runs themselves, or why there are pictures alone.
void player(const ValidationReport& report, Page& page) {
  if (!report.player) {
    if (!report.no_player.empty())
      page.add("<p class=\"soft\">{}</p>\n", escaped(report.no_player));
    return;
  }
  page.raw(report.player->body);
  const std::size_t shown = report.player->runs;
  if (shown < report.trials.size()) {
    page.add(
        "<p class=\"soft\">The first {} can be played here; <code>stigc view</code> shows the "
        "others by their traces.</p>\n",
        counted(shown, "run"));
  }
}

/// The run of a number; so many, from the first on, can be played.
void trial_part(const ValidationReport& report, std::size_t number, Page& page) {
  const BuildTarget& target = *report.target;
  const Trial& trial = report.trials[number];
  const std::size_t played = report.player ? report.player->runs : 0;
  const BuildVerdict verdict = trial.verdict();
  page.add("<h2>Seed {}: <span class=\"{}\">{}</span>, {} after {:.1f} s</h2>\n", trial.seed,
           verdict == BuildVerdict::complete ? "good" : "bad", to_string(verdict),
           to_string(trial.end), trial.time);
  const std::vector<std::string> findings = findings_of(target, trial);
  if (!findings.empty()) page.raw("<ul class=\"bad\">\n");
  for (const std::string& one : findings) page.add("<li>{}</li>\n", escaped(one));
  if (!findings.empty()) page.raw("</ul>\n");
  // The player reads the address: no script of the report's own is needed.
  if (number < played)
    page.add("<p><a href=\"#run={}&amp;t=0\">Play this run</a></p>\n", number + 1);
  for (const TrialPicture& picture : trial.pictures) {
    // Pictures are in the page itself: they move with it, and no path can break.
    page.add("<figure><img alt=\"after {0:.0f} s\" src=\"data:image/png;base64,{1}\"/></figure>\n",
             picture.time, base64(picture.png));
  }
  if (trial.judgements.size() > 1) structures(target, trial, page);
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    page.add("<h3>Bricks{} as they stand</h3>\n", of_structure(target, i));
    bricks(target, trial.judgements[i], page);
  }
  placements(target, trial, page);
  hauls(target, trial, page);
  robots(trial, page);
  if (trial.lines.empty()) return;
  page.raw("<h3>What programs said last</h3>\n<pre>");
  // Seconds in a column of their own width.
  for (const TrialLine& line : trial.lines) {
    page.add("{:8.1f}  {}: {}\n", line.time, escaped(line.who), escaped(line.text));
  }
  page.raw("</pre>\n");
}

}  // namespace

bool all_complete(const ValidationReport& report) {
  return !report.trials.empty() &&
         std::all_of(report.trials.begin(), report.trials.end(), [](const Trial& trial) {
           return trial.verdict() == BuildVerdict::complete && !broke_off(trial.end);
         });
}

std::string verdict_text(const ValidationReport& report) {
  const auto good = std::count_if(report.trials.begin(), report.trials.end(), [](const Trial& t) {
    return t.verdict() == BuildVerdict::complete;
  });
  return report.trials.size() == 1
             ? std::string(to_string(report.trials.front().verdict()))
             : fmt::format("complete in {} of {} runs", good, report.trials.size());
}

std::vector<ProgressCurve> curves_of(const ValidationReport& report) {
  std::vector<ProgressCurve> out;
  // Open sites are worked out from the compiled rules: without them curves have bricks alone.
  std::optional<WorkSites> sites;
  if (report.compiled != nullptr) sites.emplace(*report.compiled);
  for (const Trial& trial : report.trials) {
    out.push_back(curve_of(*report.target, trial, sites ? &*sites : nullptr));
  }
  return out;
}

std::string report_html(const ValidationReport& report) {
  assert(report.target != nullptr && !report.trials.empty());
  const BuildTarget& target = *report.target;
  const std::string title = target.rules->title.empty() ? target.rules->name : target.rules->title;
  const std::vector<ProgressCurve> curves = curves_of(report);
  // Start bricks stand from the beginning; curves count what robots put.
  const std::size_t structures = target.sites.size();
  const auto bricks =
      static_cast<int>(structures * (target.whole.size() - target.rules->start.size()));
  Page page;
  const bool played = report.player.has_value();
  page.add(kHead, escaped(title), played ? report.player->script : "'none'",
           played ? report.player->style : "");
  page.add("<h1>{}: <span class=\"{}\">{}</span></h1>\n", escaped(title),
           all_complete(report) ? "good" : "bad", escaped(verdict_text(report)));
  page.add("<p>{}{}, {} at the start; {}.</p>\n",
           structures > 1 ? fmt::format("{} structures, each of ", structures) : "",
           counted(target.whole.size(), "brick"), target.rules->start.size(),
           counted(report.trials.front().robots.size(), "robot"));
  player(report, page);
  runs(report, page);
  page.raw("<h2>Progress</h2>\n");
  page.raw(progress_svg(curves, band_of(curves), bricks));
  work(report, curves, page);
  if (!report.decision.empty()) {
    page.add("<h2>What robots do</h2>\n<pre>{}</pre>\n", escaped_lines(report.decision));
  }
  if (!report.robots.empty()) {
    page.add("<p>Robots at work, as proved: {}.</p>\n", escaped(report.robots));
  }
  for (std::size_t i = 0; i < report.trials.size(); ++i) trial_part(report, i, page);
  page.raw("</body>\n</html>\n");
  return page.take();
}

}  // namespace stig::validate
