// SPDX-License-Identifier: MIT
// How many targets of each kind a robot can build, and how many get rules that it can follow:
//
//   bench_assembly [--build STIGC] [SEEDS [FIRST_SEED [KIND…]]]
//
// A table of its own, a line a kind. "possible" is what an oracle that knows everything could have
// built; where it gives up, a target counts as possible unless it is proved not to be. With --build
// and a stigc, what is compiled is built as physics has it, by `stigc validate` (minutes): by one
// robot with each of two seeds, and by two.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "assembly/assemble.h"
#include "assembly/oracle.h"
#include "assembly/targets.h"
#include "compiler/block_figures.h"
#include "robots/block.h"
#include "robots/robot_reader.h"

namespace stig {
namespace {

constexpr std::size_t kMostSets = 200'000;

SourceRef source(const std::string& path) {
  std::ifstream file(std::string(STIG_SOURCE_DIR) + "/" + path);
  return std::make_shared<const SourceFile>(path,
                                            std::string(std::istreambuf_iterator<char>(file), {}));
}

Abilities paper_robot() {
  Diagnostics diagnostics;
  const auto robot = read_robot(source("robots/bebot.yaml"), diagnostics);
  const auto block = read_block(source("blocks/stigmergic.yaml"), diagnostics);
  if (!robot || !block) std::abort();
  return abilities_of(*robot, figures_of(*block));
}

struct Row {
  int targets = 0, possible = 0, compiled = 0, any_number = 0, wrong = 0;
  int runs_of_one = 0, built_by_one = 0, runs_of_two = 0, built_by_two = 0;
  std::size_t bricks = 0, candidates = 0, put = 0;
  double seconds = 0, worked = 0;  ///< worked: simulated, by one robot, for what it put
};

void add(const Row& one, Row& to) {
  to.targets += one.targets;
  to.possible += one.possible;
  to.compiled += one.compiled;
  to.any_number += one.any_number;
  to.wrong += one.wrong;
  to.runs_of_one += one.runs_of_one;
  to.built_by_one += one.built_by_one;
  to.runs_of_two += one.runs_of_two;
  to.built_by_two += one.built_by_two;
  to.bricks += one.bricks;
  to.candidates += one.candidates;
  to.put += one.put;
  to.seconds += one.seconds;
  to.worked += one.worked;
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

/// Two runs by one robot, and one by two where they can.
void build(const std::string& stigc, const AssemblyPlan& plan, const std::string& what, Row& row) {
  const std::string path = fmt::format("{}/bench_assembly-{}.yaml",
                                       std::filesystem::temp_directory_path().string(), getpid());
  std::ofstream(path) << plan.text;
  for (const auto& [robots, seed] : {std::pair(1, 1), {1, 2}, {2, 1}}) {
    if (robots > 1 && !plan.any_number) continue;
    const nlohmann::json run = validated(stigc, path, robots, seed);
    const bool built = run.is_object() && run["verdict"] == "complete";
    (robots == 1 ? row.runs_of_one : row.runs_of_two) += 1;
    (robots == 1 ? row.built_by_one : row.built_by_two) += built ? 1 : 0;
    if (built && robots == 1) {
      row.put += plan.work.size();
      row.worked += run["time"].get<double>();
    }
    if (!built) std::cerr << fmt::format("{}, {} robots, seed {}: NOT BUILT\n", what, robots, seed);
  }
  std::filesystem::remove(path);
}

bool possible(const Target& target, const Abilities& robot) {
  std::vector<PlacedBrick> bricks;
  for (const Cell cell : target.cells) bricks.push_back({cell, 1});
  const Builders builders{robot, {kAllSides.begin(), kAllSides.end()}};
  return can_be_built(TargetBricks(bricks, 0), builders, kMostSets).value_or(true);
}

Row measure(const std::string& kind, std::uint64_t seed, const Abilities& robot,
            const std::string& stigc) {
  AssemblyTask task;
  task.target = drawn_target(kind, seed);
  task.robot = robot;
  task.wording = {"target", kind, {}};
  const auto before = std::chrono::steady_clock::now();
  const Assembly made = assemble(task, 1);
  Row row;
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  row.targets = 1;
  row.bricks = task.target.cells.size();
  row.possible = !made.obstacle && possible(task.target, robot) ? 1 : 0;
  row.compiled = made.plan ? 1 : 0;
  row.any_number = made.plan && made.plan->any_number ? 1 : 0;
  row.wrong = row.compiled > row.possible ? 1 : 0;
  row.candidates = made.counts.candidates;
  const AssemblyCounts& c = made.counts;
  std::cerr << fmt::format(
      "{:11} {:4} {:3} bricks {} {:8} {:7.2f} s: {} tried, {} no order, {} looked at, {} too "
      "large, "
      "{} dead "
      "ends, {} no colours, {} refused\n",
      kind, seed, row.bricks, row.possible ? "possible" : "-       ",
      !made.plan       ? "NOT"
      : row.any_number ? "any"
                       : "one",
      row.seconds, c.candidates, c.no_order, c.looked_at, c.too_large, c.dead_end, c.no_colours,
      c.refused);
  if (made.plan && !stigc.empty()) build(stigc, *made.plan, fmt::format("{} {}", kind, seed), row);
  return row;
}

std::string line(const std::string& kind, const Row& row) {
  std::string out = fmt::format(
      "{:11} {:7} {:8} {:8} {:10} {:7.1f} {:10.1f} {:9.2f}", kind, row.targets, row.possible,
      row.compiled, row.any_number, static_cast<double>(row.bricks) / row.targets,
      static_cast<double>(row.candidates) / row.targets, row.seconds / row.targets);
  if (row.runs_of_one > 0) {
    out += fmt::format("  {:3} of {:3}  {:3} of {:3} {:8.1f}", row.built_by_one, row.runs_of_one,
                       row.built_by_two, row.runs_of_two,
                       row.put > 0 ? row.worked / static_cast<double>(row.put) : 0.0);
  }
  return out + (row.wrong > 0 ? "  more than the oracle\n" : "\n");
}

}  // namespace
}  // namespace stig

int main(int argc, char** argv) {
  using namespace stig;
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::string stigc;
  if (arguments.size() > 1 && arguments[0] == "--build") {
    stigc = arguments[1];
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  const std::uint64_t seeds = !arguments.empty() ? std::stoull(arguments[0]) : 10;
  const std::uint64_t first = arguments.size() > 1 ? std::stoull(arguments[1]) : 1;
  std::vector<std::string> kinds(kTargetKinds.begin(), kTargetKinds.end());
  if (arguments.size() > 2) kinds.assign(arguments.begin() + 2, arguments.end());
  const Abilities robot = paper_robot();
  std::cout << "kind        targets possible compiled any number  bricks candidates   seconds"
            << (stigc.empty() ? "\n" : "   by one      by two   s/brick\n");
  Row all;
  for (const std::string& kind : kinds) {
    Row row;
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
      add(measure(kind, seed, robot, stigc), row);
    }
    std::cout << line(kind, row) << std::flush;
    add(row, all);
  }
  std::cout << line("all", all);
}
