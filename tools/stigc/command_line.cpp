// SPDX-License-Identifier: MIT
// The parser is made anew for each use; what it reads goes into the options of its commands, and
// help, completions and suggestions are taken from the same declarations, so that none can be out
// of date.
#include "command_line.h"

#include <algorithm>
#include <functional>
#include <memory>

#include "base/diagnostic.h"
#include "command_options.h"
#include "option_kinds.h"

namespace stig::cli {
namespace {

/// Where the parser puts what it reads. CLI11 writes by reference while it parses, so this must
/// outlive the parser.
struct Storage {
  GlobalOptions global;
  std::string code;  ///< of a diagnostic
  /// For each command, in the order of the help, the options that were read.
  std::vector<std::function<CommandOptions()>> commands;
};

void add_global(CLI::App& app, GlobalOptions& o) {
  choice(&app, "--diagnostics", o.json_diagnostics, {{"text", false}, {"json", true}},
         "how problems in files are reported: for people, or as a JSON array");
  choice(&app, "--color", o.color,
         {{"auto", Coloured::automatic}, {"always", Coloured::always}, {"never", Coloured::never}},
         "colours in messages; auto: on a terminal, unless NO_COLOR is set");
  // CLI11 has no option "-W error" with one fixed word, hence an option with one value.
  parsed(&app, "-W", "error", "-W error: warnings count as errors",
         [&o](const std::string& text) -> std::string {
           if (text != "error") return fmt::format("'{}' is not 'error'", text);
           o.warnings_are_errors = true;
           return {};
         });
  app.add_flag("--werror", o.warnings_are_errors, "the same as -W error");
  app.add_flag("-q,--quiet", o.quiet, "no progress and no remarks on standard error");
}

template <class Options>
void declare(CLI::App& app, Storage& s, void (*add)(CLI::App&, Options&)) {
  const auto options = std::make_shared<Options>();
  add(app, *options);
  s.commands.push_back([options] { return CommandOptions(*options); });
}

// Looked for by name after parsing, as it replaces a command.
constexpr const char* kExplain = "--explain";

void build(CLI::App& app, Storage& s) {
  app.name("stigc");
  // None is an error too, but not CLI11's: the message is made below, in our words.
  app.require_subcommand(0, 1);
  app.set_help_flag("-h,--help", "this help, or that of a command, with examples");
  app.set_version_flag("--version", "stigc " STIG_VERSION, "the version of the program");
  app.add_option(kExplain, s.code,
                 "what a diagnostic's code means, with an example; without CODE: all codes")
      ->type_name("[CODE]")
      ->expected(0, 1);
  add_global(app, s.global);
  declare(app, s, add_check);
  declare(app, s, add_fmt);
  declare(app, s, add_explore);
  declare(app, s, add_explain);
  declare(app, s, add_test);
  declare(app, s, add_verify);
  declare(app, s, add_certify);
  declare(app, s, add_graph);
  declare(app, s, add_replay);
  declare(app, s, add_schema);
  declare(app, s, add_init);
  declare(app, s, add_import);
  declare(app, s, add_voxelise);
  declare(app, s, add_convex);
  declare(app, s, add_search);
  declare(app, s, add_archive);
  declare(app, s, add_measure);
  declare(app, s, add_draw);
  declare(app, s, add_synth);
  declare(app, s, add_simulate);
  declare(app, s, add_describe);
  declare(app, s, add_compile);
  declare(app, s, add_validate);
  declare(app, s, add_build);
  declare(app, s, add_sweep);
  declare(app, s, add_merge);
  declare(app, s, add_view);
  declare(app, s, add_render);
  declare(app, s, add_completions);
  declare(app, s, add_doctor);
}

// What help and completions know of an option comes from CLI11's own record of it.
OptionInfo describe(const CLI::Option& option) {
  OptionInfo info;
  for (const auto& name : option.get_snames()) info.names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) info.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) info.value = option.get_type_name();
  info.doc = option.get_description();
  // Flags expect no value, lists more than one.
  info.many = option.get_items_expected_max() > 1;
  info.required = option.get_required();
  return info;
}

/// Positional arguments first, then options in the order they were added; --help last.
std::vector<OptionInfo> describe_options(const CLI::App& app) {
  std::vector<OptionInfo> positional, named;
  for (const CLI::Option* option : app.get_options()) {
    if (option == app.get_help_ptr()) continue;
    (option->get_positional() ? positional : named).push_back(describe(*option));
  }
  positional.insert(positional.end(), named.begin(), named.end());
  if (app.get_help_ptr() != nullptr) positional.push_back(describe(*app.get_help_ptr()));
  return positional;
}

CommandInfo describe_command(const CLI::App& sub) {
  return {sub.get_name(), sub.get_description(), sub.get_footer(), describe_options(sub)};
}

