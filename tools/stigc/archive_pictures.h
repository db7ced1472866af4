// SPDX-License-Identifier: MIT
// Results of searches as figures and as a page with pictures of finds.
#pragma once

#include "app.h"
#include "options.h"
#include "uses.h"

namespace stig::cli {

/// What --plot names: nothing wrong, or what.
std::string plot_problem(const std::string& names);

/// Exit codes.
int write_plot(const ArchiveOptions& options, const App& app);
int write_gallery(const ArchiveOptions& options, const App& app);

}  // namespace stig::cli
