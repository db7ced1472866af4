// SPDX-License-Identifier: MIT
// A search, batch by batch.
//
// Candidates of a batch are made from what was found before the batch began, each from random
// numbers of its own: an evaluation is a function of the plan, of its number and of that archive,
// whatever else runs at the same time and however often the search was broken off. Numbers of
// threads change nothing but the time.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <vector>

#include "search/find_archive.h"
#include "search/screen.h"
#include "search/search_plan.h"
#include "search/uses.h"

namespace stig::search {

/// One evaluation: makes candidate `id`, runs and measures it. `plan` is plan_hash.
Individual evaluate(const SearchPlan& settings, std::uint64_t plan, const FindArchive& archive,
                    std::uint64_t id, Screener& screener);

/// Batches are whole: the number of evaluations, rounded up.
std::uint64_t evaluations_of(const SearchPlan& plan);

struct SearchState {
  explicit SearchState(const SearchPlan& plan) : archive(plan) {}
  std::uint64_t evaluated = 0;
  FindArchive archive;
};

/// What a batch added.
struct SearchBatch {
  std::uint64_t evaluated = 0;                   ///< after it, of the whole search
  std::size_t first_kept = 0;                    ///< its individuals stand in kept() from here on
  std::map<std::uint64_t, std::uint64_t> built;  ///< structure -> times, in this batch
  double best = 0, mean = 0, deviation = 0;      ///< of its scores
};

/// Runs the next batch. Nothing, and the state as it was, when `stop` was set meanwhile.
std::optional<SearchBatch> run_batch(const SearchPlan& plan, SearchState& state, int threads,
                                     const std::atomic<bool>* stop = nullptr);

}  // namespace stig::search
