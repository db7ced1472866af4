// SPDX-License-Identifier: MIT
// The local states that an invariant leaves possible around a site: the sets of
// neighbouring bricks that are closed under "always there before". Their number decides
// what a proof costs. They are enumerated depth first without being stored, in the order of
// the run, in which every brick's predecessors have been decided before it. The definitions
// are those of Λ in docs/proofs.md; the checker has its own implementation.
#include "verify/invariant.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace stig::verify {
namespace {

constexpr Mask kSelfBit = bit(StageModel::kSelf);

int lowest(Mask mask) { return std::countr_zero(mask); }

/// The neighbours in `mask`, and the site itself if it is a brick, by rising number of
/// their bricks, which is an order in which they can be placed.
struct Sorted {
  std::array<std::int8_t, kMaxNeighbours + 1> index{};
  std::size_t size = 0;
};

/// Numbers count the run's deposits, and `before` only ever points to smaller ones, so
/// rising numbers are a topological order.
Sorted by_number(const StageModel& model, const StageSite& site, Mask mask) {
  std::array<std::uint64_t, kMaxNeighbours + 1> keys{};  // number, then index
  Sorted sorted;
  const auto add = [&](std::uint32_t number, int index) {
    keys[sorted.size++] = std::uint64_t{number} << 8 | static_cast<std::uint64_t>(index);
  };
  for (; mask != 0; mask &= mask - 1) {
    add(site.brick[static_cast<std::size_t>(lowest(mask))], lowest(mask));
  }
  if (site.number < model.bricks()) add(site.number, StageModel::kSelf);
  std::sort(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(sorted.size));
  for (std::size_t k = 0; k < sorted.size; ++k) {
    sorted.index[k] = static_cast<std::int8_t>(keys[k] & 0xff);
  }
  return sorted;
}

/// Where around the site the bricks stand that far chains from a brick lead to. A far chain
/// is recorded at its first brick; it matters here only if it ends at the site itself or at
/// one of its neighbours.
std::vector<int> far_from(const Invariant& invariant, const StageSite& site, std::uint32_t brick) {
  std::vector<int> indices;
  const auto found = invariant.far.find(brick);
  if (found == invariant.far.end()) return indices;
  for (const std::vector<std::uint32_t>& chain : found->second) {
    if (chain.back() == site.number) indices.push_back(StageModel::kSelf);
    for (Mask left = site.bricks; left != 0; left &= left - 1) {
      const int i = lowest(left);
      if (site.brick[static_cast<std::size_t>(i)] == chain.back()) indices.push_back(i);
    }
  }
  return indices;
}

}  // namespace

Mask LocalOrder::closed(Mask some) const {
  Mask all = some;
  for (; some != 0; some &= some - 1) all |= below[static_cast<std::size_t>(lowest(some))];
  return all;
}

/// Transitive closure by one pass: predecessors have smaller numbers and are complete
/// already.
LocalOrder local_order(const StageModel& model, const Invariant& invariant, const StageSite& site) {
  assert(invariant.before.size() == model.bricks());
  LocalOrder order;
  Mask below_self = 0;
  const Sorted sorted = by_number(model, site, site.bricks);
  for (std::size_t k = 0; k < sorted.size; ++k) {
    const int i = sorted.index[k];
    if (i == StageModel::kSelf) {
      Mask direct = invariant.before[site.number] & site.bricks;
      for (const int there : far_from(invariant, site, site.number)) direct |= bit(there);
      below_self = order.closed(direct);
      continue;
    }
    Mask below = 0;
    const std::uint32_t brick = site.brick[static_cast<std::size_t>(i)];
    // A step from a neighbour leads to the site itself, to another neighbour, or out of
    // sight. In the last case the chain is lost, unless a far chain names it.
    for (Mask left = invariant.before[brick]; left != 0; left &= left - 1) {
      const int there = model.two_steps(i, lowest(left));
      if (there == StageModel::kSelf) {
        below |= kSelfBit | below_self;
      } else if (there >= 0 && (site.bricks & bit(there)) != 0) {
        below |= bit(there) | order.below[static_cast<std::size_t>(there)];
      }
    }
    for (const int there : far_from(invariant, site, brick)) {
      below |= there == StageModel::kSelf
                   ? kSelfBit | below_self
                   : bit(there) | order.below[static_cast<std::size_t>(there)];
    }
    // The site's own brick is no member of a state, which is one of an empty site; what
    // comes after it can never be there.
    order.below[static_cast<std::size_t>(i)] = below & ~kSelfBit;
    if ((below & kSelfBit) != 0 || (below & order.after) != 0) order.after |= bit(i);
  }
  return order;
}

bool for_each_local_state(const StageModel& model, const StageSite& site, const LocalOrder& order,
                          Mask among, std::uint64_t most, const std::function<bool(Mask)>& visit) {
  const Sorted sorted = by_number(model, site, among);
  // Depth first over "leave out, take in", in an order in which what is below comes first.
  // An explicit stack, since the depth is up to 26 and the branching factor 2.
  struct Step {
    std::size_t next;
    Mask state;
  };
  std::vector<Step> stack{{0, 0}};
  std::uint64_t visited = 0;
  while (!stack.empty()) {
    Step step = stack.back();
    stack.pop_back();
    while (step.next < sorted.size) {
      const int i = sorted.index[step.next++];
      if (i == StageModel::kSelf) continue;
      const Mask needed = order.below[static_cast<std::size_t>(i)] & among;
      if ((step.state & needed) == needed) {
        stack.push_back({step.next, step.state | bit(i)});
      }
    }
    if (++visited > most) return false;
    if (!visit(step.state)) return false;
  }
  return true;
}

}  // namespace stig::verify
