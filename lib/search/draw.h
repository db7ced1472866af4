// SPDX-License-Identifier: MIT
// Random genomes whose rules can fire.
//
// A rule set drawn cell by cell builds nothing: its patterns ask for bricks that nobody places
// where they are asked for. So rules are drawn from a growth that is imagined while they are
// drawn. Beside a brick that stands already a free site is chosen, what is seen from there becomes
// the pattern of the next rule, loosened in places, and the brick that the rule places joins
// the growth. The growth is a witness: each rule matches the site of its brick when the bricks
// before it stand. (Whether it gets to fire depends on the order of events, and on rules before
// it in the list that match there as well.)
//
// Other than in Theraulaz & Bonabeau 1995 (J. theor. Biol. 177:381–400), where patterns are drawn
// and most never match, no template is wasted.
#pragma once

#include <vector>

#include "base/random.h"
#include "search/genome.h"
#include "search/uses.h"

namespace stig::search {

/// The purpose of streams that genomes are drawn from: that of users' programs, which a search has
/// none of.
inline constexpr Purpose kDrawing = Purpose::user;

struct DrawSettings {
  Lattice lattice = Lattice::cubic;
  bool floor = false;
  int colours = 2;                   ///< 1..kMostGenomeColours
  int rules = 20;                    ///< 1..kMostGenomeRules
  double wildcards = 0.1;            ///< chance that a neighbour's state does not matter
  double heights = 0;                ///< chance that a rule has a bound of its height
  std::optional<Symmetry> symmetry;  ///< otherwise one of the three, each as likely
};

struct DrawnGenome {
  Genome genome;
  /// The growth that the rules were drawn from: the start, then a brick for each rule.
  std::vector<PlacedBrick> imagined;
};

/// Draws anew; `out` keeps its memory.
void draw_genome(const DrawSettings& settings, Random& random, DrawnGenome& out);

/// A rule that matches at a free site beside `bricks`, as they stand: where one of them, chosen at
/// random, has a free side. Nothing when no such site was hit upon.
struct DrawnRule {
  GeneRule rule;
  Cell site;
};
std::optional<DrawnRule> draw_rule(const DrawSettings& settings,
                                   const std::vector<PlacedBrick>& bricks, Random& random);

/// The rule that places a colour where a site looks as this one does now: all neighbours count.
/// Nothing when the site is filled, below the floor, or beside no brick.
std::optional<GeneRule> rule_for(const DrawSettings& settings,
                                 const std::vector<PlacedBrick>& bricks, const PlacedBrick& wanted);

}  // namespace stig::search
