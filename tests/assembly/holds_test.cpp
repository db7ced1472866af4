// SPDX-License-Identifier: MIT
// Parts of structures against taking bricks away one by one.
#include "assembly/holds.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "support/uses.h"

namespace stig {
namespace {

/// Bricks that steps through faces lead to, but not through `without`.
std::set<std::uint32_t> met_from(const TargetBricks& target, std::uint32_t start,
                                 std::uint32_t without) {
  std::set<std::uint32_t> out = {start};
  std::vector<std::uint32_t> edge = {start};
  while (!edge.empty()) {
    const Cell cell = target.cell(edge.back());
    edge.pop_back();
    for (const Offset step :
         {Offset{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
      const std::uint32_t next = target.brick_at(cell + step);
      if (next == TargetBricks::kNone || next == without) continue;
      if (out.insert(next).second) edge.push_back(next);
    }
  }
  return out;
}

TEST_CASE("parts beyond a brick are what no steps lead to without it") {
  CHECK(rc::check([] {
    std::set<Cell> cells;
    const auto below = [](int most) {
      return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, most));
    };
    for (int i = 2 + below(30); i > 0; --i) cells.insert({below(6), below(5), below(2)});
    std::vector<PlacedBrick> bricks;
    for (const Cell cell : cells) bricks.push_back({cell, 1});
    const TargetBricks target(bricks, 0);
    const auto root = static_cast<std::uint32_t>(below(static_cast<int>(target.bricks())));
    const Parts parts = parts_from(target, root);
    const std::set<std::uint32_t> all = met_from(target, root, TargetBricks::kNone);
    RC_ASSERT(std::set<std::uint32_t>(parts.order.begin(), parts.order.end()) == all);
    RC_ASSERT(parts.order.size() == all.size() && parts.order.front() == root);
    std::size_t some = 0;
    for (const std::uint32_t brick : all) {
      std::set<std::uint32_t> rest = all;
      rest.erase(brick);
      for (const auto& [first, last] : parts.beyond[brick]) {
        const std::set<std::uint32_t> part(parts.order.begin() + first, parts.order.begin() + last);
        RC_ASSERT(part == met_from(target, parts.order[first], brick));
        for (const std::uint32_t one : part) RC_ASSERT(rest.erase(one) == 1U);
        ++some;
      }
      // All others still hang together with the root.
      RC_ASSERT(rest ==
                (brick == root ? std::set<std::uint32_t>{} : met_from(target, root, brick)));
    }
    RC_TAG(some < 2 ? "few parts" : "many parts");
  }));
}

}  // namespace
}  // namespace stig
