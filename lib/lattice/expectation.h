// SPDX-License-Identifier: MIT
// Verifies a rule set against its own `expect`, and says by which method.
//
// First many event orders are sampled, each with its own stream of random numbers;
// two different ends settle much. If all samples agree, every order is tried
// exhaustively (event_orders.h) as far as a budget goes; only a complete search
// proves, and what rests on samples alone says so. Growth past a limit proves nothing:
// it might end later. In a box, which is full one day, there is no such limit.
//
//   coordinated      held: every order ends in one structure, by exhaustion;
//                    otherwise at best not contradicted by the samples
//   order-dependent  held: two orders were found that end differently
//   endless          never held: at best not contradicted, by samples still growing at
//                    the limit and none that ended; growth leaves the others undecided
//   bricks,          of every end found; a statement about all orders only when the
//   structure        search was complete (structure: modulo translation)
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lattice/event_orders.h"
#include "lattice/uses.h"
#include "rules/rule_set.h"

namespace stig::lattice {

enum class Standing : std::uint8_t {
  held,              ///< shown to be so
  not_contradicted,  ///< every sampled order agrees; not all orders were tried
  failed,            ///< shown not to be so
  undecided,         ///< neither, within the budget
};
std::string_view to_string(Standing standing);  ///< "not-contradicted"

/// One key of `expect` and how it stands.
struct ExpectationItem {
  std::string key;  ///< "bricks", "verdict", "structure"
  Standing standing = Standing::undecided;
  std::string expected;  ///< "6", "coordinated", "6 bricks as drawn"
  std::string found;     ///< in words
  std::string method;    ///< "all 9 reachable states", "64 sampled orders"
  SourceRange range;     ///< of the key's value in the file
};

struct ExpectationLimits {
  std::uint32_t samples = 64;
  std::uint64_t deposits = 20'000;  ///< of one sample, where there is no box
  /// The most steps of one sample: rules of low probability can idle.
  std::uint64_t steps = 10'000'000;
  std::uint64_t seed = 1;
  EventOrdersLimits search;
};

struct ExpectationReport {
  std::vector<ExpectationItem> items;  ///< those that the file names, in this order: bricks,
                                       ///< verdict, structure
  std::uint64_t states = 0;            ///< visited by the exhaustive search; 0: not needed
  bool interrupted = false;
  std::string problem;  ///< why the set cannot be run at all (see config_problem); then no items

  /// Nothing failed and nothing is undecided.
  bool passed() const;
};

/// Progress is told of the exhaustive search. Runs in the file's box, in unbounded space when it
/// has none, by event motion.
ExpectationReport verify_expectation(const RuleSet& rules, const ExpectationLimits& limits = {},
                                     const EventOrdersHooks& hooks = {});

}  // namespace stig::lattice
