// SPDX-License-Identifier: MIT
// The rule set that a trace on the lattice carries.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "lattice/trace.h"

namespace stig {

/// Problems are reported under the trace's name.
std::optional<RuleSet> rules_of(const Trace& trace, const std::string& path, const App& app);

}  // namespace stig
