// SPDX-License-Identifier: MIT
// A candidate as rules see it: local states and keys of every site (synthesis/local_states.h),
// under the candidate's own relation between neighbours in place of a rank.
#pragma once

#include <optional>
#include <vector>

#include "assembly/candidate.h"
#include "assembly/uses.h"
#include "synthesis/local_states.h"
#include "synthesis/target.h"

namespace stig::assembly {

struct RuleView {
  Frame frame;
  std::optional<Schedule> schedule;  ///< none: rules cannot follow the order
  std::vector<std::uint32_t> brick;  ///< the candidate's, by orbit
};
/// The frame must not move afterwards: the schedule points to it.
void look_at_rules(const Target& target, const CandidateOrder& candidate, RuleView& out);

}  // namespace stig::assembly
