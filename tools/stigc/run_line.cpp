// SPDX-License-Identifier: MIT
// Exceptions that mean "no memory" end the command with a message and its exit code.
#include "run_line.h"

#include <algorithm>
#include <new>

#include "commands.h"
#include "help.h"
#include "last_words.h"
#include "shipped_files.h"

namespace stig::cli {
namespace {

int print_help(const Parsed& parsed, App& app) {
  // The version is text already.
  if (parsed.help != "help") {
    app.print(parsed.help);
    return kOk;
  }
  const CommandTree tree = command_tree();
  const auto command = std::find_if(tree.commands.begin(), tree.commands.end(),
                                    [&](const CommandInfo& c) { return c.name == parsed.command; });
  app.print(command == tree.commands.end() ? help_text(tree) : help_text(tree, *command));
  return kOk;
}

int complain(const Parsed& parsed, const App& app) {
  const std::string name = parsed.command.empty() ? "stigc" : "stigc " + parsed.command;
  app.complain(printable(parsed.problem) + "\ntry '" + name + " --help'");
  return kUsage;
}

int run_command(Parsed& parsed, App& app) {
  if (!parsed.problem.empty()) return complain(parsed, app);
  if (parsed.explain) return explain_code(*parsed.explain, app);
  if (!parsed.line) return print_help(parsed, app);
  // Names of files are looked for once, for all commands: a name that leads to nothing may be that
  // of a file which ships.
  find_shipped_files(parsed.line->command, app);
  return std::visit([&](const auto& options) { return run(options, app); }, parsed.line->command);
}

}  // namespace

int run_parsed(Parsed& parsed, App& app) {
  try {
    return run_command(parsed, app);
  } catch (const std::bad_alloc&) {
    app.complain("there is not enough memory for this");
    return kRunFailed;
  }
}

Parsed parse_words(const std::vector<std::string>& words) {
  std::vector<const char*> argv{"stigc"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  return parse_command_line(static_cast<int>(argv.size()), argv.data());
}

int run_captured(Parsed& parsed, Captured& captured) {
  App app(parsed.line ? parsed.line->global : GlobalOptions{}, captured);
  const int code = run_parsed(parsed, app);
  app.flush();
  return code;
}

int run_main(int argc, const char* const* argv) {
  prepare_process();
  prepare_last_words();
  Parsed parsed = parse_command_line(argc, argv);
  App app(parsed.line ? parsed.line->global : GlobalOptions{});
  const int code = run_parsed(parsed, app);
  const bool flushed = app.flush();
  // Asked for after the last look at the flag, while measuring or writing, a stop counts
  // all the same.
  return flushed && !stop_requested() ? code : kRunFailed;
}

}  // namespace stig::cli
