// SPDX-License-Identifier: MIT
// Which rules act at a site: the checker's own matcher.
//
// Around a site, most is fixed while a stage lasts: bricks that were there before, cells
// that stay empty, floor. The others are *open*: each shows a brick of one known colour
// once that is placed, and is empty before. So what an oriented rule asks for comes down
// to two sets of open neighbours: those that must be there and those that must not. A
// rule that the fixed ones contradict is left out for good.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "certify/uses.h"
#include "rules/rule_set.h"

namespace stig::certify {

/// A set of neighbours: bit i stands for the neighbour with index i.
using NeighbourSet = std::uint32_t;

/// What a site can come to see while it is empty.
struct Outlook {
  std::int32_t z = 0;
  std::array<State, kMaxNeighbours> shows{};  ///< once it is there, if open
  NeighbourSet open = 0;
  bool beside_brick = false;  ///< one that was there before the stage

  bool event_possible(NeighbourSet there) const { return beside_brick || there != 0; }
};

/// An oriented rule that matches for some filling of the open neighbours.
struct RuleCandidate {
  std::uint32_t rule = 0;
  NeighbourSet there = 0, not_there = 0;  ///< open ones that it asks for
};

/// What can happen at a site.
struct Action {
  bool acts = false;  ///< some rule does
  std::uint32_t rule = 0;
  bool other = false;  ///< `rule` does, and places another colour than expected
};

class ActingRules {
 public:
  /// The rule set must outlive it.
  explicit ActingRules(const RuleSet& rules);
  /// By rising rule. `out` is cleared.
  void candidates(const Outlook& site, int stage, std::vector<RuleCandidate>& out) const;
  /// The open neighbours that make a difference to some candidate.
  NeighbourSet asked_about(const Outlook& site, const std::vector<RuleCandidate>& candidates) const;
  /// Do the counts of a rule hold when these are there, and whatever comes besides?
  bool counts_stay(const Outlook& site, const RuleCandidate& candidate, NeighbourSet there) const;
  /// What rules do at the site when of its open neighbours just these are there. Beside
  /// no brick at all there is no event, whatever a rule says.
  Action act(const Outlook& site, const std::vector<RuleCandidate>& candidates, NeighbourSet there,
             Colour expected) const;

 private:
  struct Oriented {
    std::uint32_t rule;
    Pattern pattern;
  };
  bool counts_hold(const Rule& rule, const Outlook& site, NeighbourSet there) const;
  std::uint64_t accepting(std::size_t word, const Outlook& site) const;

  const RuleSet& rules_;
  const Neighbourhood& neighbours_;
  std::vector<Oriented> oriented_;
  /// [neighbour][state][word]: the oriented rules that accept it, as bits.
  std::vector<std::uint64_t> accept_;
  std::size_t words_ = 0;
};

}  // namespace stig::certify
