// SPDX-License-Identifier: MIT
#include "assembly_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "assembly/assemble.h"
#include "assembly/oracle.h"
#include "assembly/targets.h"
#include "paper_robot.h"
#include "rules/rule_reader.h"
#include "support/uses.h"

namespace stig::bench {

namespace {

/// The oracle gives up beyond.
constexpr std::size_t kMostSets = 200'000;
constexpr double kEffort = 1;  ///< the program's own

std::optional<bool> possible(const Target& target) {
  std::vector<PlacedBrick> bricks;
  for (const Cell cell : target.cells) bricks.push_back({cell, 1});
  const Builders builders{paper_robot(), {kAllSides.begin(), kAllSides.end()}};
  return can_be_built(TargetBricks(bricks, 0), builders, kMostSets);
}

/// By nothing but what the file says.
bool compiles(const std::string& text) {
  Diagnostics diagnostics;
  const auto rules =
      read_rule_set(std::make_shared<const SourceFile>("rules.yaml", text), diagnostics);
  if (!rules) return false;
  return compile_rules(*rules, paper_robot(), {}, diagnostics).decision != nullptr &&
         !diagnostics.has_errors();
}

std::string in_words(const AssemblyCounts& c) {
  std::string out = fmt::format("{} tried", c.candidates);
  const std::pair<std::size_t, const char*> causes[] = {{c.no_order, "no order"},
                                                        {c.too_large, "too large"},
                                                        {c.dead_end, "dead ends"},
                                                        {c.no_colours, "no colours"},
                                                        {c.refused, "refused"}};
  for (const auto& [count, what] : causes) {
    if (count > 0) out += fmt::format(", {} {}", count, what);
  }
  return out;
}

/// What `stigc validate --json` says of one run, or nothing.
nlohmann::json validated(const std::string& stigc, const std::string& rules, int robots, int seed) {
  const std::string command =
      fmt::format("'{}' -q validate '{}' --robots {} --seed {} --threads 1 --json 2>/dev/null",
                  stigc, rules, robots, seed);
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string text;
  std::array<char, 4096> some{};
  while (const std::size_t count = fread(some.data(), 1, some.size(), pipe)) {
    text.append(some.data(), count);
  }
  pclose(pipe);
  const auto report = nlohmann::json::parse(text, nullptr, false);
  return report.is_object() && !report["runs"].empty() ? report["runs"][0] : nlohmann::json();
}

BuildingRun build(const std::string& stigc, const std::string& rules, int robots, int seed) {
  BuildingRun out;
  out.robots = robots;
  out.seed = seed;
  const nlohmann::json run = validated(stigc, rules, robots, seed);
  if (!run.is_object()) {
    out.what_came = "stigc validate did not run it";
    return out;
  }
  out.complete = run["verdict"] == "complete";
  for (const auto& event : run["events"]) {
    out.put += event["what"] == "placed" ? 1 : -1;
    if (event["what"] == "placed") out.last = event["time"];
  }
  if (out.complete) return out;
  out.what_came = fmt::format("{} after {:.0f} s, {} missing", run["verdict"].get<std::string>(),
                              run["time"].get<double>(), run["missing"].get<int>());
  if (!run["findings"].empty()) out.what_came += "; " + run["findings"][0].get<std::string>();
  return out;
}

std::string write_rules(const std::string& folder, std::string name, const std::string& text) {
  std::replace(name.begin(), name.end(), ' ', '-');
  std::string path = fmt::format("{}/{}.yaml", folder, name);
  std::ofstream(path) << text;
  return path;
}

}  // namespace

AssemblyRow try_target(const std::string& kind, std::uint64_t seed, const std::string& stigc,
                       const std::string& folder) {
  AssemblyTask task;
  task.target = drawn_target(kind, seed);
  task.robot = paper_robot();
  task.wording = {"target", fmt::format("{} {}", kind, seed), {}};
  const auto before = std::chrono::steady_clock::now();
  const Assembly made = assemble(task, kEffort);
  AssemblyRow row;
  row.kind = kind;
  row.seed = seed;
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  row.bricks = task.target.cells.size();
  // The oracle knows every brick; that colours do not do says nothing about it.
  row.too_few_colours = made.obstacle && takes_more_colours(*made.obstacle);
  row.proved_impossible = made.obstacle && !row.too_few_colours;
  row.possible = possible(task.target);
  row.tried = in_words(made.counts);
  row.built = !stigc.empty();
  if (!made.plan) return row;
  row.synthesised = true;
  row.compiled = compiles(made.plan->text);
  row.any_number = made.plan->any_number;
  row.for_two = row.any_number || (made.plan->one_a_side && made.plan->compiled.sides.size() > 1);
  row.sides = made.plan->compiled.sides.size();
  const std::string name = fmt::format("{}-{}", kind, seed);
  const std::string rules = write_rules(folder, name, made.plan->text);
  if (!row.compiled || stigc.empty()) return row;
  std::string rules_for_two = rules;
  if (!row.for_two) {
    task.robots = 2;
    const Assembly other = assemble(task, kEffort);
    row.for_two = other.plan.has_value();
    if (other.plan) rules_for_two = write_rules(folder, name + "-two", other.plan->text);
  }
  for (const int run : {1, 2}) row.runs.push_back(build(stigc, rules, 1, run));
  for (const int run : {1, 2}) {
    if (row.for_two) row.runs.push_back(build(stigc, rules_for_two, 2, run));
  }
  return row;
}

}  // namespace stig::bench
