// SPDX-License-Identifier: MIT
// From a drawing to rules that a given robot can follow: stig::assembly. It differs from
// stig::synthesis in what it takes into account: how far the robot reaches, what its cameras see
// on the way, and what it can tell apart.
//
//     assemble [FILE]     which the rules are written to
#include <fstream>
#include <iostream>

#include "assembly/assemble.h"
#include "compiler/block_figures.h"
#include "lattice/structure_text.h"
#include "robots/robot_reader.h"

int main(int argc, char** argv) {
  stig::Diagnostics diagnostics;
  const auto robot = stig::robots::read_robot_file(STIG_DATA "/robots/bebot.yaml", diagnostics);
  const auto block =
      stig::robots::read_block_file(STIG_DATA "/blocks/stigmergic.yaml", diagnostics);
  std::cerr << stig::to_text(diagnostics);
  if (!robot || !block) return 1;

  // Steps of two and one, slices from the top down; the colours are chosen so that the robot can
  // tell what to do where.
  const stig::lattice::Structure steps = stig::lattice::structure_literal(R"(
1 .
---
1 1
)");
  stig::assembly::AssemblyTask task;
  task.target = stig::synthesis::target_of({steps, {stig::rules::Brick{}}, /*placed=*/false},
                                           stig::synthesis::ColourUse::free);
  task.robot = stig::compiler::abilities_of(*robot, stig::compiler::figures_of(*block));
  task.wording = {"steps", "Steps of two and one", "examples/assemble.cpp"};

  const stig::assembly::Assembly result = stig::assembly::assemble(task, /*effort=*/1);
  if (!result.plan) {
    std::cerr << "no rules were found that this robot can follow\n";
    return 1;
  }
  std::cout << "rules for " << task.wording.title << ", proved for " << robot->name << ": "
            << result.plan->work.size() << " bricks to place, " << result.plan->rules->rules.size()
            << " rules\n";
  if (argc > 1) std::ofstream(argv[1]) << result.plan->text;
}
