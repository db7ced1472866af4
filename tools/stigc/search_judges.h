// SPDX-License-Identifier: MIT
// Those who judge a search's candidates from outside of lib/search: the compiler, for the robot
// that a plan names, and the user's program in Lua.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "base/diagnostic.h"
#include "compiler/abilities.h"
#include "lua/lua_settings.h"
#include "search/find_archive.h"
#include "search/judges.h"
#include "search/search_plan.h"
#include "uses.h"

namespace stig::cli {

/// A plan, and the contents of the files that it names.
struct SearchTask {
  search::SearchPlan plan;
  std::optional<Abilities> robot;
  std::optional<LuaProgram> program;
};

/// Files are found beside the plan, robots also where scenes find them; the plan's `outside` is
/// made of what is in them. Errors are reported.
std::optional<SearchTask> read_search_task(const std::string& path, App& app);

/// They look into the task.
search::Judges judges_of(const SearchTask& task);

/// Reports, with C501, why the task's program has no score for it.
void report_unscored(const SearchTask& task, const search::Individual& one, const App& app);

}  // namespace stig::cli
