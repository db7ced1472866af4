// SPDX-License-Identifier: MIT
// What is said when an exception finds nobody to catch it, in whichever thread. Exceptions of
// vendors end where the vendor is wrapped, and the program's own do not exist: this one is a bug,
// unless it says that memory or the system gave out.
#pragma once

#include "uses.h"

namespace stig::cli {

/// From now on such an exception ends the process with a message on standard error and exit
/// status 3, in place of a signal.
void prepare_last_words();

}  // namespace stig::cli
