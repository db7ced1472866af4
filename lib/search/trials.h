// SPDX-License-Identifier: MIT
// Further runs of a candidate: in other random orders, with a brick lost on the way, with one too
// many. What ends alike in all of them is worth the verifier's time, which cannot be spent on every
// candidate.
#pragma once

#include <cstdint>
#include <vector>

#include "search/screen.h"
#include "search/uses.h"

namespace stig::search {

struct TrialCounts {
  int orders = 0;  ///< further random orders
  int faults = 0;  ///< losses, and as many additions
};

/// Shares, 0..1; 0 where nothing was tried.
struct Trials {
  double same_ends = 0;     ///< further orders that end in the same bricks
  double lost_bricks = 0;   ///< runs that end so although a brick was taken away on the way
  double extra_bricks = 0;  ///< runs that end so but for a brick that was added on the way
};

/// The random seed of further order `k`, from 1, of a candidate whose first run had `seed`.
std::uint64_t order_seed(std::uint64_t seed, int k);

/// `run` is the candidate's first run, with `seed`, and `bricks` what it built; where it did not
/// end by itself nothing counts as alike.
Trials try_again(const TrialCounts& counts, const Genome& genome, const Screening& run,
                 const std::vector<PlacedBrick>& bricks, std::uint64_t seed, Screener& screener);

}  // namespace stig::search
