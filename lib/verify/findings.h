// SPDX-License-Identifier: MIT
// What else a proof or a refutation tells about a rule set.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/uses.h"
#include "verify/verify.h"

namespace stig::verify {

/// How much of the work can be done at once: in each round a brick is placed in every site
/// that is open when it begins and still when its turn comes.
struct Parallelism {
  std::vector<std::uint64_t> rounds;  ///< bricks of each round
  std::uint64_t widest() const;
  double mean() const;
};

/// A brick that can be walled in: in some order of events its site, open, is cut off from
/// the outside, so that an agent who walks through empty cells cannot get there.
struct WalledIn {
  Cell site;
  std::vector<Deposit> order;  ///< from the start to that structure
};
inline constexpr std::size_t kMostWalledIn = 3;  ///< that are shown of a rule set

/// A rule's brick that closes a site which another rule had open.
/// Where a certificate lists fillings, more is granted here than can occur.
struct Blocking {
  std::uint32_t placed = 0;   ///< rule whose brick does it
  std::uint32_t blocked = 0;  ///< rule that matched before, where none matches after
  Cell at, site;              ///< an example: the brick, and the site
  auto operator<=>(const Blocking&) const = default;
};

/// A change to the rule set that was tried: with it every order is proved to end alike.
struct Repair {
  std::vector<Rule> added;             ///< with exact patterns
  std::vector<std::uint32_t> removed;  ///< rules
  bool whole = true;         ///< proved for all stages; false: up to the one where orders parted
  std::uint64_t bricks = 0;  ///< at the end of the last stage that is proved
  RuleSet repaired;
};

struct Findings {
  std::vector<std::uint32_t> dead;       ///< rules that are proved never to fire
  std::vector<std::uint32_t> redundant;  ///< each alone can be left out: the proof still holds
  std::uint64_t untried = 0;             ///< rules of which it is not known (proved sets)
  /// By rule: the level of the firing graph, the least number of other rules' levels that
  /// must have come before; none: it cannot fire, or the graph is too large.
  std::vector<std::optional<int>> levels;
  int level_count = 0;
  std::optional<Parallelism> parallelism;  ///< proved sets
  std::vector<Blocking> blocking;
  std::vector<WalledIn> walled_in;    ///< examples, kMostWalledIn at most
  std::uint64_t maybe_walled_in = 0;  ///< sites of which neither was shown
  std::optional<Repair> repair;       ///< refuted sets: the smallest that was found
  bool repair_cut_short = false;      ///< none was found, and not all were tried
};

/// For repairs, redundant rules and walled-in bricks together.
struct FindingOptions {
  std::uint64_t work = kVerifyWork / 6;  ///< steps (budget.h)
  double seconds = kNoTimeLimit;
};

Findings find_more(const RuleSet& rules, const VerifyOptions& options, const VerifyResult& result,
                   const FindingOptions& limits);

}  // namespace stig::verify
