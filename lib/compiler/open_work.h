// SPDX-License-Identifier: MIT
// What robots that come to a structure put there: by the decisions that were compiled.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "compiler/compile.h"
#include "compiler/uses.h"

namespace stig::compiler {

class OpenWork {
 public:
  /// Compiled rules that have a decision; they must outlive it.
  explicit OpenWork(const CompiledRules& compiled);

  /// The bricks, and for each a side from which it is put; none in a structure that robots never
  /// come to by themselves.
  std::map<std::uint32_t, ApproachSide> in(const BrickSet& state) const;
  /// Likewise by robots that work from some of the compiled sides alone.
  std::map<std::uint32_t, ApproachSide> in(const BrickSet& state,
                                           const std::vector<ApproachSide>& sides) const;
  /// Is it known what robots do in a structure?
  bool knows(const BrickSet& state) const;

 private:
  std::map<std::uint32_t, ApproachSide> by_the_walk(const BrickSet& state,
                                                    const std::vector<ApproachSide>& sides) const;
  std::map<std::uint32_t, ApproachSide> by_looking(const BrickSet& state,
                                                   const std::vector<ApproachSide>& sides) const;
  std::optional<std::uint32_t> decided(const BrickSet& state, ApproachSide side, int u,
                                       int v) const;

  const CompiledRules& compiled_;
  std::map<BrickSet, std::uint32_t> numbers_;  ///< of the policy's states, where all were walked
  mutable std::optional<Sight> sight_;         ///< otherwise
};

}  // namespace stig::compiler
