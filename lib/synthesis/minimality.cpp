// SPDX-License-Identifier: MIT
#include <cassert>

#include "synthesis/proof_files.h"
#include "synthesis/synthesise.h"

namespace stig {

std::optional<MinimalityProof> prove_fewest(const Solution& solution, int named,
                                            const Deadline& deadline) {
  const int k = solution.colour_count - 1;
  if (k < 1) return std::nullopt;
  BadOrder bad;
  const std::optional<Schedule> schedule = make_schedule(*solution.frame, solution.order, bad);
  assert(schedule);
  ColouringSearch search(*schedule, named);
  Colouring colours;
  if (search.colour(k, {deadline, {}}, colours) != Answered::no) return std::nullopt;
  std::optional<Refutation> refutation = refute(search, named, k, deadline);
  if (!refutation) return std::nullopt;
  return MinimalityProof{print_problem(*schedule, named, k), std::move(refutation->cnf),
                         std::move(refutation->drat)};
}

}  // namespace stig
