// SPDX-License-Identifier: MIT
// The baseline that the walk engine is measured against: the same model the plain
// way. Each step of each agent gathers the 26 states around it from a packed
// lattice (one byte a cell), hashes them, looks the hash up in a flat table, and
// moves. Exact cubic rules only; agents' order is fixed; the generator is cheaper
// than ours (xorshift64*), so ratios against it are not flattered by random numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/box.h"
#include "rules/rule_set.h"

namespace stig::bench {

class BaselineWalk {
 public:
  BaselineWalk(const RuleSet& rules, const Box& box, int agents, std::uint64_t seed);
  /// Every agent acts once.
  void step();
  std::uint64_t deposits() const { return deposits_; }

 private:
  struct Slot {
    std::uint64_t hash = 0;
    Colour colour = 0;
  };
  std::uint64_t random() {
    word_ ^= word_ >> 12;
    word_ ^= word_ << 25;
    word_ ^= word_ >> 27;
    return word_ * 0x2545F4914F6CDD1DULL;
  }
  std::uint64_t hash_around(std::size_t cell) const;

  std::vector<std::uint8_t> cells_;  ///< padded by one: state, 0x40 agent, 0x80 side
  std::vector<std::size_t> agents_;
  std::vector<std::ptrdiff_t> steps_;
  std::vector<Slot> table_;
  std::uint64_t word_;
  std::uint64_t deposits_ = 0;
};

}  // namespace stig::bench
