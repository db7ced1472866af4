// SPDX-License-Identifier: MIT
// At how many sites could robots place a brick at once? By the decisions that were compiled, in the
// structure as it stood: what rules alone allow but no robot is told to do is not counted.
//
// It says how many robots a structure can use: of the stepped pyramid the column in the middle is
// one site after the other, then there are four at a time, then fewer.
#pragma once

#include <utility>
#include <vector>

#include "compiler/open_work.h"
#include "validate/uses.h"
#include "validate/watch.h"

namespace stig::validate {

class WorkSites {
 public:
  /// Compiled rules that have a decision; they must outlive it.
  explicit WorkSites(const CompiledRules& compiled) : compiled_(compiled), open_(compiled) {}

  /// In a structure on the way; none in one that robots never come to by themselves.
  int in(const BrickSet& state) const { return static_cast<int>(open_.in(state).size()); }
  /// As the events made and unmade bricks of all structures: s, sites from then on; the first at
  /// 0 s.
  std::vector<std::pair<double, int>> over(const std::vector<BrickEvent>& events,
                                           const BuildTarget& target) const;

 private:
  const CompiledRules& compiled_;
  OpenWork open_;
};

}  // namespace stig::validate
