// SPDX-License-Identifier: MIT
// Which entries of a rule table could ever match a site, when the state of each of its
// neighbours is known up to a set? RuleTable answers for one view; proofs ask for all the
// views of a site at once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rules/rule_table.h"
#include "rules/site_condition.h"
#include "verify/uses.h"

namespace stig::verify {

/// For each neighbour index the states it may have.
using PossibleStates = std::array<StateSet, kMaxNeighbours>;

class EntryIndex {
 public:
  /// Indexes the rules that act in a stage (1-based).
  EntryIndex(const RuleSet& rules, const RuleTable& table, int stage);

  /// Entries (positions in RuleTable::entries) that accept one of the possible states of
  /// each neighbour and the height z, by rising rule. `out` is cleared.
  void possible(const PossibleStates& states, std::int32_t z,
                std::vector<std::uint32_t>& out) const;

 private:
  int stage_;
  std::size_t size_;                    ///< of the neighbourhood
  std::size_t words_;                   ///< of a set of entries
  std::vector<std::uint32_t> entries_;  ///< those of the stage
  std::vector<SiteCondition> where_;    ///< beside entries_
  std::array<std::uint8_t, 64> row_{};  ///< of a state
  std::size_t rows_ = 0;
  std::uint64_t known_ = 0;            ///< states that have a row
  std::vector<std::uint64_t> accept_;  ///< [neighbour][row] -> set of entries
};

}  // namespace stig::verify
