// SPDX-License-Identifier: MIT
// Enumerates what can stand around one column: for each brick in sight, in the order of the
// precedence, it stands (with all below it) or it is missing (with all above it). Two sets,
// what is there and what is missing, describe all closed structures that look so. Their
// number is bounded by the cells in sight and not by the size of the structure.
#include "compiler/local_situations.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <set>

namespace stig::compiler {

struct LocalSituations::Search {
  LocalSituation situation;           ///< `most` holds what is missing until it is shown
  std::vector<std::uint32_t> bricks;  ///< to be decided on, each after those below it
  std::size_t& left;
  const Visit& visit;
};

namespace {

/// Wakes the bricks before whose columns another can be seen: those columns are next to them.
void wake_about(const TargetBricks& target, Cell at, std::vector<bool>& awake) {
  constexpr int kFar = kFarthestSeen + 1;
  for (std::int32_t x = at.x - kFar; x <= at.x + kFar; ++x) {
    for (const std::uint32_t brick : target.with_x(x)) {
      if (std::abs(target.cell(brick).y - at.y) <= kFar) awake[brick] = true;
    }
  }
}

}  // namespace

/// Greedy, and complete: what can be next with fewer bricks can be next with more, so no
/// choice is wrong.
bool can_go_on(
    const TargetBricks& target, const Precedence& precedence,
    const std::function<bool(std::uint32_t brick, const BrickSet& before)>& can_be_next) {
  BrickSet before = target.start();
  std::vector<bool> awake(target.bricks(), true);
  std::vector<std::uint32_t> missing;
  for (auto q = static_cast<std::uint32_t>(target.start_bricks()); q < target.bricks(); ++q) {
    missing.push_back(q);
  }
  while (!missing.empty()) {
    const auto next = std::find_if(missing.begin(), missing.end(), [&](std::uint32_t q) {
      if (!awake[q] || !precedence.all_before(before, q)) return false;
      awake[q] = false;
      return can_be_next(q, before);
    });
    if (next == missing.end()) return false;
    before.add(*next);
    wake_about(target, target.cell(*next), awake);
    missing.erase(next);
  }
  return true;
}

LocalSituations::LocalSituations(const TargetBricks& target, const Precedence& precedence,
                                 const Sight& sight)
    : target_(target),
      precedence_(precedence),
      around_(sight.cells_that_matter()),
      place_(target.bricks()) {
  const std::vector<std::uint32_t> order = precedence.order();
  for (std::uint32_t i = 0; i < place_.size(); ++i) place_[order[i]] = i;
}

std::vector<std::pair<int, int>> LocalSituations::columns(ApproachSide side) const {
  std::set<std::pair<int, int>> out;
  for (std::size_t i = 0; i < target_.bricks(); ++i) {
    const SideCell at = seen_from(side, target_.cell(i));
    out.emplace(at.u, at.v);
  }
  return {out.begin(), out.end()};
}

/// For the column to be the foremost, its own row must be free before it and the next rows
/// from one cell further on.
std::vector<std::uint32_t> LocalSituations::in_front(ApproachSide side, int u, int v) const {
  std::vector<std::uint32_t> out;
  for (const int row : {v - 1, v, v + 1}) {
    for (const std::uint32_t i : row_from(target_, side, row)) {
      const int first = row == v ? u + 1 : u + 2;
      if (seen_from(side, target_.cell(i)).u >= first) out.push_back(i);
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

bool LocalSituations::stands(const BrickSet& state, ApproachSide side, int u, int v) const {
  for (int z = 0; z < target_.levels(); ++z) {
    if (target_.filled(state, cell_from(side, {u, v, z + target_.floor_level()}))) return true;
  }
  return false;
}

/// All bricks in front come after the missing one, so they are missing too.
bool LocalSituations::always_comes(ApproachSide side, int u, int v, std::uint32_t brick,
                                   const BrickSet& before) const {
  assert(brick < target_.bricks());
  if (!stands(before, side, u, v)) return false;
  const std::vector<std::uint32_t> front = in_front(side, u, v);
  return std::all_of(front.begin(), front.end(),
                     [&](std::uint32_t one) { return precedence_.above(brick).has(one); });
}

bool LocalSituations::for_each(ApproachSide side, int u, int v, const BrickSet& given,
                               const BrickSet& missing, std::size_t& most,
                               const Visit& visit) const {
  assert(!given.meets(missing));
  Search search{{side, u, v, given, missing}, {}, most, visit};
  search.situation.least.add(target_.start());
  BrickSet& out = search.situation.most;
  // What must be missing takes everything above it along.
  for (const std::uint32_t brick : in_front(side, u, v)) out.add(precedence_.above(brick));
  if (out.meets(search.situation.least)) return true;
  for (const WindowCell& cell : around_) {
    const std::uint32_t brick = target_.brick_at(
        cell_from(side, {u + cell.du, v + cell.dv, cell.z + target_.floor_level()}));
    if (brick != TargetBricks::kNone) search.bricks.push_back(brick);
  }
  std::sort(search.bricks.begin(), search.bricks.end(),
            [&](std::uint32_t a, std::uint32_t b) { return place_[a] < place_[b]; });
  return extend(search, 0);
}

/// Depth-first; sets are copied on the way down and restored on the way up, a few words
/// each.
bool LocalSituations::extend(Search& search, std::size_t next) const {
  LocalSituation& now = search.situation;
  while (next < search.bricks.size() &&
         (now.least.has(search.bricks[next]) || now.most.has(search.bricks[next]))) {
    ++next;
  }
  if (next < search.bricks.size()) {
    // What is there is closed, and so is what is missing, so either goes.
    const std::uint32_t brick = search.bricks[next];
    const BrickSet least = now.least;
    now.least.add(precedence_.below(brick));
    if (!extend(search, next + 1)) return false;
    now.least = least;
    const BrickSet missing = now.most;
    now.most.add(precedence_.above(brick));
    if (!extend(search, next + 1)) return false;
    now.most = missing;
    return true;
  }
  if (!stands(now.least, now.side, now.u, now.v)) return true;
  if (search.left == 0) return false;
  --search.left;
  const BrickSet missing = now.most;
  // From here on the visitor sees the greatest structure in place of what is missing.
  now.most = target_.others(missing);
  search.visit(now);
  now.most = missing;
  return true;
}

}  // namespace stig::compiler
