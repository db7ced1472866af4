// SPDX-License-Identifier: MIT
// Where a proof fails since two bricks around a site seem unordered, they may be ordered
// through bricks that the site does not see. Such chains are found by a breadth-first
// search backwards along `before`, which yields the shortest, and are written into the
// certificate, since the checker does not search (docs/proofs.md, "far"). The limits bound
// the effort; a chain that is not found costs completeness and never soundness.
#include "verify/far_order.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>

namespace stig::verify {
namespace {

/// Failures come by rising site; the first ones usually lie in one region and their chains
/// settle the others too.
constexpr std::size_t kMostLookedAt = 50;  ///< looked at
constexpr std::size_t kFarthest = 5000;    ///< bricks visited from one

std::uint32_t neighbour(const StageModel& model, std::uint32_t brick, int index) {
  const Neighbourhood& n = model.table().neighbours();
  return model.number(model.at(brick) + n.offsets[static_cast<std::size_t>(index)]);
}

/// Bricks reached from one by steps of `before`, each with the brick it was reached from.
std::map<std::uint32_t, std::uint32_t> all_before(const StageModel& model,
                                                  const Invariant& invariant, std::uint32_t brick) {
  std::map<std::uint32_t, std::uint32_t> from{{brick, brick}};
  std::vector<std::uint32_t> todo{brick};
  for (std::size_t k = 0; k < todo.size() && todo.size() < kFarthest; ++k) {
    for (Mask left = invariant.before[todo[k]]; left != 0; left &= left - 1) {
      const std::uint32_t earlier = neighbour(model, todo[k], std::countr_zero(left));
      if (from.try_emplace(earlier, todo[k]).second) todo.push_back(earlier);
    }
  }
  return from;
}

std::vector<std::uint32_t> chain_to(const std::map<std::uint32_t, std::uint32_t>& from,
                                    std::uint32_t brick) {
  assert(from.contains(brick));
  std::vector<std::uint32_t> chain{brick};
  while (from.at(chain.back()) != chain.back()) chain.push_back(from.at(chain.back()));
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

/// Only pairs of bricks around one failed site are connected: other chains would be true
/// and of no use.
bool add_far_chains(const StageModel& model, const std::vector<LocalFailure>& failures,
                    Invariant& invariant) {
  bool added = false;
  StageSite site;
  for (std::size_t k = 0; k < std::min(kMostLookedAt, failures.size()); ++k) {
    model.look(failures[k].site, site);
    const LocalOrder order = local_order(model, invariant, site);
    for (Mask left = site.bricks; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const auto from = all_before(model, invariant, site.brick[i]);
      for (Mask rest = site.bricks & ~order.below[i] & ~bit(static_cast<int>(i)); rest != 0;
           rest &= rest - 1) {
        const std::uint32_t other = site.brick[static_cast<std::size_t>(std::countr_zero(rest))];
        if (!from.contains(other)) continue;
        auto& chains = invariant.far[site.brick[i]];
        std::vector<std::uint32_t> chain = chain_to(from, other);
        if (std::find(chains.begin(), chains.end(), chain) != chains.end()) continue;
        chains.push_back(std::move(chain));
        added = true;
      }
    }
  }
  return added;
}

/// A chain is as good as its steps. After Houdini has weakened `before`, chains over
/// dropped steps would make the checker refuse the certificate.
bool drop_broken_chains(const StageModel& model, Invariant& invariant) {
  const Neighbourhood& n = model.table().neighbours();
  const auto is_step = [&](std::uint32_t later, std::uint32_t earlier) {
    for (int i = 0; i < n.size; ++i) {
      if ((invariant.before[later] & bit(i)) != 0 && neighbour(model, later, i) == earlier) {
        return true;
      }
    }
    return false;
  };
  bool dropped = false;
  for (auto& [brick, chains] : invariant.far) {
    dropped |= std::erase_if(chains, [&](const std::vector<std::uint32_t>& chain) {
                 for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
                   if (!is_step(chain[k], chain[k + 1])) return true;
                 }
                 return false;
               }) > 0;
  }
  return dropped;
}

}  // namespace stig::verify
