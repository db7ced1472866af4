// SPDX-License-Identifier: MIT
// Every order of events, tried exhaustively: which structures can a rule set end
// in, whatever its agents do?
//
// Events only add bricks, so states (sets of placed bricks) form layers by size
// and two orders meet only within a layer. The search goes layer by layer, stage
// by stage, and keeps two layers. States are merged when they are equal brick for
// brick (a hash only finds the candidate), so a complete search is a proof. A rule
// with a probability may or may not fire; a stage ends in a state when that has no
// event left or holds the stage's number of deposits.
//
//   start  1 .        one rule "beside a 1 place a 2", no symmetry: 2 states, 1 end
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "lattice/box.h"
#include "lattice/structure.h"
#include "lattice/uses.h"
#include "rules/rule_table.h"

namespace stig::lattice {

/// Where the search gives up. Words are of 4 bytes: a state takes one a deposit
/// and one an enabled event.
struct EventOrdersLimits {
  std::uint64_t states = 2'000'000;
  std::uint64_t words_held = 60'000'000;      ///< at any time: bounds memory (240 MB)
  std::uint64_t words_written = 800'000'000;  ///< in all: bounds time (seconds)
  std::uint64_t ends = 1000;                  ///< distinct final structures looked for
};

/// Called during a search, all optional.
struct EventOrdersHooks {
  std::function<void(std::uint64_t states)> progress;  ///< now and then: states so far
  const std::atomic<bool>* stop = nullptr;             ///< set: give up soon
};

struct EventOrders {
  bool complete = false;     ///< every order was covered: no limit, no interruption
  std::uint64_t states = 0;  ///< distinct states visited, over all stages
  std::vector<std::uint64_t> states_by_stage;  ///< the first state of a stage included
  /// Distinct final structures, start included, by size and then cells. Places are
  /// absolute: a shifted structure is another one.
  std::vector<Structure> ends;
};

/// Searches from `start`, within `box` or, without one, in unbounded space.
EventOrders explore_event_orders(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                                 const std::optional<Box>& box,
                                 const EventOrdersLimits& limits = {},
                                 const EventOrdersHooks& hooks = {});

}  // namespace stig::lattice
