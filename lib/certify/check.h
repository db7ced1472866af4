// SPDX-License-Identifier: MIT
// The checker of certificates: small, simple, and without a line in common with those
// who write them. It takes from the rest of the project how a rule set is read, the
// offsets of the neighbours and the symmetry groups; what a rule matches, where bricks
// stand and what can be there at the same time it works out for itself.
//
// What an accepted certificate proves, and why, is in docs/proofs.md: whatever the order
// of events, they end, and they end in this one structure. An event is a deposit that
// some rule allows at an empty site beside a brick; a rule with a probability may act or
// not, and of several that match under `conflicts: first` only the first acts.
//
// Time grows with the number of bricks times the local states of each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/certificate.h"
#include "certify/uses.h"

namespace stig::certify {

struct CheckReport {
  bool accepted = false;
  std::string refusal;                 ///< one sentence: what does not hold, in which stage, where
  std::optional<BoxSpec> box;          ///< in which it is proved; none: in unbounded space
  std::vector<PlacedBrick> structure;  ///< the end of every order, by cell
  std::uint64_t sites = 0;             ///< looked at, over all stages
  std::uint64_t local_states = 0;      ///< of all sites
};

/// Verifies a certificate for these rules in the box that the file says.
CheckReport check_certificate(const RuleSet& rules, const Certificate& certificate);
/// The same in another box than the file's, or in none. Without an origin it is laid
/// around the start as lattice/box.h does.
CheckReport check_certificate(const RuleSet& rules, const Certificate& certificate,
                              const std::optional<BoxSpec>& box);

}  // namespace stig::certify
