// SPDX-License-Identifier: MIT
// Runs as the viewer takes them, and as files to be saved.
#pragma once

#include <string>
#include <vector>

#include "answers.h"
#include "lattice/trace.h"
#include "rules/rule_set.h"
#include "view/page.h"

namespace stig::playground {

/// An order of events from elsewhere, which ends in `end`.
Trace given_order(const RuleSet& rules, const std::optional<Box>& box,
                  const std::vector<Deposit>& events, const Structure& end);

/// Adds `view` to an answer: the data of a page (view/page_data.h), the columns in base64.
void add_view(const PageContent& page, Json& out);

/// Bytes of a trace file in base64, which the program's replay and view read.
std::string trace_file(const RuleSet& rules, const Trace& trace);

}  // namespace stig::playground
