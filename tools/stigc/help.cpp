// SPDX-License-Identifier: MIT
// Two columns, 98 wide: 26 for names, the rest for what they mean. Examples are run by a test, so
// they stand here as they are typed.
#include "help.h"

#include <fmt/format.h>

#include <algorithm>

namespace stig::cli {
namespace {

constexpr std::size_t kIndent = 26;
constexpr std::size_t kWidth = 98;

/// Words of `text` in lines that start at column kIndent. Breaks at blanks alone; a word that is
/// wider than the column stands out.
std::string wrapped(std::string_view text) {
  std::string out;
  std::size_t column = kIndent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column > kIndent && column + 1 + end > kWidth) {
      out += '\n' + std::string(kIndent, ' ');
      column = kIndent;
    } else if (column > kIndent) {
      out += ' ';
      ++column;
    }
    out += text.substr(0, end);
    column += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string entry(const std::string& left, std::string_view doc) {
  std::string out = "  " + left;
  // What does not fit beside its description stands on a line of its own.
  if (out.size() + 2 > kIndent) {
    out += '\n' + std::string(kIndent, ' ');
  } else {
    out.resize(kIndent, ' ');
  }
  return out + wrapped(doc) + '\n';
}

std::string option_entry(const OptionInfo& option) {
  std::string left = fmt::format("{}", fmt::join(option.names, ", "));
  if (!option.value.empty()) left += (left.empty() ? "" : " ") + option.value;
  return entry(left, option.doc);
}

std::string options_of(const std::vector<OptionInfo>& options, bool positional) {
  std::string out;
  for (const OptionInfo& option : options) {
    if (option.names.empty() == positional) out += option_entry(option);
  }
  return out;
}

}  // namespace

// What the shell would need to run it at all; the lists below say the rest.
std::string usage_line(const CommandInfo& command) {
  std::string line = "Usage: stigc " + command.name;
  // Required options are part of the usage; all others are "[options]".
  for (const OptionInfo& option : command.options) {
    const std::string shown = option.value + (option.many ? "…" : "");
    if (option.names.empty()) {
      line += option.required ? " " + shown : " [" + shown + "]";
    } else if (option.required) {
      line += " " + option.names.front() + " " + shown;
    }
  }
  return line + " [options]\n";
}

std::string help_text(const CommandTree& tree) {
  std::string out =
      "stigc - rule sets of collective construction: check them, run them, explain them.\n\n"
      "Usage: stigc COMMAND …\n       stigc --explain [CODE]\n\nCommands:\n";
  for (const CommandInfo& command : tree.commands) out += entry(command.name, command.summary);
  out += "\nOptions of every command:\n" + options_of(tree.global, false);
  return out +
         "\nExamples:\n"
         "  stigc check rulesets/staircase.yaml\n"
         "  stigc explore rulesets/staircase.yaml -o staircase.png\n"
         "  stigc explain rulesets/staircase.yaml --at 1,0,0\n"
         "  stigc --explain R304\n"
         "\nrulesets/, scenes/, robots/, blocks/ and programs/ that are not in the working "
         "directory\n"
         "are those that come with the program.\n"
         "\nExit status: 0 all is well; 1 a file is invalid or a property does not hold; 2 the\n"
         "command line is wrong; 3 the work failed, ran out of its budget or was interrupted.\n";
}

std::string help_text(const CommandTree& tree, const CommandInfo& command) {
  std::string out =
      fmt::format("stigc {} - {}\n\n{}", command.name, command.summary, usage_line(command));
  const std::string arguments = options_of(command.options, true);
  if (!arguments.empty()) out += "\nArguments:\n" + arguments;
  out += "\nOptions:\n" + options_of(command.options, false);
  out += "\nOptions of every command:\n";
  for (const OptionInfo& option : tree.global) {
    // Not twice, where a command has its own.
    const auto named = [&](const OptionInfo& own) { return own.names == option.names; };
    if (std::none_of(command.options.begin(), command.options.end(), named)) {
      out += option_entry(option);
    }
  }
  return out + "\nExamples:\n" + command.examples;
}

}  // namespace stig::cli
