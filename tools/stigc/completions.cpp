// SPDX-License-Identifier: MIT
// Completion scripts. The value of an option says how to complete it: words parted
// by bars are offered as they are, FILE and its like are files, the rest is not
// completed.
//
// Written for each shell by hand from the tree of commands (command_line.cpp): each has a language
// of its own, and they share nothing but what an option is called and takes.
#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostic.h"
#include "base/text.h"
#include "help.h"

namespace stig::cli {
namespace {

bool is_file(const OptionInfo& option) {
  return option.value == "FILE" || option.value == "TRACE" || option.value == "STRUCTURE" ||
         option.value == "PROOF";
}

/// The words of "a|b|c" and the codes of diagnostics; none for other values.
std::vector<std::string> words_of(const OptionInfo& option) {
  std::vector<std::string> words;
  if (option.value == "[CODE]") {
    for (const CodeInfo& code : all_codes()) words.emplace_back(code.name);
    return words;
  }
  std::string rest = option.value;
  if (rest.find('|') == std::string::npos) return words;
  while (true) {
    const std::size_t bar = rest.find('|');
    words.push_back(rest.substr(0, bar));
    if (bar == std::string::npos) return words;
    rest.erase(0, bar + 1);
  }
}

/// Within single quotes of fish, where a backslash escapes.
std::string fish_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

/// The options of a command and those of every command, each name once. A command's own help option
/// hides the global one.
std::vector<OptionInfo> all_options(const CommandTree& tree, const CommandInfo& command) {
  std::vector<OptionInfo> options = command.options;
  for (const OptionInfo& option : tree.global) {
    const auto same = [&](const OptionInfo& own) { return own.names == option.names; };
    if (std::none_of(options.begin(), options.end(), same)) options.push_back(option);
  }
  return options;
}

std::string names_of(const std::vector<OptionInfo>& options) {
  std::vector<std::string> names;
  for (const OptionInfo& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return fmt::format("{}", fmt::join(names, " "));
}

/// The lines of bash that answer for one option's value or a positional argument.
std::string bash_values(const OptionInfo& option) {
  const auto words = words_of(option);
  if (!words.empty()) {
    return fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$cur\"))", fmt::join(words, " "));
  }
  // `:` does nothing, and is needed where a case must not be empty.
  return is_file(option) ? "compopt -o filenames; COMPREPLY=($(compgen -f -- \"$cur\"))" : ":";
}

/// Answers for the value of the option before the cursor, if there is one.
std::string bash_option_values(const std::vector<OptionInfo>& options) {
  std::string out = "      case \"$prev\" in\n";
  for (const OptionInfo& option : options) {
    if (option.names.empty() || option.value.empty()) continue;
    out += fmt::format("        {}) {}; return ;;\n", fmt::join(option.names, "|"),
                       bash_values(option));
  }
  return out + "      esac\n";
}

std::string bash_command(const CommandTree& tree, const CommandInfo& command) {
  const auto options = all_options(tree, command);
  std::string positional = ":";
  for (const OptionInfo& option : options) {
    // The last positional argument is completed everywhere; none of the commands has two of
    // different kinds.
    if (option.names.empty()) positional = bash_values(option);
  }
  std::string out = fmt::format("    {})\n{}", command.name, bash_option_values(options));
  out += "      case \"$cur\" in\n";
  out +=
      fmt::format("        -*) COMPREPLY=($(compgen -W '{}' -- \"$cur\")) ;;\n", names_of(options));
  return out + fmt::format("        *) {} ;;\n      esac ;;\n", positional);
}

std::string bash_script(const CommandTree& tree) {
  std::string names;
  std::string cases;
  for (const CommandInfo& command : tree.commands) {
    names += (names.empty() ? "" : " ") + command.name;
    cases += bash_command(tree, command);
  }
  return "# bash completion for stigc: source <(stigc completions bash)\n"
         "_stigc() {\n"
         "  local cur=\"${COMP_WORDS[COMP_CWORD]}\" prev=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
         "  local command='' word\n"
         "  COMPREPLY=()\n"
         // The first word that is a command, wherever global options stand.
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case \" " +
         names +
         " \" in *\" $word \"*) command=\"$word\"; break ;; esac\n"
         "  done\n"
         "  case \"$command\" in\n" +
         cases + "    *)\n" + bash_option_values(tree.global) + "      COMPREPLY=($(compgen -W '" +
         names + " " + names_of(tree.global) +
         "' -- \"$cur\")) ;;\n"
         "  esac\n"
         "}\n"
         "complete -F _stigc stigc\n";
}

/// `text` in a specification of _arguments: brackets and colons are special there.
std::string zsh_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    // Quotes are for shell_quoted, which comes after.
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

/// ":message:action" for an option's value; empty for a flag.
std::string zsh_value(const OptionInfo& option) {
  if (option.value.empty()) return {};
  const auto words = words_of(option);
  if (!words.empty()) return fmt::format(":value:({})", fmt::join(words, " "));
  return fmt::format(":{}:{}", zsh_escaped(option.value), is_file(option) ? "_files" : "");
}

std::string zsh_options(const std::vector<OptionInfo>& options, const std::string& indent) {
  std::string out;
  for (const OptionInfo& option : options) {
    if (option.names.empty()) {
      // `1` is the first argument, `*` all.
      out += fmt::format("{}{} \\\n", indent,
                         shell_quoted((option.many ? "*" : "1") + zsh_value(option)));
    }
    for (const std::string& name : option.names) {
      const std::string spec = fmt::format("{}{}[{}]{}", option.many ? "*" : "", name,
                                           zsh_escaped(option.doc), zsh_value(option));
      out += fmt::format("{}{} \\\n", indent, shell_quoted(spec));
    }
  }
  return out;
}

std::string zsh_script(const CommandTree& tree) {
  std::string commands, cases;
  for (const CommandInfo& command : tree.commands) {
    commands += fmt::format("    {}\n", shell_quoted(command.name + ":" + command.summary));
    cases += fmt::format("        {})\n          _arguments -s \\\n{}            && return ;;\n",
                         command.name, zsh_options(all_options(tree, command), "            "));
  }
  return "#compdef stigc\n"
         "# zsh completion for stigc: put this into a file _stigc in a folder of $fpath\n"
         "_stigc() {\n"
         "  local curcontext=\"$curcontext\" state line\n"
         "  local -a commands\n"
         "  commands=(\n" +
         commands +
         "  )\n"
         // -C keeps the state for what follows; -> hands on.
         "  _arguments -C \\\n" +
         zsh_options(tree.global, "    ") +
         "    '1:command:->command' \\\n"
         "    '*::argument:->argument' && return\n"
         "  case $state in\n"
         "    command) _describe command commands ;;\n"
         "    argument)\n"
         "      case $line[1] in\n" +
         cases +
         "      esac ;;\n"
         "  esac\n"
         "}\n"
         "_stigc \"$@\"\n";
}

std::string fish_option(const std::string& condition, const OptionInfo& option) {
  std::string out = "complete -c stigc -n " + fish_quoted(condition);
  for (const std::string& name : option.names) {
    // -l for long names, -s for letters.
    const bool is_long = name.starts_with("--");
    out += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
  }
  const auto words = words_of(option);
  if (!words.empty()) {
    out += fmt::format(" -x -a '{}'", fmt::join(words, " "));
  } else if (is_file(option)) {
    // -r: a value is required; -F: files, against the -f that turned them off.
    out += option.names.empty() ? " -F" : " -r -F";
  } else if (!option.value.empty()) {
    out += " -x";
  }
  return out + (option.names.empty() ? "" : " -d " + fish_quoted(option.doc)) + "\n";
}

std::string fish_script(const CommandTree& tree) {
  std::string out =
      "# fish completion for stigc: put this into ~/.config/fish/completions/stigc.fish\n"
      "complete -c stigc -f\n";
  for (const CommandInfo& command : tree.commands) {
    out += fmt::format("complete -c stigc -n __fish_use_subcommand -a {} -d {}\n", command.name,
                       fish_quoted(command.summary));
  }
  for (const OptionInfo& option : tree.global) out += fish_option("true", option);
  for (const CommandInfo& command : tree.commands) {
    const std::string condition = "__fish_seen_subcommand_from " + command.name;
    for (const OptionInfo& option : command.options) {
      const auto same = [&](const OptionInfo& global) { return global.names == option.names; };
      // Global options were offered once for all commands.
      if (std::any_of(tree.global.begin(), tree.global.end(), same)) continue;
      out += fish_option(condition, option);
    }
  }
  return out;
}

}  // namespace

std::string completion_script(const CommandTree& tree, Shell shell) {
  switch (shell) {
    case Shell::bash:
      return bash_script(tree);
    case Shell::zsh:
      return zsh_script(tree);
    case Shell::fish:
      return fish_script(tree);
  }
  return {};
}

}  // namespace stig::cli
