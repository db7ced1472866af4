// SPDX-License-Identifier: MIT
// From a drawing to a rule set that builds it, and nothing else, in every order of events:
// stig::synthesis. The rule set is printed as a file that `stigc check` and the others take.
#include <iostream>

#include "lattice/structure_text.h"
#include "rules/rule_printer.h"
#include "synthesis/emit.h"
#include "synthesis/synthesise.h"

int main() {
  // An arch, slices from the top down. Its bricks are all of one kind, and free to get any colour.
  const stig::lattice::Structure arch = stig::lattice::structure_literal(R"(
1 1 1
---
1 . 1
)");
  const stig::synthesis::Target target = stig::synthesis::target_of(
      {arch, {stig::rules::Brick{}}, /*placed=*/false}, stig::synthesis::ColourUse::free);

  // The search is deterministic: how long it may go on is counted in work.
  stig::synthesis::SynthesisOptions options;
  options.floor = true;
  const stig::synthesis::Synthesis result = stig::synthesis::synthesise(target, options);
  if (!result.best) {
    std::cerr << (result.obstacle ? result.obstacle->what : "not found with this effort") << '\n';
    return 1;
  }
  const stig::synthesis::Solution& best = *result.best;
  std::cout << stig::rules::print_rule_set(stig::synthesis::make_rule_set(
      *best.frame, best.colours, best.colour_count, target.bricks, best.rules,
      {"arch", "An arch of five bricks", "examples/synthesise.cpp"}));
}
