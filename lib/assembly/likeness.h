// SPDX-License-Identifier: MIT
// Cases that look alike under some colours, though they may want different things.
#pragma once

#include <functional>

#include "assembly/cases.h"
#include "assembly/uses.h"
#include "rules/rule_set.h"

namespace stig::assembly {

/// Two cases that nothing but colours tells apart, as far as a question that `a` answers is asked.
struct Likeness {
  std::uint32_t a = 0, b = 0;
  /// Some question that `a` answers has no answer in `b`: they are told apart if nothing is to be
  /// done in `b`.
  bool unless_idle = false;
};

/// Cases by what is seen of the cells, whatever the colours.
class Likenesses {
 public:
  explicit Likenesses(const std::vector<Case>& cases);

  /// Visits pairs that no colours tell apart now, though what is done in `a` is not among the
  /// choices of `b`, in its colours; `done`: by case and choice. Until `visit` says no more;
  /// returns how much was looked at.
  std::uint64_t for_each(const std::vector<Colour>& colours,
                         const std::vector<std::vector<bool>>& done,
                         const std::function<bool(const Likeness&)>& visit) const;

 private:
  /// All that look alike but for colours.
  struct Shape {
    ApproachSide side{};
    CellBits empty, filled;
    std::vector<std::uint32_t> cases;
  };
  const std::vector<Case>& cases_;
  std::vector<Shape> shapes_;
};

/// Cells in which both cases see bricks, different ones: as pairs of bricks.
std::vector<std::pair<std::uint32_t, std::uint32_t>> compared_bricks(const Case& a, const Case& b);

}  // namespace stig::assembly
