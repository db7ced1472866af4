// SPDX-License-Identifier: MIT
// Help and completion scripts, written from the command tree.
#pragma once

#include <string>

#include "command_line.h"
#include "uses.h"

namespace stig::cli {

/// `stigc --help`, or the help of one command.
std::string help_text(const CommandTree& tree);
std::string help_text(const CommandTree& tree, const CommandInfo& command);
std::string usage_line(const CommandInfo& command);

/// A script for the shell to load; see its first lines.
std::string completion_script(const CommandTree& tree, Shell shell);

}  // namespace stig::cli