/// The options of the command that was given; a command line is read once.
CommandOptions chosen(const CLI::App& app, const Storage& s) {
  const std::vector<const CLI::App*> all = app.get_subcommands({});
  const auto given = std::find(all.begin(), all.end(), app.get_subcommands().front());
  return s.commands[static_cast<std::size_t>(given - all.begin())]();
}

/// "; did you mean '--box'?" for an argument that nothing knows, or nothing.
std::string suggestion(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  // Options of the program and of the command that was given are offered, and commands where none
  // was.
  const auto add_options = [&](const CLI::App& of) {
    for (const OptionInfo& option : describe_options(of)) {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
  };
  add_options(app);
  const auto parsed_commands = app.get_subcommands();
  for (const CLI::App* sub : parsed_commands) add_options(*sub);
  if (parsed_commands.empty()) {
    for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
  }
  const std::string_view near = nearest(word, {names.begin(), names.end()});
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

/// Is there a word where a command would be? Then help of it is not to be had.
bool unknown_command(const CLI::App& app) {
  return app.get_subcommands().empty() && !app.remaining(true).empty();
}

/// Whether the program or one of its commands has this option, with a value.
bool takes_value(const CLI::App& app, const std::string& name) {
  const CLI::Option* own = app.get_option_no_throw(name);
  if (own != nullptr && own->get_items_expected_max() > 0) return true;
  const std::vector<const CLI::App*> commands = app.get_subcommands({});
  return std::any_of(commands.begin(), commands.end(), [&](const CLI::App* command) {
    const CLI::Option* option = command->get_option_no_throw(name);
    return option != nullptr && option->get_items_expected_max() > 0;
  });
}

/// The first of "--name=" without a value, or nothing. CLI11 would take the next argument for it,
/// whatever that is.
std::string left_without_value(const CLI::App& app, int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (word == "--") return {};
    if (!word.starts_with("--") || word.find('=') != word.size() - 1) continue;
    word.pop_back();
    if (takes_value(app, word)) return word;
  }
  return {};
}

std::string unknown_word(const CLI::App& app, const std::string& word, const char* unless_option) {
  const char* what = word.starts_with("-") ? "unknown option" : unless_option;
  return fmt::format("{} '{}'{}", what, word, suggestion(app, word));
}

std::string problem_in_words(const CLI::App& app, const CLI::ParseError& error) {
  // What CLI11 could not place, in the order of the command line.
  const std::vector<std::string> extra = app.remaining(true);
  if (app.get_subcommands().empty()) {
    return extra.empty() ? "a command is wanted"
                         : unknown_word(app, extra.front(), "there is no command");
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extra.empty()) {
    return unknown_word(app, extra.front(), "unexpected argument");
  }
  const std::string text = error.what();
  // CLI11 counts values, a user options: "At Most 1 required but received 2" says less than the
  // words here.
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr &&
      text.find("At Most") != std::string::npos) {
    return text.substr(0, text.find(':')) + " is given more than once";
  }
  return text;
}

}  // namespace

CommandTree command_tree() {
  CLI::App app;
  Storage storage;
  build(app, storage);
  CommandTree tree;
  tree.global = describe_options(app);
  for (const CLI::App* sub : app.get_subcommands({})) {
    tree.commands.push_back(describe_command(*sub));
  }
  return tree;
}

Parsed parse_command_line(int argc, const char* const* argv) {
  CLI::App app;
  Storage storage;
  build(app, storage);
  Parsed result;
  try {
    app.parse(argc, argv);
    if (app.count(kExplain) > 0) {
      result.explain = storage.code;
    } else if (app.get_subcommands().empty()) {
      result.problem = "a command is wanted";
    } else {
      result.command = app.get_subcommands().front()->get_name();
      // The parser's references end with this function: what was read leaves by value.
      result.line = CommandLine{storage.global, chosen(app, storage)};
    }
  } catch (const CLI::ParseError& error) {
    const auto commands = app.get_subcommands();
    if (!commands.empty()) result.command = commands.front()->get_name();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && app.count(kExplain) > 0) {
      // The code stands where the command's file would, which CLI11 then misses.
      result.explain = storage.code;  // "stigc check --explain R304": of no file
    } else if (error.get_exit_code() != 0 || unknown_command(app)) {
      result.problem = problem_in_words(app, error);
    } else {
      // Help and version are "errors" without an exit code.
      const bool version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
      result.help = version ? "stigc " STIG_VERSION "\n" : "help";
    }
  }
  const std::string bare = left_without_value(app, argc, argv);
  if (!bare.empty()) {
    Parsed refused;
    refused.problem = bare + ": a value is wanted after the =";
    refused.command = std::move(result.command);
    return refused;
  }
  return result;
}

}  // namespace stig::cli