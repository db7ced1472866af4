// SPDX-License-Identifier: MIT
// Offspring of genomes, made so that what was alive mostly stays so.
//
// Both operators look at a run of the parent. A rule that never fired can be changed at no cost,
// and what takes its place is drawn from what the parent built, beside a brick that is there. Two
// parents are crossed by stages: the rules that fired early in one, then those that fired late in
// the other, so that neither half is torn out of its own order of work.
#pragma once

#include "search/draw.h"
#include "search/genome.h"
#include "search/screen.h"
#include "search/uses.h"

namespace stig::search {

/// A parent with one of its runs.
struct Parent {
  const Genome& genome;
  const Screening& run;
};

/// One to four changes of rules, or of the symmetry; mostly of rules that never fired. The settings
/// say what may be drawn. The number of rules stays.
Genome mutate(const DrawSettings& settings, const Parent& parent, Random& random);

/// `early` gives start, symmetry and the rules that fired first among its own, `late` those that
/// fired last; as many of each as chance says, and as many in all as `early` has. Both have the
/// same lattice, floor and colours (asserted).
Genome cross_over(const Parent& early, const Parent& late, Random& random);

/// Repair by the missing pattern. Two runs of the parent end differently: at a site where the
/// longer one has a brick and the other has come to a halt, the pattern that is seen there becomes
/// a rule, in place of one that never fired. It is what stigc verify proposes for a refuted set
/// (verify/repair.h), found by two runs instead of a proof, so that a search can afford it. Nothing
/// where the second run has no brick beside what the parent's run built, or every rule fired.
std::optional<Genome> mend(const DrawSettings& settings, const Parent& parent,
                           const std::vector<PlacedBrick>& other_end, Random& random);

}  // namespace stig::search
