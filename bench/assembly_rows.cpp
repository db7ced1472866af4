// SPDX-License-Identifier: MIT
#include "assembly_rows.h"
#include "support/uses.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace stig::bench {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const BuildingRun& run) {
  return {{"robots", run.robots}, {"seed", run.seed}, {"complete", run.complete},
          {"put", run.put},       {"last", run.last}, {"what_came", run.what_came}};
}

BuildingRun run_from(const Json& json) {
  return {json.at("robots"), json.at("seed"), json.at("complete"),
          json.at("put"),    json.at("last"), json.at("what_came")};
}

/// What the rows of one kind, or of all, add up to.
struct Sum {
  int targets = 0, possible = 0, gave_up = 0, synthesised = 0, compiled = 0, any_number = 0;
  int too_few_colours = 0, contradictions = 0;
  std::size_t bricks = 0;
  double seconds = 0;
  struct Built {
    int runs = 0, complete = 0;
    int put = 0;
    double worked = 0;  ///< simulated seconds to the last brick of complete runs
  } built[2][2];        ///< by one robot and by two; of each of two seeds
};

void add(const AssemblyRow& row, Sum& to) {
  ++to.targets;
  to.possible += row.counts_as_possible() ? 1 : 0;
  to.too_few_colours += row.too_few_colours && row.possible.value_or(true) ? 1 : 0;
  const bool proved = row.proved_impossible || row.too_few_colours;
  to.gave_up += row.possible.has_value() || proved ? 0 : 1;
  to.synthesised += row.synthesised ? 1 : 0;
  to.compiled += row.compiled ? 1 : 0;
  to.any_number += row.any_number ? 1 : 0;
  to.contradictions += row.contradicts() ? 1 : 0;
  to.bricks += row.bricks;
  to.seconds += row.seconds;
  if (!row.compiled || !row.built) return;
  // What robots were not even set to counts as not built.
  for (auto& of_robots : to.built) {
    for (Sum::Built& of_seed : of_robots) ++of_seed.runs;
  }
  for (const BuildingRun& run : row.runs) {
    Sum::Built& built = to.built[run.robots - 1][run.seed - 1];
    if (!run.complete) continue;
    ++built.complete;
    built.put += run.put;
    built.worked += run.last;
  }
}

std::string per_brick(const Sum::Built (&of_seeds)[2]) {
  const int put = of_seeds[0].put + of_seeds[1].put;
  if (put == 0) return "-";
  return fmt::format("{:.1f}", (of_seeds[0].worked + of_seeds[1].worked) / put);
}

std::string line_of(const std::string& name, const Sum& sum, bool built) {
  const double count = std::max(1, sum.targets);
  std::string out = fmt::format(
      "{:<11} {:>7} {:>7.1f} {:>7} {:>8} {:>7} {:>11} {:>8} {:>7} {:>7.2f}", name, sum.targets,
      static_cast<double>(sum.bricks) / count, sum.too_few_colours, sum.possible, sum.gave_up,
      sum.synthesised, sum.compiled, sum.any_number, sum.seconds / count);
  for (int robots = 0; built && robots < 2; ++robots) {
    const auto& of_seeds = sum.built[robots];
    out += fmt::format(
        " {:>9} {:>8}",
        fmt::format("{}+{}/{}", of_seeds[0].complete, of_seeds[1].complete, of_seeds[0].runs),
        per_brick(of_seeds));
  }
  return out + (sum.contradictions > 0 ? "  THE ORACLE DISAGREES\n" : "\n");
}

void add_share(std::string_view what, int part, int of, int least, Shares& to) {
  const bool met = 100 * part >= least * of;
  to.met = to.met && met;
  to.lines += fmt::format("{:<42} {:>4} of {:>4}  {:5.1f} %  (asked for: {} %){}\n", what, part, of,
                          of > 0 ? 100.0 * part / of : 100.0, least, met ? "" : "  MISSED");
}

}  // namespace

