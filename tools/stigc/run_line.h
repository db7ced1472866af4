// SPDX-License-Identifier: MIT
// A command line, run: by the program, or by a part of it that makes many.
#pragma once

#include <string>
#include <vector>

#include "app.h"
#include "command_line.h"
#include "uses.h"

namespace stig::cli {

/// A program's main: streams and signals, last words, arguments, the command, its exit code.
/// Exceptions that nobody caught end the program (last_words.h).
int run_main(int argc, const char* const* argv);

/// Runs what was said; an exit code. Names of files that ship are looked up in it.
int run_parsed(Parsed& parsed, App& app);

/// "explore", "rulesets/wall.yaml", "--seed=2".
Parsed parse_words(const std::vector<std::string>& words);
/// The same with what it prints and says kept. Several threads may do so at a time.
int run_captured(Parsed& parsed, Captured& captured);

}  // namespace stig::cli
