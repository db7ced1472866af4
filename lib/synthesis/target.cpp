// SPDX-License-Identifier: MIT
// Takes cells and colours from a structure file. Colours that no brick has are dropped and
// the rest are numbered anew, since rule sets have no bricks without use. The bricks "?"
// and "#" stand for any colour, as in drawings of rules.
#include "synthesis/target.h"

#include <cassert>

namespace stig::synthesis {
namespace {

bool is_wildcard(const Brick& brick) { return brick.symbol == "?" || brick.symbol == "#"; }

}  // namespace

Target target_of(const LoadedStructure& structure, ColourUse use) {
  Target target;
  target.lattice = structure.structure.lattice();
  std::vector<StateSet> meaning(structure.bricks.size() + 1, StateSet::anything());
  const std::vector<PlacedBrick> bricks = structure.structure.bricks();
  if (use == ColourUse::given) {
    std::vector<bool> used(meaning.size(), false);
    for (const PlacedBrick& brick : bricks) used[brick.brick] = true;
    for (std::size_t k = 1; k < meaning.size(); ++k) {
      if (!used[k] || is_wildcard(structure.bricks[k - 1])) continue;
      target.bricks.push_back(structure.bricks[k - 1]);
      meaning[k] = StateSet::of(static_cast<State>(target.bricks.size()));
    }
  }
  for (const PlacedBrick& brick : bricks) {
    assert(brick.brick < meaning.size());
    target.cells.push_back(brick.at);
    target.colours.push_back(meaning[brick.brick]);
  }
  return target;
}

}  // namespace stig::synthesis
