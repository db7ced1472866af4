// SPDX-License-Identifier: MIT
// What can stand around a column when a robot comes to it, column by column: a proof by these needs
// no list of structures.
//
// Whatever stands is closed under a precedence (precedence.h). So what is seen of a column, with
// nothing before it, leaves the rest between two structures: the smallest has what must stand below
// what is seen, the largest lacks what cannot stand above what is missing. Both are closed and look
// the same from there; what holds in all between them holds whenever a robot sees this.
//
// Their number grows with the bricks times the ways in which a few bricks around a column can come,
// not with the number of structures.
#pragma once

#include <functional>
#include <utility>

#include "compiler/columns.h"
#include "compiler/precedence.h"
#include "compiler/sight.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// Is there an order of the bricks after the start in which each can be the next, given all before
/// it, which are all that have to come before? The more stand, the fewer structures there are to
/// go on in, so that whatever brick can be the next may be. Asks no more of a brick once it can,
/// and after it could not only when something has been added in sight of it (kFarthestSeen): that
/// is all that the answer may depend on.
bool can_go_on(const TargetBricks& target, const Precedence& precedence,
               const std::function<bool(std::uint32_t brick, const BrickSet& before)>& can_be_next);

/// A column that is the foremost of its row, with lanes free as for columns_before.
struct LocalSituation {
  ApproachSide side{};
  int u = 0, v = 0;
  BrickSet least{0}, most{0};
};

class LocalSituations {
 public:
  /// All arguments must outlive it.
  LocalSituations(const TargetBricks& target, const Precedence& precedence, const Sight& sight);

  /// Columns of the whole structure, as the side sees them.
  std::vector<std::pair<int, int>> columns(ApproachSide side) const;
  /// Bricks that have to be missing when the column is the foremost.
  std::vector<std::uint32_t> in_front(ApproachSide side, int u, int v) const;

  /// Does a robot come to the column in every structure that has all of `before`, and lacks a brick
  /// that `before` lacks?
  bool always_comes(ApproachSide side, int u, int v, std::uint32_t brick,
                    const BrickSet& before) const;

  using Visit = std::function<void(const LocalSituation&)>;
  /// Each situation before the column in structures that have all of `given`, which is closed, and
  /// nothing of `missing`, which has all above what it has. `most` is how many there may be, and
  /// what is visited is taken off; false when there are more.
  bool for_each(ApproachSide side, int u, int v, const BrickSet& given, const BrickSet& missing,
                std::size_t& most, const Visit& visit) const;

 private:
  struct Search;
  bool extend(Search& search, std::size_t next) const;
  bool stands(const BrickSet& state, ApproachSide side, int u, int v) const;

  const TargetBricks& target_;
  const Precedence& precedence_;
  const std::vector<WindowCell> around_;  ///< cells that a look can depend on
  std::vector<std::uint32_t> place_;      ///< of a brick in the precedence's order
};

}  // namespace stig::compiler
