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
#include "search/judges.h"
#include "search/screen.h"
#include "search/search_plan.h"
#include "search/uses.h"

namespace stig::search {

/// Candidate `id` as it is made, with its parents and its genome and nothing else. `plan` is
/// plan_hash.
Individual make_candidate(const SearchPlan& settings, std::uint64_t plan,
                          const FindArchive& archive, std::uint64_t id, Screener& screener);
/// Runs, measures and scores it: a function of the plan, its number and its genome.
void measure_candidate(const SearchPlan& settings, std::uint64_t plan, const Judges& judges,
                       Screener& screener, Individual& one);
/// Both: one evaluation.
Individual evaluate(const SearchPlan& settings, std::uint64_t plan, const FindArchive& archive,
                    std::uint64_t id, Screener& screener, const Judges& judges = {});

/// Batches are whole: the number of evaluations in a slice's batches, the last rounded up.
std::uint64_t evaluations_of(const SearchPlan& plan, const BatchSlice& slice = {});

struct SearchState {
  explicit SearchState(const SearchPlan& plan, const BatchSlice& share = {})
      : slice(share), archive(plan) {}
  BatchSlice slice;
  std::uint64_t evaluated = 0;  ///< of the slice
  FindArchive archive;
};

/// What a batch added.
struct SearchBatch {
  std::uint64_t evaluated = 0;                   ///< after it, of the slice
  std::uint64_t until = 0;                       ///< its evaluations end before this number
  std::size_t first_kept = 0;                    ///< its individuals stand in kept() from here on
  std::map<std::uint64_t, std::uint64_t> built;  ///< structure -> times, in this batch
  double best = 0, mean = 0, deviation = 0;      ///< of its scores
};

using Stop = const std::atomic<bool>*;

/// The next `count` candidates, as they are made; fewer, of no use, when `stop` was set meanwhile.
std::vector<Individual> make_batch(const SearchPlan& plan, const SearchState& state,
                                   std::size_t count, int threads, Stop stop = nullptr);
/// Measures them in place; false when `stop` was set meanwhile.
bool measure_batch(const SearchPlan& plan, std::vector<Individual>& made, const Judges& judges,
                   int threads, Stop stop = nullptr);
/// Adds them to the state, all measured, in the order in which they were made.
SearchBatch take_batch(SearchState& state, std::vector<Individual> made);

/// All three. Nothing, and the state as it was, when `stop` was set meanwhile, or when a candidate
/// could not be scored.
std::optional<SearchBatch> run_batch(const SearchPlan& plan, SearchState& state, int threads,
                                     Stop stop = nullptr, const Judges& judges = {});
/// The first that could not be scored; null: all could.
const Individual* first_unscored(const std::vector<Individual>& measured);

}  // namespace stig::search
