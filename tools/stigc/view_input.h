// SPDX-License-Identifier: MIT
// What stigc view is given to show.
#pragma once

#include <string>
#include <vector>

#include "app.h"
#include "uses.h"
#include "view/page.h"

namespace stig::cli {

/// Names that stand for several files become those: that of a witness of verify, a folder of
/// validate.
std::vector<std::string> viewed_files(const std::vector<std::string>& names);

/// Adds what a file holds to the page. Problems are reported; false when there was one.
bool add_file(const std::string& path, const ViewOptions& options, const App& app,
              PageContent& page);

/// Adds the structure that runs are held against, if there is one; otherwise as above.
bool add_target(const ViewOptions& options, const App& app, PageContent& page);

}  // namespace stig::cli
