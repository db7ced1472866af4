// SPDX-License-Identifier: MIT
// The options of a command with their values, those that nobody gave among them.
#pragma once

#include "options.h"
#include "report.h"
#include "uses.h"

namespace stig::cli {

/// An object; null where the file or the command chooses, which its report says. Options that say
/// what is written are left out. Of explore, verify, synth, compile and validate; null of others.
Json option_values(const CommandOptions& options);

}  // namespace stig::cli
