// SPDX-License-Identifier: MIT
// Proves that one colour fewer does not do for a solution's order. The search is run again
// for k - 1 colours, since a solution does not keep the clauses that were met on the way to it,
// and the clauses of this search become the formula. The files are checked by lib/certify/fewest.h,
// which shares no code with this.
#include "synthesis/proof_files.h"
#include "synthesis/synthesise.h"

namespace stig::synthesis {

std::optional<MinimalityProof> prove_fewest(const Solution& solution, int named,
                                            const Allowance& allowance) {
  const int k = solution.colour_count - 1;
  if (k < 1) return std::nullopt;
  BadOrder bad;
  const std::optional<Schedule> schedule =
      make_schedule(*solution.frame, solution.order, bad, {.allowance = allowance});
  if (!schedule) return std::nullopt;  // the time is over
  ColouringSearch search(*schedule, named, allowance);
  allowance.spend(search.cost());
  Colouring colours;
  if (search.colour(k, {allowance, {}}, colours) != Answered::no) return std::nullopt;
  std::optional<Refutation> refutation = refute(search, named, k, allowance);
  if (!refutation) return std::nullopt;
  return MinimalityProof{print_problem(*schedule, named, k), std::move(refutation->cnf),
                         std::move(refutation->drat)};
}

}  // namespace stig::synthesis
