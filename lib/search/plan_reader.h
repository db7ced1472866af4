// SPDX-License-Identifier: MIT
// Reading the plan of a search: a YAML file by the same tables of keys as all others.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostic.h"
#include "search/search_plan.h"
#include "search/uses.h"

namespace stig::search {

/// The plan, or nothing when an error was reported.
std::optional<SearchPlan> read_search_plan(SourceRef source, Diagnostics& diagnostics);
/// Reads the file first; one that cannot be read is a diagnostic too.
std::optional<SearchPlan> read_search_plan_file(const std::string& path, Diagnostics& diagnostics);

/// JSON Schema of plans.
std::string plan_schema();

}  // namespace stig::search
