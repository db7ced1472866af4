// SPDX-License-Identifier: MIT
// The baseline that the walk engine is measured against: the same model the plain
// way. Each step of each agent gathers the 26 states around it from a packed lattice
// (two bits a cell, so three cells of a row come with one load), hashes the 54 bits,
// looks the hash up in a flat table, and moves. Exact cubic rules of up to three
// colours; agents keep their order; the generator is cheaper than the engine's
// (xorshift64*), so ratios against it are not flattered by random numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/box.h"
#include "rules/rule_set.h"
#include "support/uses.h"

namespace stig::bench {

class BaselineWalk {
 public:
  BaselineWalk(const RuleSet& rules, const Box& box, int agents, std::uint64_t seed);
  /// Every agent acts once.
  void step();
  std::uint64_t deposits() const { return deposits_; }

 private:
  struct Slot {
    std::uint64_t key = 0;
    Colour colour = 0;  ///< 0: free
  };
  std::uint64_t random() {
    word_ ^= word_ >> 12;
    word_ ^= word_ << 25;
    word_ ^= word_ >> 27;
    return word_ * 0x2545F4914F6CDD1DULL;
  }
  std::uint64_t key_around(std::int64_t cell) const;
  void pack(std::int64_t cell, Colour colour);
  std::size_t slot(std::uint64_t key) const {
    return key * 0x9E3779B97F4A7C15ULL >> 32 & (table_.size() - 1);
  }

  std::int64_t row_ = 0, slice_ = 0;
  std::vector<std::uint8_t> packed_;  ///< two bits a cell of the padded box
  std::vector<std::uint8_t> taken_;   ///< a byte a cell: brick, side or agent
  std::vector<std::int64_t> agents_;
  std::vector<std::int64_t> steps_;
  std::vector<Slot> table_;
  std::uint64_t word_;
  std::uint64_t deposits_ = 0;
};

}  // namespace stig::bench
