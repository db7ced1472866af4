// SPDX-License-Identifier: MIT
// What is done to a run by hand, between two steps.
#pragma once

#include <string>

#include "physical/simulation/uses.h"
#include "physical/trace/hand_action.h"

namespace stig::physics {

struct RunState;

/// What is in the way, as a sentence; empty: it is done. With a problem, the run is as before.
std::string work_by_hand(RunState& run, const HandAction& action);

}  // namespace stig::physics
