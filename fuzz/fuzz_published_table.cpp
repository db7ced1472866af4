// SPDX-License-Identifier: MIT
// Published tables of rules: whatever is accepted prints as a file that, unless its rules
// contradict each other, reads back as the same set.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "rules/published_table.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "support/uses.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stig;
  Diagnostics diagnostics;
  auto source = std::make_shared<SourceFile>("input", std::string(data, data + size));
  std::optional<RuleSet> rules = read_published_table(std::move(source), {}, diagnostics);
  if (rules.has_value() == diagnostics.has_errors()) std::abort();
  to_text(diagnostics);
  if (!rules) return 0;
  for (Brick& brick : rules->bricks) brick.color = "#000000";
  const std::string printed = print_rule_set(*rules);
  if (printed.size() > kMaxRuleFileBytes) return 0;
  Diagnostics found;
  const auto again = read_rule_set(std::make_shared<SourceFile>("printed", printed), found);
  for (const Diagnostic& one : found.all()) {
    // What tables can get wrong is their rules' meaning, not the file's form.
    if (one.severity == Severity::error && info(one.code).name < "R300") std::abort();
  }
  if (again && !(*again == *rules)) std::abort();
  return 0;
}
