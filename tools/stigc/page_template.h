// SPDX-License-Identifier: MIT
// The template of pages, which the build makes of tools/viewer where there is node.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "uses.h"

namespace stig::cli {

/// Its text; nothing when it did not come with the program.
std::optional<std::string> shipped_page_template();

/// Likewise, which is complained of.
std::optional<std::string> page_template(const App& app);

/// Where the playground's page is; empty when it did not come with the program.
std::string playground_path();

}  // namespace stig::cli
