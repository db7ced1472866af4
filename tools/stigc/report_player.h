// SPDX-License-Identifier: MIT
// The runs of a validation as its report plays them.
#pragma once

#include <string>
#include <vector>

#include "app.h"
#include "uses.h"
#include "validate/report_html.h"

namespace stig::cli {

/// What a report says that has pictures alone.
inline constexpr const char* kNoPlayer =
    "This program was built without its viewer: there are pictures alone, and the runs cannot be "
    "played here.";

/// From the traces of a report's runs, in their order. Nothing, and a complaint, when one of them
/// cannot be read or the template is damaged.
std::optional<ReportPlayer> report_player(const std::string& page_template,
                                          const std::vector<std::string>& traces, const App& app);

}  // namespace stig::cli
