// SPDX-License-Identifier: MIT
// The linear check: do these colours make the order a rule set that builds the target
// and nothing else? No solver takes part in it.
//
// A key, in any orientation, looks like a local state (same cells, same colours, same
// floor). If that state is not one in which its site is to be placed, a rule would
// place a brick too early, too late or outside the target: condition A. If it is, but
// the two sites have different colours, rules would contradict: condition B. Without
// a clash every order of events ends in the target: a set of placed cells stays closed
// under the order, and as long as a cell is missing, a lowest one is enabled.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "synthesis/effort.h"
#include "synthesis/local_states.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// Key `key`, turned by `orientation`, looks like local state `mask` of `site`.
struct Clash {
  std::int32_t key = 0;
  std::int32_t orientation = 0;
  std::int32_t site = 0;
  std::uint32_t mask = 0;
  bool intended = false;  ///< condition B, otherwise A
};

/// Colours by orbit.
using Colouring = std::vector<Colour>;

/// Clashes under a colouring: none when there are none, otherwise some for every state that
/// has one: at most `most_of_state` a state and, but for the last state, `most` in all. Ends
/// early, with those met until then, when the time of the allowance is over. Those that `counts`
/// refuses are passed over as if there were none; it is asked once about each clash met.
std::vector<Clash> find_clashes(const Schedule& schedule, const Colouring& colours,
                                std::size_t most_of_state, std::size_t most,
                                const Allowance& allowance = {},
                                const std::function<bool(const Clash&)>& counts = {});

/// Pairs of orbits of which one must differ in colour so that the key does not look like
/// the state; empty when they look alike whatever the colours are. Sorted, each once.
std::vector<std::pair<int, int>> compared_orbits(const Schedule& schedule, const Clash& clash);

/// A key's mask as an orientation shows it.
std::uint32_t turned(std::uint32_t mask, const Orientation& orientation);

}  // namespace stig::synthesis
