// SPDX-License-Identifier: MIT
// What robots that are left can build no more. By the decisions that were compiled, which say what
// is put from which side: all structures are looked at to which robots that keep to their sides can
// bring one as it stands. And by what programs do: they take blocks from the floor alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "validate/trial.h"
#include "validate/uses.h"

namespace stig::validate {

/// Of all structures to which robots can bring one.
struct StructureReach {
  bool whole = false;                ///< the target is one of them
  std::vector<std::uint32_t> never;  ///< bricks of the target that stand in none, rising
};

inline constexpr std::size_t kMostReached = 20'000;  ///< structures

/// Those that robots on these sides come to. Nothing where they are more than `most`, or where one
/// is a structure of which it is not known what robots do. Compiled rules that have a decision.
std::optional<StructureReach> reach_of(const CompiledRules& compiled, const BrickSet& standing,
                                       const std::vector<ApproachSide>& sides,
                                       std::size_t most = kMostReached);

/// For each structure that is right as it stands, and that robots which still run cannot complete
/// from the sides that they are bound to: why, a sentence; and for each brick on another whose LEDs
/// are all dead. Nothing where some robot runs another program than the compiled one.
std::vector<std::string> out_of_reach(const BuildTarget& target, const CompiledRules& compiled,
                                      const Scene& scene, const Trial& trial);

}  // namespace stig::validate
