// SPDX-License-Identifier: MIT
// The command line: what there is to say (CommandTree) and what was said
// (CommandLine). The parser's library stays in command_line.cpp and in the files
// that declare options (option_kinds.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "uses.h"

namespace stig::cli {

/// An option or a positional argument, as help and completions show it.
struct OptionInfo {
  std::vector<std::string> names;  ///< "-o", "--output"; empty: positional
  std::string value;               ///< "N", "FILE", "walk|teleport|event"; empty: a flag
  std::string doc;
  bool many = false;  ///< may be given several times
  bool required = false;
};

struct CommandInfo {
  std::string name;
  std::string summary;              ///< one line
  std::string examples;             ///< lines, indented by two
  std::vector<OptionInfo> options;  ///< positional ones first
};

struct CommandTree {
  std::vector<OptionInfo> global;
  std::vector<CommandInfo> commands;
};

CommandTree command_tree();

struct Parsed {
  std::optional<CommandLine> line;     ///< to be run
  std::string help;                    ///< to be printed on standard output instead
  std::optional<std::string> explain;  ///< a code that is to be explained; empty: all are listed
  std::string problem;                 ///< a usage error
  std::string command;                 ///< the command that help or problem is about, if any
};

Parsed parse_command_line(int argc, const char* const* argv);

}  // namespace stig::cli
