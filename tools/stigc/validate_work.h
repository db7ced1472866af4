// SPDX-License-Identifier: MIT
// What robots' time went into, as JSON and as lines for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "uses.h"
#include "validate/work_summary.h"

namespace stig::cli {

using Json = nlohmann::ordered_json;

Json to_json(const WorkSummary& all);
Json to_json(const std::vector<WorkPhase>& phases);
/// Mean and deviation of the time that complete runs took.
std::string time_in_words(const WorkSummary& all);
std::string work_in_words(const WorkSummary& all);
/// Ideal time by the time that was taken (validate/ideal_time.h).
std::string efficiency_in_words(const WorkSummary& all);
/// A table; nothing where there are none.
std::string lines_of(const std::vector<WorkPhase>& phases);
std::string state_lines(const WorkSummary& all);

}  // namespace stig::cli
