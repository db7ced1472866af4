// SPDX-License-Identifier: MIT
// The two indices of a rule table: a hash table for entries without wildcards, bit sets for the
// rest.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "rules/rule_table.h"
#include "rules/standing_view.h"

namespace stig::rules {

/// Entries are numbered as in RuleTable::entries().
struct TableIndex {
  struct Exact {
    View view;
    std::uint64_t hash;
    std::uint32_t entry;
  };
  std::vector<Exact> exact;            ///< by hash, then entry
  std::vector<std::uint32_t> slots;    ///< open addressing by hash: 1 + first in `exact`; 0 free
  std::vector<std::uint32_t> loose;    ///< entries with wildcards, rising
  std::size_t words = 0;               ///< of a bit set over `loose`
  std::vector<std::uint64_t> accept;   ///< [neighbour][row of state][word]
  std::array<std::uint8_t, 64> row{};  ///< state -> row; states no rule names share row 0
  std::size_t rows = 1;                ///< the floor has the last
  std::vector<std::uint8_t> order;     ///< neighbours, the most selective first
  // For standing views, whose codes are rows.
  std::vector<std::uint64_t>
      asking;                        ///< as `accept`: those that a change from empty can make match
  std::vector<std::uint8_t> asked;   ///< [neighbour][row]: is there any in `asking`?
  bool counts = false;               ///< do some entries count?
  std::vector<std::uint32_t> needs;  ///< by loose entry: neighbours that must not be empty

  void add(const Entry& entry, std::uint32_t number, int size);
  /// `counting`: does this entry's rule have counts?
  void finish(const std::vector<Entry>& entries, const std::vector<bool>& counting, int size,
              int colours);
  /// 1 + the first exact entry with this hash, or 0.
  std::uint32_t find(std::uint64_t hash) const {
    for (std::size_t slot = hash & (slots.size() - 1); slots[slot] != 0;
         slot = (slot + 1) & (slots.size() - 1)) {
      if (exact[slots[slot] - 1].hash == hash) return slots[slot];
    }
    return 0;
  }
  /// Of the bit sets over `loose`: all of a word.
  std::uint64_t all(std::size_t word) const {
    const std::size_t rest = loose.size() - word * 64;
    return rest >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << rest) - 1;
  }
  std::uint64_t accepting(std::size_t neighbour, std::size_t row_of_state, std::size_t word) const {
    return accept[(neighbour * rows + row_of_state) * words + word];
  }
  View gathered(const StandingView& view) const;

 private:
  void hash_exact();
  void lay_out_loose(const std::vector<Entry>& entries, std::size_t size);
  void find_asking(const std::vector<bool>& counting, std::size_t size);
  bool accepts_anything(std::size_t neighbour) const;
};

}  // namespace stig::rules
