// SPDX-License-Identifier: MIT
// The library that compiled controllers bring with them: programs/ on the disk.
#pragma once

#include <optional>
#include <vector>

#include "app.h"
#include "compiler/controller_lua.h"

namespace stig {

/// In the order of kRuntimeModules; what is missing is said.
std::optional<std::vector<RuntimeModule>> read_runtime(const App& app);

}  // namespace stig
