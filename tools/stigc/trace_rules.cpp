// SPDX-License-Identifier: MIT
#include "trace_rules.h"

#include "base/file_io.h"
#include "rules/rule_reader.h"

namespace stig::cli {

std::optional<std::string> trace_bytes(const std::string& path, const App& app) {
  FileError error;
  auto bytes = read_file(path, kMostTraceBytes, error);
  if (!bytes) app.complain(error.message);
  return bytes;
}

std::optional<RuleSet> rules_of(const Trace& trace, const std::string& path, const App& app) {
  Diagnostics diagnostics;
  // Diagnostics show lines of the rule set's text, under the trace's name.
  auto rules = read_rule_set(
      std::make_shared<const SourceFile>(path + " (its rule set)", trace.rule_set_yaml),
      diagnostics);
  if (diagnostics.has_errors()) {
    app.report(diagnostics);
    rules.reset();
  }
  return rules;
}

}  // namespace stig::cli
