// SPDX-License-Identifier: MIT
// The judge's findings as JSON and as lines. Both have the same figures; the JSON has all of them,
// lines those that somebody wants to see first.
#include "validate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <span>

#include "app.h"
#include "base/degree.h"
#include "base/hash.h"
#include "base/text.h"
#include "report.h"
#include "validate/findings.h"
#include "validate_work.h"

namespace stig::cli {
namespace {

double in_mm(double metres) { return metres * 1e3; }
double degrees(double radians) { return radians / kDegree; }

Json brick_json(const RuleSet& rules, const BrickCheck& brick) {
  // Keys with a unit in their name are in that unit; all others are SI, as in the library.
  Json json{{"cell", to_json(brick.cell)},
            {"brick", rules.brick(brick.wanted).name},
            {"start", brick.start},
            {"there", brick.block.has_value()}};
  // A missing brick has no figures.
  if (!brick.block) return json;
  json["shows"] = to_string(brick.led);
  json["off_mm"] = {in_mm(brick.off.x), in_mm(brick.off.y), in_mm(brick.off.z)};
  json["yaw_degrees"] = degrees(brick.yaw);
  json["turn_degrees"] = degrees(brick.turn);
  json["drift_mm"] = in_mm(length(brick.drift));
  return json;
}

Json robot_json(const RobotRecord& robot) {
  Json json{{"name", robot.name},
            {"driven_m", robot.driven},
            {"state", robot.state},
            {"since", robot.since},
            {"holding", robot.holding},
            {"failed", robot.failed},
            {"halted", robot.halted},
            {"left", robot.left},
            {"fallen", robot.fallen},
            {"ideal_s", robot.ideal},
            {"still_s", robot.still},
            {"idle_s", robot.idle_time()},
            {"wheels_J", robot.energy.wheels},
            {"lift_J", robot.energy.lift},
            {"current_s", robot.energy.current_time}};
  // What its program shows of itself: it may be anything, or nothing.
  json["shown"] = robot.shown;
  json["states_s"] = robot.spent;
  json["idle_states_s"] = robot.idle_in;
  json["busy_at"] = robot.busy;
  return json;
}

Json judgement_json(const RuleSet& rules, const Judgement& judgement) {
  Json json{{"missing", judgement.missing()},
            {"worst_mm", in_mm(judgement.worst_way)},
            {"worst_degrees", degrees(judgement.worst_turn)},
            {"worst_joint_mm", in_mm(judgement.worst_joint_way)},
            {"worst_joint_degrees", degrees(judgement.worst_joint_turn)},
            {"worst_drift_mm", in_mm(judgement.worst_drift)},
            {"placements", judgement.placements},
            {"allowed", judgement.allowed},
            // Null: no placement was against the rules.
            {"against", judgement.against ? Json(judgement.against->reason) : Json(nullptr)}};
  json["bricks"] = Json::array();
  for (const BrickCheck& brick : judgement.bricks)
    json["bricks"].push_back(brick_json(rules, brick));
  json["extra"] = Json::array();
  for (const StrayBrick& stray : judgement.extra) {
    json["extra"].push_back({{"cell", to_json(stray.cell)},
                             {"shows", to_string(stray.led)},
                             {"in_cell", stray.in_cell},
                             {"off_mm", in_mm(length(stray.off))},
                             {"yaw_degrees", degrees(stray.yaw)}});
  }
  return json;
}

/// Of several structures: where it stands, and what became of it.
Json structure_json(const BuildTarget& target, const Trial& trial, std::size_t structure) {
  const Vec3& at = target.sites[structure].X_WL.p;
  const auto last = last_placement(trial, structure);
  Json json{{"at_m", {at.x, at.y}},
            {"verdict", to_string(trial.judgements[structure].verdict)},
            {"last_brick_s", last ? Json(*last) : Json(nullptr)}};
  json.update(judgement_json(*target.rules, trial.judgements[structure]));
  return json;
}

Json count_json(const BlockCount& count) {
  return {{"began", count.began},     {"dropped", count.dropped}, {"structure", count.structure},
          {"carried", count.carried}, {"caches", count.caches},   {"loose", count.loose},
          {"fixed", count.fixed},     {"left", count.left},       {"adds_up", count.adds_up()}};
}

// What a run is judged by comes first, then what happened, in the order of time. Keys stay in the
// order in which they are set, so outputs of equal runs are equal byte by byte.
Json trial_json(const BuildTarget& target, const Trial& trial) {
  Json json{{"seed", trial.seed},
            {"verdict", to_string(trial.verdict())},
            {"end", to_string(trial.end)},
            {"time", trial.time},
            {"efficiency", summary_of(target, std::span(&trial, 1)).efficiency()},
            {"findings", findings_of(target, trial)}};
  // One structure is the run's own; of several each has a number, from 1 on.
  const bool several = trial.judgements.size() > 1;
  if (!several) json.update(judgement_json(*target.rules, trial.judgements.front()));
  for (std::size_t i = 0; several && i < trial.judgements.size(); ++i) {
    json["structures"].push_back(structure_json(target, trial, i));
  }
  json["events"] = Json::array();
  for (const BrickEvent& event : trial.events) {
    json["events"].push_back(
        {{"time", event.time},
         {"what", event.kind == BrickEvent::Kind::placed ? "placed" : "left"},
         {"cell", to_json(event.cell)},
         {"shows", to_string(event.led)},
         // Nobody: it rolled there, or was pushed.
         {"by", event.robot < trial.robots.size() ? Json(trial.robots[event.robot].name)
                                                  : Json(nullptr)}});
    if (several) json["events"].back()["structure"] = event.structure + 1;
  }
  json["attempts"] = Json::array();
  for (const Haul& haul : trial.hauls) {
    json["attempts"].push_back({{"by", trial.robots[haul.robot].name},
                                {"from", haul.from},
                                {"to", haul.to},
                                {"way_m", haul.way},
                                {"placed", haul.placed ? to_json(*haul.placed) : Json(nullptr)}});
    if (several && haul.placed) json["attempts"].back()["structure"] = haul.structure + 1;
  }
  json["robots"] = Json::array();
  for (const RobotRecord& robot : trial.robots) json["robots"].push_back(robot_json(robot));
  json["blocks"] = count_json(trial.blocks);
  json["measures"] = trial.measures;
  json["hash"] = to_hex(trial.hash);
  return json;
}

// The worst of each is what the tolerance is held against.
std::string bricks_in_words(const Judgement& judgement) {
  std::string out = fmt::format("{} of {}", judgement.bricks.size() - judgement.missing(),
                                judgement.bricks.size());
  out += fmt::format(", off by {:.2f} mm and {:.2f}° at most", in_mm(judgement.worst_way),
                     degrees(judgement.worst_turn));
  return out +
         fmt::format("; neighbours by {:.2f} mm and {:.2f}°; {:.2f} mm from the start's lattice",
                     in_mm(judgement.worst_joint_way), degrees(judgement.worst_joint_turn),
                     in_mm(judgement.worst_drift));
}

/// Seconds in each state, the longest first.
std::string states_in_words(const RobotRecord& robot) {
  std::vector<std::pair<double, std::string>> states;
  // Negative, so that sorting puts the longest first and equal ones by name.
  for (const auto& [state, seconds] : robot.spent) states.emplace_back(-seconds, state);
  std::sort(states.begin(), states.end());
  std::string out;
  for (const auto& [seconds, state] : states) {
    out += fmt::format("{}{} {:.0f} s", out.empty() ? "" : ", ", printable(state), -seconds);
  }
  return out;
}

std::string robot_lines(const RobotRecord& robot) {
  const auto shown = [&](const char* name) {
    const auto found = robot.shown.find(name);
    // Other programs show other numbers; a dash is no zero.
    return found == robot.shown.end() ? std::string("-") : fmt::format("{:g}", found->second);
  };
  std::string out =
      line(printable(robot.name),
           fmt::format("{:.2f} m driven; placed {}, aborted {} ({} as the site was "
                       "busy); wheels {:.1f} J, lift {:.1f} J, current for {:.0f} s",
                       robot.driven, shown("placed"), shown("aborted"), shown("busy"),
                       robot.energy.wheels, robot.energy.lift, robot.energy.current_time));
  return robot.spent.empty() ? out : out + line("", states_in_words(robot));
}

std::string attempts_in_words(const Trial& trial) {
  const auto placed = std::count_if(trial.hauls.begin(), trial.hauls.end(),
                                    [](const Haul& haul) { return haul.placed.has_value(); });
  const auto held = std::count_if(trial.hauls.begin(), trial.hauls.end(),
                                  [](const Haul& haul) { return !haul.ended; });
  // One that was placed may have been taken again: hauls are counted one by one.
  return fmt::format("{} taken, {} placed, {} held, {} let go elsewhere",
                     counted(trial.hauls.size(), "block"), placed, held,
                     trial.hauls.size() - static_cast<std::size_t>(placed + held));
}

std::string verdict_in_colour(BuildVerdict verdict, bool color) {
  const std::string text(to_string(verdict));
  return verdict == BuildVerdict::complete ? green(text, color) : red(text, color);
}

std::string order_in_words(std::size_t placements, std::size_t allowed) {
  return fmt::format("{}, {} as the rules allow",
                     counted(static_cast<std::uint64_t>(placements), "placement"), allowed);
}

/// Of several: where each stands, and what became of it.
std::string structure_lines(const BuildTarget& target, const Trial& trial, bool color) {
  std::string out;
  for (std::size_t i = 0; i < trial.judgements.size(); ++i) {
    const Judgement& judgement = trial.judgements[i];
    const Vec3& at = target.sites[i].X_WL.p;
    const auto last = last_placement(trial, i);
    out += line(
        fmt::format("structure {}", i + 1),
        fmt::format("{}, at ({:.2f}, {:.2f}) m{}", verdict_in_colour(judgement.verdict, color),
                    at.x, at.y, last ? fmt::format("; the last brick after {:.1f} s", *last) : ""));
    out += line("", bricks_in_words(judgement));
    out += line("", order_in_words(judgement.placements, judgement.allowed));
  }
  return out;
}

std::string one_run(const ValidationReport& report, const Trial& trial, bool color) {
  const BuildTarget& target = *report.target;
  std::string out = line("verdict", fmt::format("{}: {} after {:.1f} s, seed {}",
                                                verdict_in_colour(trial.verdict(), color),
                                                to_string(trial.end), trial.time, trial.seed));
  if (trial.judgements.size() > 1) {
    out += structure_lines(target, trial, color);
  } else {
    out += line("bricks", bricks_in_words(trial.judgements.front()));
  }
  const TrialTotals all = totals_of(trial);
  out += line("order", order_in_words(all.placements, all.allowed));
  // The order in which bricks came, which is what was judged.
  for (const BrickEvent& event : trial.events) {
    out += line("", fmt::format("{:8.1f} s  {}{}{}", event.time,
                                brick_text(*target.rules, event.led, event.cell),
                                of_structure(target, event.structure),
                                event.kind == BrickEvent::Kind::placed ? "" : " left"));
  }
  out += line("blocks", count_text(trial.blocks));
  out += line("attempts", attempts_in_words(trial));
  const WorkSummary work = summary_of(*report.target, std::span(&trial, 1));
  out += line("robots", work_in_words(work)) + line("efficiency", efficiency_in_words(work));
  for (const RobotRecord& robot : trial.robots) out += robot_lines(robot);
  for (const auto& [name, value] : trial.measures) {
    out += line("measure", fmt::format("{} {:g}", printable(name), value));
  }
  for (const std::string& finding : findings_of(*report.target, trial)) {
    out += line("wrong", printable(finding));
  }
  return out + line("hash", to_hex(trial.hash));
}

// Columns are as wide as figures of usual runs; longer ones only push the rest of their line.
std::string table(const ValidationReport& report) {
  std::string out =
      fmt::format("{:>6}  {:<10}  {:<12}  {:>7}  {:>9}  {:>6}  {:>6}  {:>8}  {:>7}  {}\n", "seed",
                  "verdict", "end", "time/s", "bricks", "mm", "deg", "driven/m", "aborted", "hash");
  for (const Trial& trial : report.trials) {
    const TrialTotals all = totals_of(trial);
    double driven = 0, aborted = 0;
    for (const RobotRecord& robot : trial.robots) {
      driven += robot.driven;
      const auto found = robot.shown.find("aborted");
      // Programs that do not count aborted attempts add nothing.
      aborted += found == robot.shown.end() ? 0 : found->second;
    }
    out += fmt::format(
        "{:>6}  {:<10}  {:<12}  {:>7.1f}  {:>9}  {:>6.2f}  {:>6.2f}  {:>8.2f}  {:>7g}  {}\n",
        trial.seed, to_string(trial.verdict()), to_string(trial.end), trial.time,
        fmt::format("{} of {}", all.there, all.wanted), in_mm(all.worst_way),
        degrees(all.worst_turn), driven, aborted, to_hex(trial.hash));
  }
  return out;
}

}  // namespace

Json to_json(const ValidationReport& report) {
  assert(report.target != nullptr);
  Json json{{"rules", report.target->rules->name},
            {"complete", all_complete(report)},
            {"bricks", report.target->whole.size()},
            {"start", report.target->rules->start.size()}};
  // Bricks and start are those of each.
  if (report.target->sites.size() > 1) json["structures"] = report.target->sites.size();
  json["runs"] = Json::array();
  for (const Trial& trial : report.trials)
    json["runs"].push_back(trial_json(*report.target, trial));
  json["summary"] = to_json(summary_of(*report.target, report.trials));
  const std::vector<ProgressCurve> curves = curves_of(report);
  json["phases"] = to_json(phases_of(curves));
  // The mean over runs, at moments that all have in common (validate/progress.h).
  json["progress"] = Json::array();
  for (const ProgressBand::Row& row : band_of(curves).rows) {
    json["progress"].push_back({{"time", row.time},
                                {"mean", row.mean},
                                {"deviation", row.deviation},
                                {"least", row.least},
                                {"most", row.most},
                                {"sites", row.sites},
                                {"idle", row.idle},
                                {"busy", row.busy}});
  }
  return json;
}

std::string lines_of(const ValidationReport& report, bool color) {
  assert(report.target != nullptr && !report.trials.empty());
  std::string out = line("rules", printable(report.target->rules->name));
  // A single run in full; of many a table, and what went wrong in each.
  if (report.trials.size() == 1) return out + one_run(report, report.trials.front(), color);
  out += line("verdict", all_complete(report) ? green(verdict_text(report), color)
                                              : red(verdict_text(report), color));
  const WorkSummary all = summary_of(*report.target, report.trials);
  out += line("time", time_in_words(all)) + line("robots", work_in_words(all)) +
         line("efficiency", efficiency_in_words(all)) + table(report);
  out += lines_of(phases_of(curves_of(report))) + state_lines(all);
  for (const Trial& trial : report.trials) {
    for (const std::string& finding : findings_of(*report.target, trial)) {
      out += line(fmt::format("seed {}", trial.seed), printable(finding));
    }
  }
  return out;
}

}  // namespace stig::cli
