// SPDX-License-Identifier: MIT
// What a search is to look for, where and how.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "search/draw.h"
#include "search/screen.h"
#include "search/uses.h"

namespace stig::search {

enum class SearchMethod : std::uint8_t { random, local, genetic, map_elites };
std::string_view to_string(SearchMethod method);  ///< "map-elites"

/// A part of the score: weight times objective.
struct ScoreTerm {
  std::size_t objective = 0;  ///< number in objectives()
  double weight = 1;
};

/// An axis of MAP-Elites' grid; values beyond its ends count to its last cells.
struct GridAxis {
  std::size_t objective = 0;
  double from = 0, to = 1;  ///< from < to
  int bins = 10;            ///< 1..1000
};

struct SearchPlan {
  std::string name;
  DrawSettings draw;
  ScreenConfig screen;
  int orders = 0;            ///< further random orders that each candidate is run in
  int faults = 0;            ///< times that a brick is lost on the way, and that one is too many
  std::uint64_t proof = 0;   ///< steps of the verifier for a candidate (verify/budget.h); 0: none
  std::vector<Cell> target;  ///< of the objective distance, sorted; empty: none
  std::uint64_t seed = 1;
  SearchMethod method = SearchMethod::random;
  std::uint64_t evaluations = 10'000;
  int batch = 256;      ///< candidates that are made from what was found before all of them
  int population = 64;  ///< of the genetic algorithm
  std::vector<ScoreTerm> score;
  std::string score_program;   ///< a file of Lua in place of these; empty: none
  std::string robot;           ///< the file of a robot that is to build finds; empty: none
  std::uint64_t outside = 0;   ///< of the contents of these files, by whoever reads them; 0: none
  std::vector<GridAxis> axes;  ///< two or three under map_elites
};

/// Every `of`-th batch of a search from the `number`-th on, both from 1: a share for one of so many
/// processes that know nothing of each other. Only for SearchMethod::random, whose candidates come
/// from nothing that was found before.
struct BatchSlice {
  std::uint64_t number = 1, of = 1;
};

/// Of all that decides what an evaluation finds: not of the name, nor of the number of evaluations,
/// so that a search can be made longer.
std::uint64_t plan_hash(const SearchPlan& plan);

}  // namespace stig::search
