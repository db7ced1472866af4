// SPDX-License-Identifier: MIT
// The library that compiled controllers bring with them: programs/ on the disk.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app.h"
#include "compiler/controller_lua.h"
#include "uses.h"

namespace stig::cli {

/// One of its files, "motion.lift" for motion/lift.lua; said when it is missing.
std::optional<std::string> read_module(std::string_view name, const App& app);
/// kRuntimeRoot and all that it requires, each after what it requires itself; what is missing is
/// said.
std::optional<std::vector<std::string>> read_runtime(const App& app);

}  // namespace stig::cli
