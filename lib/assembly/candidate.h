// SPDX-License-Identifier: MIT
// An order of work, and what robots then meet that could tell every brick from every other.
//
// Rules see no more than a site's neighbours, so of an order they keep what it says of
// neighbours: a brick waits for those next to it that come before it. What else the order had in
// mind is lost, and more structures can occur on the way than the order goes through. Neighbours
// that can as well come the other way round may be left *free*: then neither waits for the other,
// which often neither robot could see. What can occur is walked with a colour for each brick, as
// robots with perfect eyes would: what these cannot do, no colours make possible.
#pragma once

#include <memory>
#include <optional>

#include "assembly/sequence.h"
#include "assembly/uses.h"
#include "compiler/policy.h"

namespace stig::assembly {

struct CandidateOrder {
  /// The bricks in the order of work, the start first, brick i of colour i + 1 as far as there are
  /// colours.
  std::unique_ptr<TargetBricks> target;
  Sequence sequence;             ///< bricks as the target numbered them
  std::vector<BrickSet> before;  ///< by brick here: neighbours that it waits for
  std::vector<BrickSet> free;    ///< neighbours that may be there or not
  /// Pruned, by what is seen and from which side. Complete where `walked` says so.
  Policy policy;
  bool walked = false;
};

/// With a colour for each brick, a target that is walked has so many at most.
inline constexpr std::size_t kMostWalkedBricks = 120;

/// Which neighbours wait for each other.
enum class Waiting : std::uint8_t {
  all,     ///< as the sequence has it
  needed,  ///< those that share no face are free where either may come first
};
/// Not walked yet.
CandidateOrder make_candidate(const TargetBricks& target, const Sequence& sequence,
                              const Builders& builders, Waiting waiting);

void walk(const Builders& builders, const std::shared_ptr<Visibility>& visibility,
          const PolicyLimits& limits, CandidateOrder& candidate);

}  // namespace stig::assembly
