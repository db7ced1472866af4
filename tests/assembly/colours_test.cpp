// SPDX-License-Identifier: MIT
#include "assembly/colours.h"
#include "support/uses.h"

#include <doctest/doctest.h>

namespace stig {
namespace {

constexpr int kWidth = 5, kTall = 200, kLow = 100;

/// A row, every brick of another colour, with a tall column on its one end and a low one on the
/// other, both of one more colour.
Target two_columns() {
  Target out;
  for (std::int32_t x = 0; x < kWidth; ++x) {
    const int height = x == 0 ? kTall : x == kWidth - 1 ? kLow : 1;
    for (std::int32_t z = 0; z < height; ++z) {
      out.cells.push_back({x, 0, z});
      out.colours.push_back(StateSet::of(static_cast<State>(z > 0 ? kWidth + 1 : x + 1)));
    }
  }
  for (int i = 1; i <= kWidth + 1; ++i) out.bricks.push_back({std::to_string(i), "", "", "", {}});
  return out;
}

/// The row first, then the columns level by level.
CandidateOrder row_then_columns(const Target& target) {
  std::vector<PlacedBrick> bricks;
  for (std::int32_t z = 0; z < kTall; ++z) {
    for (const Cell cell : target.cells) {
      if (cell.z == z) bricks.push_back({cell, 1});
    }
  }
  CandidateOrder out;
  out.target = std::make_unique<TargetBricks>(bricks, 1);
  out.before.assign(bricks.size(), BrickSet(bricks.size()));
  out.free = out.before;
  const Neighbourhood& n = neighbourhood(Lattice::cubic);
  for (std::uint32_t i = 0; i < bricks.size(); ++i) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(n.size); ++k) {
      const std::uint32_t other = out.target->brick_at(bricks[i].at + n.offsets[k]);
      if (other < i) out.before[i].add(other);
    }
  }
  return out;
}

TEST_CASE("clashes between levels do not hide one within a level") {
  const Target target = two_columns();
  const CandidateOrder candidate = row_then_columns(target);
  RuleView view;
  look_at_rules(target, candidate, view);
  REQUIRE(view.schedule);
  // On top of the low column it looks as on the tall one at the same level, where heights tell
  // nothing apart; it also looks as at a hundred other levels.
  const PaintResult painted =
      paint(target, {}, view, kWidth + 1, no_texture(target.cells.size()), {});
  CHECK(painted.answer == Answered::no);
}

TEST_CASE("a column alone has clashes between levels only") {
  Target target = two_columns();
  std::erase_if(target.cells, [](const Cell& cell) { return cell.x > 0; });
  target.colours.resize(target.cells.size());
  const CandidateOrder candidate = row_then_columns(target);
  RuleView view;
  look_at_rules(target, candidate, view);
  REQUIRE(view.schedule);
  const PaintResult painted =
      paint(target, {}, view, kWidth + 1, no_texture(target.cells.size()), {});
  CHECK(painted.answer == Answered::yes);
}

}  // namespace
}  // namespace stig
