// SPDX-License-Identifier: MIT
// A validation as JSON and as lines for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "uses.h"
#include "validate/report_html.h"

namespace stig::cli {

using Json = nlohmann::ordered_json;

Json to_json(const ValidationReport& report);
/// With the bricks of a single run, and a table of several.
std::string lines_of(const ValidationReport& report, bool color);

}  // namespace stig::cli
