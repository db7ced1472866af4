// SPDX-License-Identifier: MIT
#include "trace_rules.h"

#include "rules/rule_reader.h"

namespace stig {

std::optional<RuleSet> rules_of(const Trace& trace, const std::string& path, const App& app) {
  Diagnostics diagnostics;
  auto rules = read_rule_set(
      // Diagnostics point into the trace, which has no lines of its own to show.
      std::make_shared<const SourceFile>(path + " (its rule set)", trace.rule_set_yaml),
      diagnostics);
  if (diagnostics.has_errors()) {
    app.report(diagnostics);
    rules.reset();
  }
  return rules;
}

}  // namespace stig
