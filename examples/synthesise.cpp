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
  const stig::Structure arch = stig::structure_literal(R"(
1 1 1
---
1 . 1
)");
  const stig::Target target =
      stig::target_of({arch, {stig::Brick{}}, /*placed=*/false}, stig::ColourUse::free);

  // The search is deterministic: how long it may go on is counted in work.
  stig::SynthesisOptions options;
  options.floor = true;
  const stig::Synthesis result = stig::synthesise(target, options);
  if (!result.best) {
    std::cerr << (result.obstacle ? result.obstacle->what : "not found with this effort") << '\n';
    return 1;
  }
  const stig::Solution& best = *result.best;
  std::cout << stig::print_rule_set(
      stig::make_rule_set(*best.frame, best.colours, best.colour_count, target.bricks, best.rules,
                          {"arch", "An arch of five bricks", "examples/synthesise.cpp"}));
}
