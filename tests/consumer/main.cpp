// SPDX-License-Identifier: MIT
// Reads an installed rule set, grows it, and draws what stands: each layer is linked.
#include <iostream>

#include "base/diagnostic.h"
#include "lattice/structure_text.h"
#include "lattice/swarm.h"
#include "rules/rule_reader.h"
#include "rules/rule_table.h"

int main() {
  stig::Diagnostics diagnostics;
  const auto rules = stig::read_rule_set_file(RULESETS "/staircase.yaml", diagnostics);
  if (!rules) {
    std::cerr << stig::to_text(diagnostics);
    return 1;
  }
  stig::SwarmConfig config;
  config.motion = stig::Motion::event;
  const auto result = stig::run_swarm(stig::RuleTable(*rules), rules->start, config);
  std::cout << stig::print_structure(result.structure, rules->bricks);
  const bool expected = rules->expect && rules->expect->bricks &&
                        result.structure.size() == static_cast<std::size_t>(*rules->expect->bricks);
  return expected ? 0 : 1;
}
