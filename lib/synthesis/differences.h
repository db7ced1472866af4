// SPDX-License-Identifier: MIT
// What the clashes met so far say about colours, as clauses over pairs of orbits: "one
// of these pairs differs, or that pair is equal". They do not mention the number of
// colours, so they serve for every number, and so does what follows from them: pairs
// that must differ, and a set of orbits that all differ from each other, which bounds
// the number of colours from below.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "synthesis/clashes.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// Why a clause holds, and what it says of pairs (indices into Differences::pairs).
struct DifferenceClause {
  Clash reason;
  std::vector<std::int32_t> differ;
  std::int32_t equal = -1;  ///< condition B: the pair of the two sites
};

class Differences {
 public:
  explicit Differences(const Schedule& schedule) : schedule_(&schedule) {}

  /// Adds what the clash demands; false when it is known or always met. A clash that no
  /// colours prevent makes an empty clause (see hopeless()).
  bool add(const Clash& clash);
  /// Adds the demands of all keys and states of one brick, as far as `most` clauses go:
  /// those of straight runs, from which most pairs that must differ follow. Fewer when the
  /// time of the allowance is over.
  void add_single_bricks(std::size_t most, const Allowance& allowance = {});

  const Schedule& schedule() const { return *schedule_; }
  const std::vector<DifferenceClause>& clauses() const { return clauses_; }
  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  /// The clash that no colouring avoids, if one was added.
  const std::optional<Clash>& hopeless() const { return hopeless_; }

  /// Orbits that must all differ from each other, by unit propagation and a greedy search.
  std::vector<int> clique() const;

 private:
  std::int32_t pair(int a, int b);
  /// For each pair: must it differ?
  std::vector<bool> forced_differences() const;

  const Schedule* schedule_;
  std::vector<DifferenceClause> clauses_;
  std::vector<std::pair<int, int>> pairs_;
  std::unordered_map<std::uint64_t, std::int32_t> pair_index_;
  std::unordered_map<std::uint64_t, std::int32_t> known_;  ///< hashes of clauses
  std::optional<Clash> hopeless_;
};

}  // namespace stig::synthesis
