// SPDX-License-Identifier: MIT
// The slow, obvious oracle that tests hold the fast code to. It reads a RuleSet
// straight: no table, no index, every orientation of every rule tried one by one,
// every order of events followed. It shares with the code under test the geometry
// (neighbourhood.h) and the groups (symmetry.h), which have tests of their own.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "lattice/box.h"
#include "rules/rule_set.h"
#include "rules/rule_table.h"
#include "support/uses.h"

namespace stig {

/// A structure as the oracle holds it.
using BrickMap = std::map<Cell, Colour>;

BrickMap start_of(const RuleSet& rules);

/// Matching by trying everything. The rule set must outlive it.
class OracleMatcher {
 public:
  explicit OracleMatcher(const RuleSet& rules);
  /// All rules of a stage that match, by rising index, each with the first of its
  /// orientations that does: what RuleTable::matches must say.
  std::vector<Match> matches(const View& view, std::int32_t z, int stage) const;

 private:
  const RuleSet& rules_;
  std::vector<std::vector<Orientation>> groups_;  ///< of each rule
};

/// A world of 64×64×64 cells about the origin, one byte each. Bricks stay off its rim.
class OracleWorld {
 public:
  OracleWorld(const RuleSet& rules, std::optional<Box> box);

  void place(const PlacedBrick& brick);
  void remove(const PlacedBrick& brick);
  View view(Cell site) const;
  /// Every event of a stage: an empty site beside a brick, in the box, and a colour
  /// that a rule places there. Rules that fire beside nothing are not the oracle's.
  std::vector<PlacedBrick> events(int stage);
  BrickMap structure() const { return bricks_; }

 private:
  struct Seen {
    View view;
    std::int32_t z;
    int stage;
    bool operator==(const Seen&) const = default;
  };
  struct SeenHash {
    std::size_t operator()(const Seen& seen) const;
  };
  const std::vector<Colour>& colours_placed(Cell site, int stage);
  std::vector<Cell> sites_beside_bricks();

  const RuleSet& rules_;
  OracleMatcher matcher_;
  std::optional<Box> box_;
  bool heights_matter_;
  BrickMap bricks_;
  std::vector<State> cells_;           ///< x fastest, then y, then z
  std::vector<std::ptrdiff_t> steps_;  ///< to each neighbour, in cells_
  std::vector<std::uint32_t> round_;   ///< round in which a cell was last listed
  std::uint32_t rounds_ = 0;
  /// Answers already worked out, by what they depend on: a memo, not an index.
  std::unordered_map<Seen, std::vector<Colour>, SeenHash> memo_;
};

struct ExplorationLimits {
  std::size_t states = 1'000'000;
  std::size_t deposits = 100;  ///< of one order
};

/// Every structure that some order of a stage's events reaches.
struct Exploration {
  bool complete = true;        ///< false: a limit was met
  std::size_t states = 0;      ///< structures reached, the start included
  std::vector<BrickMap> ends;  ///< those without an event, each once
};
Exploration explore_orders(const RuleSet& rules, const BrickMap& start, int stage = 1,
                           std::optional<Box> box = std::nullopt, ExplorationLimits limits = {});

/// One order of a stage's events, drawn by lot; stops after `most` deposits.
BrickMap build_in_some_order(const RuleSet& rules, const BrickMap& start, int stage,
                             std::uint64_t seed, std::optional<Box> box = std::nullopt,
                             std::size_t most = 1000);

}  // namespace stig
