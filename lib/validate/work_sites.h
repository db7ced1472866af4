// SPDX-License-Identifier: MIT
// At how many sites could robots place a brick at once? By the decisions that were compiled, in the
// structure as it stood: what rules alone allow but no robot is told to do is not counted.
//
// It says how many robots a structure can use: of the stepped pyramid the column in the middle is
// one site after the other, then there are four at a time, then fewer.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "compiler/compile.h"
#include "validate/watch.h"

namespace stig {

class WorkSites {
 public:
  /// Compiled rules that have a decision; they must outlive it.
  explicit WorkSites(const CompiledRules& compiled);

  /// In a structure on the way; none in one that robots never come to by themselves.
  int in(const BrickSet& state) const;
  /// As the events made and unmade bricks: s, sites from then on; the first at 0 s.
  std::vector<std::pair<double, int>> over(const std::vector<BrickEvent>& events,
                                           const RuleSet& rules) const;

 private:
  const CompiledRules& compiled_;
  std::map<BrickSet, std::uint32_t> numbers_;  ///< of the policy's states
};

}  // namespace stig
