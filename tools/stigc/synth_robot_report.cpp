// SPDX-License-Identifier: MIT
// What synth --robot prints.
//
// A plan is shown as a drawing of numbers: when each brick is put, and from which side. A refusal
// is shown as the bricks that stand in the way of every order (assembly/remainder.h).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "assembly/expected_time.h"
#include "base/text.h"
#include "compiler/conflict_text.h"
#include "lattice/structure_text.h"
#include "report.h"
#include "rules/cell_text.h"
#include "synth_robot.h"
#include "synth_words.h"

namespace stig::cli {
namespace {

/// So many bricks of a remainder are spoken of; the rest looks like them.
constexpr std::size_t kMostBarred = 4;
constexpr std::int32_t kMostDrawnAcross = 20;
constexpr std::size_t kMostOpenShown = 60, kPartsOfWork = 10;

std::string sides_text(const std::vector<ApproachSide>& sides) {
  std::vector<std::string_view> words;
  for (const ApproachSide side : sides) words.push_back(to_string(side));
  return fmt::format("{}", fmt::join(words, " "));
}

std::size_t colours_of(const AssemblyPlan& plan) {
  std::set<Colour> used;
  for (const PlacedBrick& brick : plan.compiled.proof.structure->bricks()) used.insert(brick.brick);
  return used.size();
}

/// Slices from the top down: of each brick when it is put and from where. Empty for what is too
/// large to be looked at.
std::string order_drawing(const AssemblyPlan& plan) {
  // The start is the first brick.
  std::map<Cell, std::string> text = {{plan.start, "1"}};
  Cell low = plan.start, high = plan.start;
  for (const WorkStep& step : plan.work) {
    // The number is how many have been put, this one included.
    text[step.at] = fmt::format("{}{}", text.size() + 1, to_string(step.from));
    low = {std::min(low.x, step.at.x), std::min(low.y, step.at.y), 0};
    high = {std::max(high.x, step.at.x), std::max(high.y, step.at.y), std::max(high.z, step.at.z)};
  }
  if (high.x - low.x >= kMostDrawnAcross || high.y - low.y >= kMostDrawnAcross) return {};
  std::size_t width = 1;
  // In bytes, which are columns here: digits and signs.
  for (const auto& [cell, word] : text) width = std::max(width, word.size());
  std::string out;
  for (int z = high.z; z >= 0; --z) {
    for (int y = high.y; y >= low.y; --y) {
      std::string row;
      for (int x = low.x; x <= high.x; ++x) {
        const auto found = text.find({x, y, z});
        row += fmt::format(" {:>{}}", found == text.end() ? "." : found->second, width);
      }
      out += "   " + row + "\n";
    }
    if (z > 0) out += "    ---\n";
  }
  return out;
}

/// Means over equal parts of the work.
std::vector<double> open_by_parts(const std::vector<WorkStep>& work) {
  std::vector<double> out;
  for (std::size_t part = 0; part < kPartsOfWork; ++part) {
    const std::size_t from = work.size() * part / kPartsOfWork;
    const std::size_t to = work.size() * (part + 1) / kPartsOfWork;
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += static_cast<double>(work[i].open);
    out.push_back(sum / static_cast<double>(to - from));
  }
  return out;
}

std::string open_text(const std::vector<WorkStep>& work) {
  std::size_t most = 0, sum = 0;
  for (const WorkStep& step : work) {
    most = std::max(most, step.open);
    sum += step.open;
  }
  const std::string out =
      fmt::format("{:.1f} on average, {} at most",
                  static_cast<double>(sum) / static_cast<double>(work.size()), most);
  if (work.size() > kMostOpenShown) {
    return fmt::format("{}; by tenths of the work {:.1f}", out,
                       fmt::join(open_by_parts(work), " "));
  }
  std::vector<std::size_t> open;
  for (const WorkStep& step : work) open.push_back(step.open);
  return fmt::format("{}: {}", out, fmt::join(open, " "));
}

/// As many as were asked for; one and two where nobody said.
std::vector<int> robots_of(const AssemblyPlan& plan) {
  if (plan.compiled.robots) return {*plan.compiled.robots};
  return plan.any_number ? std::vector<int>{1, 2} : std::vector<int>{1};
}

std::string time_text(const AssemblyPlan& plan) {
  std::vector<std::string> parts;
  for (const int robots : robots_of(plan)) {
    parts.push_back(fmt::format("{:.0f} min by {}", expected_seconds(plan.work, robots) / 60,
                                counted(static_cast<std::size_t>(robots), "robot")));
  }
  return fmt::format("about {}, at {:.0f} s a brick", fmt::join(parts, ", "), kSecondsOfBrick);
}

std::string remainder_drawing(const Target& target, const BrickSet& left) {
  Structure structure(Lattice::cubic);
  for (std::size_t i = 0; i < target.cells.size(); ++i) {
    // Bricks that are left over are drawn as #, those that could be taken away as o.
    structure.place(target.cells[i], static_cast<Colour>(left.has(i) ? 1 : 2));
  }
  std::vector<Brick> bricks(2);
  bricks[0].symbol = "#";
  bricks[1].symbol = "o";
  return small_drawing(structure, bricks);
}

std::string remainder_lines(const Target& target, const Remainder& remainder) {
  std::string out = fmt::format(
      "take the finished structure apart, brick by brick, each as it could have been put last: "
      "{} of {} (#) are left, and none of them can be put last\n",
      remainder.bricks.count(), counted(target.cells.size(), "brick"));
  out += remainder_drawing(target, remainder.bricks);
  for (std::size_t i = 0; i < std::min(kMostBarred, remainder.barred.size()); ++i) {
    const BarredBrick& one = remainder.barred[i];
    out += fmt::format("  the brick at {}\n", cell_text(target.cells[one.brick]));
    for (const Bar& bar : one.bars) {
      out += fmt::format("    from {}: {}\n", to_string(bar.side), explain(bar.why));
    }
    if (one.joins) {
      out += fmt::format("    the bricks at {} and {} hang together through it alone\n",
                         cell_text(target.cells[one.joins->first]),
                         cell_text(target.cells[one.joins->second]));
    }
  }
  // Others are barred for reasons of the same kind.
  if (remainder.barred.size() > kMostBarred) {
    out += fmt::format("  and {} more\n", remainder.barred.size() - kMostBarred);
  }
  return out;
}

std::string run_lines(const Target& target, const AssemblyObstacle& obstacle) {
  std::string out = fmt::format(
      "of a row of bricks that stands alone (#) a rule sees one brick at a time; with {} it goes "
      "on for {} from the start, or from where it leaves the rest, and no farther\n",
      counted(static_cast<std::size_t>(obstacle.colours), "colour"),
      counted(static_cast<std::size_t>(obstacle.colours - 1), "brick"));
  BrickSet shown(target.cells.size());
  for (const FreeRun& run : obstacle.runs) {
    for (const Cell cell : run) {
      const auto at = std::lower_bound(target.cells.begin(), target.cells.end(), cell);
      shown.add(static_cast<std::size_t>(at - target.cells.begin()));
    }
  }
  out += remainder_drawing(target, shown);
  for (const FreeRun& run : obstacle.runs) {
    out += fmt::format("  from {} to its end at {}: {} after the first\n", cell_text(run.front()),
                       cell_text(run.back()), counted(run.size() - 1, "brick"));
  }
  return out;
}

std::string stretch_line(const AssemblyObstacle& obstacle) {
  const Stretch& stretch = obstacle.stretch;
  const char axis = stretch.along_x ? 'x' : 'y';
  return fmt::format(
      "the slices from {0} = {1} to {0} = {2} are alike, {3} each; with {4} at most {5} of the "
      "cuts "
      "between them on one side of the start differ in what is put across them, and where two do "
      "not, what rules build beyond the one they also build beyond the other\n",
      axis, stretch.first, stretch.last, counted(stretch.bricks_of_slice, "brick"),
      counted(static_cast<std::size_t>(obstacle.colours), "colour"), stretch.crossings);
}

std::string no_rules_line(const AssemblyObstacle& obstacle) {
  return fmt::format(
      "with {} there are no rules that robots could follow, whatever the colours, the rules and "
      "what "
      "robots decide: refuted from each of {}, over {} on the way at most, by proofs that were "
      "checked\n",
      counted(static_cast<std::size_t>(obstacle.colours), "colour"),
      counted(obstacle.starts, "start"), counted(obstacle.structures, "structure"));
}

std::string_view word_of(AssemblyObstacle::Kind kind) {
  switch (kind) {
    case AssemblyObstacle::Kind::apart:
      return "not-connected";
    case AssemblyObstacle::Kind::remainder:
      return "remainder";
    case AssemblyObstacle::Kind::stretch:
      return "stretch";
    case AssemblyObstacle::Kind::runs:
      return "runs";
    case AssemblyObstacle::Kind::rules:
      return "no-rules";
    case AssemblyObstacle::Kind::exhausted:
      break;
  }
  return "every-order";
}

Json obstacle_json(const Target& target, const AssemblyObstacle& obstacle) {
  Json out = {{"reason", word_of(obstacle.kind)}};
  for (const FreeRun& run : obstacle.runs) {
    Json cells = Json::array();
    for (const Cell cell : run) cells.push_back(to_json(cell));
    out["runs"].push_back(std::move(cells));
  }
  if (obstacle.kind == AssemblyObstacle::Kind::stretch) {
    const Stretch& stretch = obstacle.stretch;
    out["colours"] = obstacle.colours;
    out["stretch"] = {{"along", stretch.along_x ? "x" : "y"},
                      {"first", stretch.first},
                      {"last", stretch.last},
                      {"bricks_of_slice", stretch.bricks_of_slice},
                      {"crossings", stretch.crossings}};
  }
  if (obstacle.kind == AssemblyObstacle::Kind::rules) {
    out["colours"] = obstacle.colours;
    out["starts"] = obstacle.starts;
    out["structures"] = obstacle.structures;
  }
  if (obstacle.kind != AssemblyObstacle::Kind::remainder) return out;
  out["remainder"] = Json::array();
  for (std::size_t i = 0; i < target.cells.size(); ++i) {
    if (obstacle.remainder.bricks.has(i)) out["remainder"].push_back(to_json(target.cells[i]));
  }
  out["barred"] = Json::array();
  for (const BarredBrick& one : obstacle.remainder.barred) {
    Json bars = Json::object();
    for (const Bar& bar : one.bars) bars[std::string(to_string(bar.side))] = explain(bar.why);
    out["barred"].push_back({{"at", to_json(target.cells[one.brick])}, {"from", std::move(bars)}});
    if (!one.joins) continue;
    out["barred"].back()["joins"] = {to_json(target.cells[one.joins->first]),
                                     to_json(target.cells[one.joins->second])};
  }
  return out;
}

Json plan_json(const AssemblyPlan& plan) {
  const CompiledRules& compiled = plan.compiled;
  Json out = {{"proof", to_string(compiled.proof.verdict)},
              {"method", to_string(compiled.proof.method)},
              {"local_states", compiled.proof.local_states},
              {"structures", structures_on_the_way(compiled)},
              {"situations", compiled.local_situations},
              {"colours", colours_of(plan)},
              {"rules", plan.rules->rules.size()},
              {"start", to_json(plan.start)},
              {"sides", Json::array()},
              {"robots", compiled.robots ? Json(*compiled.robots) : Json(nullptr)},
              {"any_number", plan.any_number},
              {"expected_time", Json::array()},
              {"order", Json::array()}};
  for (const ApproachSide side : compiled.sides) out["sides"].push_back(to_string(side));
  for (const int robots : robots_of(plan)) {
    out["expected_time"].push_back(
        {{"robots", robots}, {"s", std::round(expected_seconds(plan.work, robots))}});
  }
  for (const WorkStep& step : plan.work) {
    out["order"].push_back(
        {{"at", to_json(step.at)}, {"from", to_string(step.from)}, {"open", step.open}});
  }
  return out;
}

}  // namespace

std::string counts_in_words(const AssemblyCounts& counts) {
  std::vector<std::string> parts;
  const auto add = [&](std::size_t number, const char* what) {
    if (number > 0) parts.push_back(fmt::format("{} {}", number, what));
  };
  add(counts.no_order, "without an order of work");
  add(counts.dead_end, "in which robots could get stuck");
  add(counts.no_colours, "that the colours do not do for");
  add(counts.too_large, "with too many structures on the way");
  add(counts.refused, "that compile refused");
  return fmt::format("none of {} does{}{}", counted(counts.candidates, "candidate"),
                     parts.empty() ? "" : ": ", fmt::join(parts, ", "));
}

std::string plan_lines(const Target& target, const Assembly& made) {
  const AssemblyPlan& plan = *made.plan;
  const CompiledRules& compiled = plan.compiled;
  std::string out = line("bricks", fmt::to_string(target.cells.size()));
  out += line("colours", fmt::to_string(colours_of(plan)));
  out += line("rules", fmt::to_string(plan.rules->rules.size()));
  out += line("sides", sides_text(compiled.sides));
  out += line("robots", robots_text(compiled));
  out += line("order", fmt::format("of {}; the number says when, the sign from which side",
                                   counted(made.counts.candidates, "candidate")));
  out += order_drawing(plan);
  if (!plan.work.empty()) {
    out += line("sites open", open_text(plan.work));
    out += line("time", time_text(plan));
  }
  return out + line("proof", fmt::format("every order of events builds it ({} local states); {}",
                                         compiled.proof.local_states, completion_text(compiled)));
}

std::string obstacle_lines(const Target& target, const AssemblyObstacle& obstacle, bool color) {
  const std::string impossible = red("impossible", color) + ": ";
  switch (obstacle.kind) {
    case AssemblyObstacle::Kind::apart:
      return impossible +
             fmt::format(
                 "{} of {} share no face with the rest, and robots put bricks next to others\n",
                 target.cells.size() - obstacle.part.count(),
                 counted(target.cells.size(), "brick")) +
             remainder_drawing(target, obstacle.part);
    case AssemblyObstacle::Kind::remainder:
      return impossible + remainder_lines(target, obstacle.remainder);
    case AssemblyObstacle::Kind::stretch:
      return impossible + stretch_line(obstacle);
    case AssemblyObstacle::Kind::runs:
      return impossible + run_lines(target, obstacle);
    case AssemblyObstacle::Kind::rules:
      return impossible + no_rules_line(obstacle);
    case AssemblyObstacle::Kind::exhausted:
      break;
  }
  return impossible + "every order of work was looked at, and each leaves a brick out of reach\n";
}

namespace {

std::string remedy_text(const AssemblyRemedy& remedy) {
  return fmt::format("{}: compiled, for {}", remedy.what,
                     remedy.any_number ? "any number of robots" : "one robot");
}

}  // namespace

std::string remedy_lines(const std::vector<AssemblyRemedy>& remedies) {
  std::string out;
  for (const AssemblyRemedy& one : remedies) out += "  remedy: " + remedy_text(one) + "\n";
  return out;
}

std::string assembly_json(const SynthOptions& options, const Target& target, const Assembly& made,
                          const std::vector<AssemblyRemedy>& remedies, bool cut_short,
                          double seconds, const std::vector<std::string>& written) {
  Json json = {{"target", options.target}, {"bricks", target.cells.size()}};
  if (made.plan) {
    json["verdict"] = "compiled";
    // Members of the plan stand beside the verdict, not under a key.
    json.update(plan_json(*made.plan));
  } else if (made.obstacle) {
    json["verdict"] = "impossible";
    json.update(obstacle_json(target, *made.obstacle));
  } else {
    json["verdict"] = made.too_many ? "unknown" : made.cut_short ? early_verdict() : "not-found";
  }
  if (!made.plan) {
    json["remedies"] = Json::array();
    for (const AssemblyRemedy& one : remedies) json["remedies"].push_back(remedy_text(one));
  }
  json["impossible"] = made.obstacle.has_value();
  json["cut_short"] = cut_short;
  json["candidates"] = made.counts.candidates;
  json["seconds"] = seconds;
  if (!written.empty()) json["written"] = written;
  return dump(json);
}

}  // namespace stig::cli
