// SPDX-License-Identifier: MIT
// Why rules are refused, as a page: the structures that the reason is about, with the brick that
// is wanted and those in the way.
#pragma once

#include <string>

#include "app.h"
#include "compiler/compile.h"
#include "uses.h"

namespace stig::cli {

/// Writes the page, or says that the refusal is about no structure; an exit code.
int write_refusal_page(const std::string& path, const RuleSet& rules, const CompiledRules& compiled,
                       const Diagnostics& diagnostics, App& app);

}  // namespace stig::cli
