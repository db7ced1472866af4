// SPDX-License-Identifier: MIT
// What a search has found: for each structure (shape_hash) the individuals that built it better
// than any before them, and how often it was built at all.
//
// The archive is a function of the individuals that were offered to it, in their order. All
// that methods choose from (the best, the population, the grid of MAP-Elites) is derived from it,
// so that a search that is broken off goes on from its individuals alone.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "search/search_plan.h"
#include "search/uses.h"

namespace stig::search {

struct Individual {
  std::uint64_t id = 0;                               ///< number of its evaluation, from 0
  std::string_view origin;                            ///< "drawn", "mutated", "mended", "crossed"
  std::optional<std::uint64_t> parent, other_parent;  ///< ids
  Genome genome;
  std::vector<PlacedBrick> bricks;  ///< what it built, in the order of cells
  std::uint64_t structure = 0;      ///< shape_hash of the bricks
  std::vector<double> values;       ///< of objectives(), by their numbers
  double score = 0;
  std::string problem;  ///< why there is no score; empty: there is
};

class FindArchive {
 public:
  explicit FindArchive(const SearchPlan& plan) : axes_(plan.axes) {}

  /// Counts the structure; keeps the individual when it is the first of it, or has a higher score
  /// than all others of it. Says whether it did. Ids rise from one to the next (asserted).
  bool offer(Individual individual);
  /// For one that was kept and whose structure was built `times` more often than it shows.
  void count(std::uint64_t structure, std::uint64_t times) { times_[structure] += times; }

  /// All that were kept, by rising id.
  const std::vector<Individual>& kept() const { return kept_; }
  /// Position in kept() of the best of each structure, by falling score and then rising id; so many
  /// at most.
  std::vector<std::size_t> best(std::size_t most) const;
  /// Positions in kept() of the best in each cell of the grid that has one, by cell.
  std::vector<std::size_t> elites() const;
  std::size_t structures() const { return times_.size(); }
  const std::map<std::uint64_t, std::uint64_t>& times() const { return times_; }
  /// Of every id, score, structure and count.
  std::uint64_t content_hash() const;

 private:
  std::uint64_t cell_of(const Individual& individual) const;
  bool better(std::size_t a, std::size_t b) const;

  std::vector<GridAxis> axes_;
  std::vector<Individual> kept_;
  std::map<std::uint64_t, std::size_t> champion_;  ///< of a structure; position in kept_
  std::map<std::uint64_t, std::size_t> elite_;     ///< of a cell
  std::map<std::uint64_t, std::uint64_t> times_;   ///< structure -> how often it was built
};

}  // namespace stig::search