std::string to_json_line(const AssemblyRow& row) {
  Json json{{"kind", row.kind},
            {"seed", row.seed},
            {"bricks", row.bricks},
            {"possible", row.possible ? Json(*row.possible) : Json(nullptr)},
            {"proved_impossible", row.proved_impossible},
            {"too_few_colours", row.too_few_colours},
            {"synthesised", row.synthesised},
            {"compiled", row.compiled},
            {"any_number", row.any_number},
            {"for_two", row.for_two},
            {"sides", row.sides},
            {"tried", row.tried},
            {"seconds", row.seconds},
            {"built", row.built},
            {"runs", Json::array()}};
  for (const BuildingRun& run : row.runs) json["runs"].push_back(to_json(run));
  return json.dump() + "\n";
}

std::optional<AssemblyRow> row_from_json(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  AssemblyRow row;
  row.kind = json.at("kind");
  row.seed = json.at("seed");
  row.bricks = json.at("bricks");
  if (!json.at("possible").is_null()) row.possible = json.at("possible").get<bool>();
  row.proved_impossible = json.at("proved_impossible");
  row.too_few_colours = json.at("too_few_colours");
  row.synthesised = json.at("synthesised");
  row.compiled = json.at("compiled");
  row.any_number = json.at("any_number");
  row.for_two = json.at("for_two");
  row.sides = json.at("sides");
  row.tried = json.at("tried");
  row.seconds = json.at("seconds");
  row.built = json.at("built");
  for (const Json& run : json.at("runs")) row.runs.push_back(run_from(run));
  return row;
}

std::string progress_line(const AssemblyRow& row) {
  const char* possible = row.counts_as_possible() ? row.possible ? "possible" : "perhaps" : "-";
  std::string rules = "no rules";
  if (row.synthesised) rules = row.any_number ? "any number" : "one robot";
  std::string out =
      fmt::format("{:<11} {:>10} {:>3} bricks  {:<8}  {:<10} {:>7.2f} s  {}\n", row.kind, row.seed,
                  row.bricks, possible, rules, row.seconds, row.tried);
  for (const BuildingRun& run : row.runs) {
    if (run.complete) continue;
    out += fmt::format("{:<11} {:>10} {} of seed {}: {}\n", row.kind, row.seed,
                       run.robots == 1 ? "one robot" : "two robots", run.seed, run.what_came);
  }
  return out;
}

std::string table_of(const std::vector<AssemblyRow>& rows, const std::vector<std::string>& kinds,
                     bool built) {
  std::string out =
      fmt::format("{:<11} {:>7} {:>7} {:>7} {:>8} {:>7} {:>11} {:>8} {:>7} {:>7}{}\n", "kind",
                  "targets", "bricks", "colours", "possible", "unknown", "synthesised", "compiled",
                  "any no.", "s", built ? "    by one  s/brick    by two  s/brick" : "");
  Sum all;
  for (const std::string& kind : kinds) {
    Sum sum;
    for (const AssemblyRow& row : rows) {
      if (row.kind != kind) continue;
      add(row, sum);
      add(row, all);
    }
    out += line_of(kind, sum, built);
  }
  return out + line_of("all", all, built);
}

Shares shares_of(const std::vector<AssemblyRow>& rows, bool built) {
  Sum all;
  int compiled_of_possible = 0;
  for (const AssemblyRow& row : rows) {
    add(row, all);
    compiled_of_possible += row.compiled && row.counts_as_possible() ? 1 : 0;
  }
  Shares out;
  add_share("compiled, of what is possible", compiled_of_possible, all.possible, 95, out);
  if (built) {
    for (const int seed : {0, 1}) {
      const auto& one = all.built[0][seed];
      add_share(fmt::format("built by one robot, seed {}", seed + 1), one.complete, one.runs, 95,
                out);
    }
    for (const int seed : {0, 1}) {
      const auto& two = all.built[1][seed];
      add_share(fmt::format("built by two robots, seed {}", seed + 1), two.complete, two.runs, 90,
                out);
    }
  }
  out.met = out.met && all.contradictions == 0;
  return out;
}

}  // namespace stig::bench
