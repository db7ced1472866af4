// SPDX-License-Identifier: MIT
// One item of a study: its command line, run, and what is recorded of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sweep_plan.h"
#include "uses.h"

namespace stig::cli {

/// What the command would say against a point; empty: nothing.
std::string problem_at(const SweepPlan& plan, const std::vector<SweepValue>& point);

/// A JSON object in one line, the same whoever makes it; empty where the user asked to stop.
std::string item_record(const SweepPlan& plan, std::uint64_t item);

}  // namespace stig::cli
