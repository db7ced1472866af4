// SPDX-License-Identifier: MIT
// How many targets of each kind a robot can build, and how many get rules that it can follow:
//
//   bench_assembly [SEEDS [FIRST_SEED [KIND…]]]
//
// A table of its own, a line a kind. "possible" is what an oracle that knows everything could have
// built; where it gives up, a target counts as possible.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
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
  std::size_t bricks = 0, candidates = 0;
  double seconds = 0;
};

void add(const Row& one, Row& to) {
  to.targets += one.targets;
  to.possible += one.possible;
  to.compiled += one.compiled;
  to.any_number += one.any_number;
  to.wrong += one.wrong;
  to.bricks += one.bricks;
  to.candidates += one.candidates;
  to.seconds += one.seconds;
}

bool possible(const Target& target, const Abilities& robot) {
  std::vector<PlacedBrick> bricks;
  for (const Cell cell : target.cells) bricks.push_back({cell, 1});
  const Builders builders{robot, {kAllSides.begin(), kAllSides.end()}};
  return can_be_built(TargetBricks(bricks, 0), builders, kMostSets).value_or(true);
}

Row measure(const std::string& kind, std::uint64_t seed, const Abilities& robot) {
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
  row.possible = possible(task.target, robot) ? 1 : 0;
  row.compiled = made.plan ? 1 : 0;
  row.any_number = made.plan && made.plan->any_number ? 1 : 0;
  row.wrong = row.compiled > row.possible ? 1 : 0;
  row.candidates = made.counts.candidates;
  const AssemblyCounts& c = made.counts;
  std::cerr << fmt::format(
      "{:11} {:4} {:3} bricks {} {:8} {:7.2f} s: {} tried, {} no order, {} walked, {} too large, "
      "{} dead "
      "ends, {} no colours, {} refused\n",
      kind, seed, row.bricks, row.possible ? "possible" : "-       ",
      !made.plan       ? "NOT"
      : row.any_number ? "any"
                       : "one",
      row.seconds, c.candidates, c.no_order, c.walked, c.too_large, c.dead_end, c.no_colours,
      c.refused);
  return row;
}

std::string line(const std::string& kind, const Row& row) {
  return fmt::format("{:11} {:7} {:8} {:8} {:10} {:7.1f} {:10.1f} {:9.2f}{}\n", kind, row.targets,
                     row.possible, row.compiled, row.any_number,
                     static_cast<double>(row.bricks) / row.targets,
                     static_cast<double>(row.candidates) / row.targets, row.seconds / row.targets,
                     row.wrong > 0 ? "  more than the oracle" : "");
}

}  // namespace
}  // namespace stig

int main(int argc, char** argv) {
  using namespace stig;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::uint64_t seeds = !arguments.empty() ? std::stoull(arguments[0]) : 10;
  const std::uint64_t first = arguments.size() > 1 ? std::stoull(arguments[1]) : 1;
  std::vector<std::string> kinds(kTargetKinds.begin(), kTargetKinds.end());
  if (arguments.size() > 2) kinds.assign(arguments.begin() + 2, arguments.end());
  const Abilities robot = paper_robot();
  std::cout << "kind        targets possible compiled any number  bricks candidates   seconds\n";
  Row all;
  for (const std::string& kind : kinds) {
    Row row;
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
      add(measure(kind, seed, robot), row);
    }
    std::cout << line(kind, row) << std::flush;
    add(row, all);
  }
  std::cout << line("all", all);
}
