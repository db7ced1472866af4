// SPDX-License-Identifier: MIT
// What is claimed to hold in every structure that a stage can reach, and what it leaves
// possible around a site. certify/certificate.h says the same in words.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "verify/stage_model.h"
#include "verify/uses.h"

namespace stig::verify {

/// Bricks whose fillings are listed one by one.
struct Window {
  std::vector<std::uint32_t> group, context;  ///< numbers of bricks
  std::size_t words = 0;                      ///< of a filling
  std::vector<std::uint64_t> fillings;        ///< one after another, `words` each
  /// How a filling is reached: the filling before it and the brick added. The first is
  /// the empty one.
  std::vector<std::uint32_t> from, added;

  std::size_t size() const { return group.size() + context.size(); }
  std::size_t count() const { return words == 0 ? 0 : fillings.size() / words; }
  std::uint32_t brick(std::size_t i) const {
    return i < group.size() ? group[i] : context[i - group.size()];
  }
  bool has(std::size_t filling, std::size_t i) const {
    return (fillings[filling * words + i / 64] >> (i % 64) & 1U) != 0;
  }
  std::uint64_t bricks_in(std::size_t filling) const {
    std::uint64_t number = 0;
    for (std::size_t w = 0; w < words; ++w) {
      number += static_cast<std::uint64_t>(std::popcount(fillings[filling * words + w]));
    }
    return number;
  }
};

struct Invariant {
  static constexpr std::uint32_t kNoWindow = ~std::uint32_t{0};

  std::vector<Mask> before;             ///< by brick: neighbours always there first
  std::vector<std::uint32_t> group_of;  ///< by brick: the window in whose group it is
  std::vector<Window> windows;
  /// Chains of `before` from a brick back to one a few cells away, by the first brick. Of
  /// use where the two are around one site and the chain is not.
  std::map<std::uint32_t, std::vector<std::vector<std::uint32_t>>> far;
  /// The stage is over after so many deposits, and the only window's group is all of them;
  /// 0: it ends when no rule acts.
  std::uint64_t over_at = 0;
};

/// The order of the bricks around a site, as far as chains of `before` between the site
/// and its neighbours, and far ones, show it.
struct LocalOrder {
  std::array<Mask, kMaxNeighbours> below{};  ///< by neighbour: those always there before it
  Mask after = 0;                            ///< never there while the site is empty

  /// The smallest state around the site that holds these.
  Mask closed(Mask some) const;
};
LocalOrder local_order(const StageModel& model, const Invariant& invariant, const StageSite& site);

/// Calls visit(state) for every local state within `among` that the order allows, until it
/// returns false or `most` were visited. `among` is a set of neighbours that matter, of
/// those that the site's order does not put after it. True: all were visited.
bool for_each_local_state(const StageModel& model, const StageSite& site, const LocalOrder& order,
                          Mask among, std::uint64_t most, const std::function<bool(Mask)>& visit);

}  // namespace stig::verify
