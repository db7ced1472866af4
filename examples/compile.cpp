// SPDX-License-Identifier: MIT
// From rules to the decisions of a robot that builds by them, with a proof that every order of its
// work completes the structure: stig::compiler.
//
//     compile [RULESET]
#include <iostream>

#include "compiler/block_figures.h"
#include "compiler/compile.h"
#include "compiler/decision_text.h"
#include "robots/robot_reader.h"
#include "rules/rule_reader.h"

int main(int argc, char** argv) {
  stig::Diagnostics diagnostics;
  const auto rules = stig::rules::read_rule_set_file(
      argc > 1 ? argv[1] : STIG_DATA "/rulesets/staircase.yaml", diagnostics);
  const auto robot = stig::robots::read_robot_file(STIG_DATA "/robots/bebot.yaml", diagnostics);
  const auto block =
      stig::robots::read_block_file(STIG_DATA "/blocks/stigmergic.yaml", diagnostics);
  if (!rules || !robot || !block) {
    std::cerr << stig::to_text(diagnostics);
    return 1;
  }

  // Not every robot can build: it needs a lift, electromagnets, cameras that see blocks.
  for (const std::string& sentence : stig::compiler::lacking(*robot)) {
    std::cerr << sentence << '\n';
    return 1;
  }
  const stig::compiler::Abilities abilities =
      stig::compiler::abilities_of(*robot, stig::compiler::figures_of(*block));

  // Rules beyond this robot's reach or sight are refused, with the reason as a diagnostic.
  const stig::compiler::CompiledRules compiled =
      stig::compiler::compile_rules(*rules, abilities, {}, diagnostics);
  std::cerr << stig::to_text(diagnostics);
  if (!compiled.decision) return 1;
  std::cout << stig::compiler::completion_text(compiled) << '\n'
            << stig::compiler::decision_text(*rules, *compiled.decision);
}
