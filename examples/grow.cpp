// SPDX-License-Identifier: MIT
// Reads a rule set, lets a swarm of walking agents build by it, and measures what stands:
// stig::rules and stig::lattice.
//
//     grow [RULESET]
#include <iostream>

#include "lattice/measures.h"
#include "lattice/structure_text.h"
#include "lattice/swarm.h"
#include "rules/rule_reader.h"
#include "rules/rule_table.h"

int main(int argc, char** argv) {
  // Readers report all that is wrong with a file at once, each with its line, and return nothing.
  stig::Diagnostics diagnostics;
  const auto rules = stig::rules::read_rule_set_file(
      argc > 1 ? argv[1] : STIG_DATA "/rulesets/staircase.yaml", diagnostics);
  std::cerr << stig::to_text(diagnostics);
  if (!rules) return 1;

  // A RuleSet is what the author wrote; a RuleTable is the same compiled for matching.
  const stig::rules::RuleTable table(*rules);

  // Agents that walk need a box. The same config gives the same structure on every machine.
  stig::lattice::SwarmConfig config;
  config.motion = stig::lattice::Motion::walk;
  config.agents = 5;
  config.box = stig::lattice::Box{{-4, -4, 0}, {9, 9, 6}, /*periodic=*/false, rules->floor};
  config.seed = 1;
  config.max_steps = 100'000;
  if (const std::string problem = stig::lattice::config_problem(table, rules->start, config);
      !problem.empty()) {
    std::cerr << problem << '\n';
    return 1;
  }
  const stig::lattice::SwarmResult result = stig::lattice::run_swarm(table, rules->start, config);

  const stig::lattice::Measures measures = stig::lattice::measure(result.structure);
  std::cout << stig::lattice::print_structure(result.structure, rules->bricks) << result.deposits
            << " bricks placed, " << to_string(result.terminated) << "; " << measures.components
            << " component, " << measures.mean_neighbours << " neighbours on average\n";
  for (std::size_t rule = 0; rule < result.rules.size(); ++rule) {
    std::cout << rules->rules[rule].name << ": " << result.rules[rule].fired << '\n';
  }
}
