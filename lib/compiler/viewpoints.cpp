// SPDX-License-Identifier: MIT
// Chooses few viewpoints by elimination: starting from all, each is dropped if every column
// that can arise still leads to the same decision. Dear ones (near the column, with the
// lift far from its middle) are dropped first. The result is irreducible and not
// necessarily the smallest; a set-cover search would gain a second or two of a robot's
// time.
#include "compiler/viewpoints.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <set>

namespace stig::compiler {

namespace {

/// What a column shows from each viewpoint, and what is to be done before it.
struct LookedAt {
  std::optional<ApproachSide> side;  ///< where it counts
  std::vector<Observation> from;
  std::optional<Placement> wanted;
};

/// What is seen from several viewpoints together: kUnseen is the least value, so the
/// maximum is what is known.
Observation together(const LookedAt& column, const std::vector<bool>& used) {
  const std::vector<Observation>& from = column.from;
  Observation out;
  out.side = column.side;
  out.cells.assign(from.front().cells.size(), kUnseen);
  for (std::size_t s = 0; s < from.size(); ++s) {
    if (!used[s]) continue;
    for (std::size_t i = 0; i < out.cells.size(); ++i) {
      out.cells[i] = std::max(out.cells[i], from[s].cells[i]);
    }
  }
  return out;
}

/// Columns that look the same from every viewpoint are one case.
std::vector<LookedAt> columns_that_arise(Sight& sight, const CompiledRules& compiled) {
  std::vector<LookedAt> out;
  std::set<std::pair<std::optional<ApproachSide>, std::vector<std::vector<std::uint8_t>>>> known;
  for (const Situation& situation : compiled.policy.situations) {
    if (!compiled.policy.reached[situation.state]) continue;
    const auto& from = sight.look_from_each(compiled.policy.states[situation.state], situation.side,
                                            situation.u, situation.v);
    const Observation& all = compiled.policy.observations[situation.observation];
    std::vector<std::vector<std::uint8_t>> key;
    key.reserve(from.size());
    for (const Observation& one : from) key.push_back(one.cells);
    if (!known.emplace(all.side, std::move(key)).second) continue;
    out.push_back({all.side, from, decide(*compiled.decision, all)});
  }
  return out;
}

}  // namespace

std::vector<Viewpoint> choose_viewpoints(const Abilities& robot, const CompiledRules& compiled) {
  assert(compiled.decision != nullptr);
  Sight sight(*compiled.target, robot);
  const std::vector<LookedAt> columns = columns_that_arise(sight, compiled);
  const std::vector<Viewpoint>& viewpoints = sight.viewpoints();
  // Near ones go first, then those with the lift far up or down: they take the longest to get to.
  std::vector<std::size_t> order(viewpoints.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto off = [&](std::size_t i) {
      return std::abs(viewpoints[i].lift - robot.lift_travel / 2);
    };
    return std::pair(viewpoints[a].distance, -off(a)) < std::pair(viewpoints[b].distance, -off(b));
  });
  std::vector<bool> used(viewpoints.size(), true);
  std::size_t left = viewpoints.size();
  for (const std::size_t one : order) {
    if (left == 1) break;
    used[one] = false;
    const bool enough = std::all_of(columns.begin(), columns.end(), [&](const LookedAt& column) {
      return decide(*compiled.decision, together(column, used)) == column.wanted;
    });
    if (enough) {
      --left;
    } else {
      used[one] = true;
    }
  }
  std::vector<Viewpoint> out;
  for (std::size_t i = 0; i < viewpoints.size(); ++i) {
    if (used[i]) out.push_back(viewpoints[i]);
  }
  std::sort(out.begin(), out.end(), [](const Viewpoint& a, const Viewpoint& b) {
    return std::pair(-a.distance, a.lift) < std::pair(-b.distance, b.lift);
  });
  return out;
}

}  // namespace stig::compiler
