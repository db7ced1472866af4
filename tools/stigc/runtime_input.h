// SPDX-License-Identifier: MIT
// The library that compiled controllers bring with them: programs/ on the disk.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "app.h"
#include "compiler/controller_lua.h"

namespace stig {

/// One of its files, "argos" for argos.lua; said when it is missing.
std::optional<RuntimeModule> read_module(std::string_view name, const App& app);
/// In the order of kRuntimeModules; what is missing is said.
std::optional<std::vector<RuntimeModule>> read_runtime(const App& app);

}  // namespace stig
