// SPDX-License-Identifier: MIT
// Files that come with the program: rulesets/, scenes/, robots/, blocks/, programs/ and studies/.
//
// They are found from any folder by the names that the documentation has for them, such as
// rulesets/staircase.yaml. A file of that name in the working directory comes first, and the name
// of what a command writes is never looked up: results go where the command line says.
#pragma once

#include <string>
#include <vector>

#include "app.h"
#include "options.h"
#include "uses.h"

namespace stig::cli {

/// The folder of the program beside which files that ship are; otherwise this process's own. For
/// processes that are no stigc. Before any other of these is called.
void set_program_folder(const std::string& folder);

/// Where files of a kind ("robots") may be: installed beside the program, or in its sources.
std::vector<std::string> shipped_folders(const std::string& kind);

/// The name of the shipped file that a name means, or the name itself.
std::string shipped_name(const std::string& name);

/// Names of files that the command reads, and that are not there, become those of shipped files
/// where there are such; a remark says which is read.
void find_shipped_files(CommandOptions& options, const App& app);

}  // namespace stig::cli
