// SPDX-License-Identifier: MIT
// stigc fmt: the canonical form of rule set files.
//
// Formatting is reading and printing: a file with errors has no canonical form and is left alone.
#include <fmt/format.h>

#include "base/file_guard.h"
#include "base/file_io.h"
#include "commands.h"
#include "rules/rule_printer.h"

namespace stig::cli {
namespace {

/// Prints, rewrites or compares one file; returns an exit code.
int format(const std::string& file, const FmtOptions& options, App& app) {
  const std::optional<RuleSet> rules = app.read_rules(file);
  if (!rules) return kFailed;
  const std::string text = print_rule_set(*rules);
  if (!options.write && !options.check) {
    app.print(text);
    return kOk;
  }
  // A file that is in canonical form already is not touched, so its time of change stays.
  if (rules->file && rules->file->text() == text) return kOk;
  if (options.check) {
    // Names alone, as lists for other programs.
    app.print(file + "\n");
    return kFailed;
  }
  // The guard of files would refuse, since the file was read; here that is the purpose.
  let_replace(file);
  FileError error;
  if (!write_file(file, text, error)) {
    app.complain(error.message);
    return kRunFailed;
  }
  app.say("rewrote " + printable(file));
  return kOk;
}

}  // namespace

int run(const FmtOptions& options, App& app) {
  if (!options.write && !options.check && options.files.size() > 1) {
    app.complain("several files are formatted with --write or --check");
    return kUsage;
  }
  int code = kOk;
  for (const std::string& file : options.files) {
    if (options.write && file == "-") {
      app.complain("standard input cannot be rewritten in place");
      return kUsage;
    }
    code = std::max(code, format(file, options, app));
  }
  return code;
}

}  // namespace stig::cli
