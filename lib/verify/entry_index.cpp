// SPDX-License-Identifier: MIT
// The transposed table of a stage's patterns: for each neighbour and state, a bit set of
// the entries that accept it. RuleTable answers for one known view; here each neighbour is
// known only up to a set, and the AND over neighbours of an OR over states gives in a few
// words what would otherwise be a loop over all patterns. The checker has a similar table
// of its own (certify/acting_rules.cpp), which must not be shared.
#include "verify/entry_index.h"

#include <bit>
#include <cassert>

namespace stig::verify {

EntryIndex::EntryIndex(const RuleSet& rules, const RuleTable& table, int stage)
    : stage_(stage), size_(static_cast<std::size_t>(table.neighbours().size)) {
  assert(stage >= 1);
  for (std::uint32_t e = 0; e < table.entries().size(); ++e) {
    const SiteCondition where = site_condition(rules.rules[table.entries()[e].source.rule]);
    if (!where.stage.contains(stage)) continue;
    entries_.push_back(e);
    where_.push_back(where);
  }
  words_ = (entries_.size() + 63) / 64;
  // Rows are numbered without gaps. Patterns use all 64 bits for "anything", but only the
  // empty cell, the colours of this set and the floor can occur.
  known_ = 1U | StateSet::bricks(rules.colours()).bits() | StateSet::floor().bits();
  for (std::uint64_t left = known_; left != 0; left &= left - 1) {
    row_[static_cast<std::size_t>(std::countr_zero(left))] = static_cast<std::uint8_t>(rows_++);
  }
  accept_.assign(size_ * rows_ * words_, 0);
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const Pattern& pattern = table.entries()[entries_[k]].pattern;
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::uint64_t left = pattern.allowed[i].bits() & known_; left != 0; left &= left - 1) {
        const std::size_t row = row_[static_cast<std::size_t>(std::countr_zero(left))];
        accept_[(i * rows_ + row) * words_ + k / 64] |= std::uint64_t{1} << (k % 64);
      }
    }
  }
}

void EntryIndex::possible(const PossibleStates& states, std::int32_t z,
                          std::vector<std::uint32_t>& out) const {
  out.clear();
  for (std::size_t w = 0; w < words_; ++w) {
    // Bits beyond the last entry must not survive: they would index past `entries_`.
    const std::size_t last = entries_.size() - w * 64;
    std::uint64_t alive = last >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << last) - 1;
    for (std::size_t i = 0; i < size_ && alive != 0; ++i) {
      std::uint64_t accepted = 0;
      for (std::uint64_t left = states[i].bits() & known_; left != 0; left &= left - 1) {
        const std::size_t row = row_[static_cast<std::size_t>(std::countr_zero(left))];
        accepted |= accept_[(i * rows_ + row) * words_ + w];
      }
      alive &= accepted;
    }
    for (; alive != 0; alive &= alive - 1) {
      const std::size_t k = w * 64 + static_cast<std::size_t>(std::countr_zero(alive));
      // Heights are tested one by one: few rules have any, and a table over z would be
      // unbounded.
      if (allows(where_[k], {z, stage_})) out.push_back(entries_[k]);
    }
  }
}

}  // namespace stig::verify
