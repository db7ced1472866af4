// SPDX-License-Identifier: MIT
// Trace files, and the rule set that a trace on the lattice carries.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "lattice/trace.h"
#include "uses.h"

namespace stig::cli {

inline constexpr std::size_t kMostTraceBytes = std::size_t{1}
                                               << 30;  ///< of a file, which is read whole

/// The bytes of a trace of either kind; complains when there are none.
std::optional<std::string> trace_bytes(const std::string& path, const App& app);

/// Problems are reported under the trace's name.
std::optional<RuleSet> rules_of(const Trace& trace, const std::string& path, const App& app);

}  // namespace stig::cli
