// SPDX-License-Identifier: MIT
// What robots see and may do on the way, column by column: without a walk over all structures.
//
// What can occur are the closed sets of the candidate's order (compiler/local_situations.h). A
// brick is put from those sides alone from where it can be put in all of them once it is due,
// whatever other robots have done meanwhile.
#pragma once

#include <memory>

#include "assembly/cases.h"
#include "assembly/uses.h"

namespace stig::assembly {

/// Nothing when some brick might have to wait for ever, or when there is too much to look at.
/// `looked` counts situations.
std::optional<Cases> local_cases(const CandidateOrder& candidate, const Builders& builders,
                                 const std::shared_ptr<Visibility>& visibility,
                                 std::size_t& looked);

}  // namespace stig::assembly
