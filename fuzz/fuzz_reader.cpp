// SPDX-License-Identifier: MIT
// Any bytes as a rule set file: diagnostics, or a rule set that prints and reads back
// the same.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "support/uses.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  stig::Diagnostics diagnostics;
  const auto rules =
      stig::read_rule_set(std::make_shared<stig::SourceFile>("input", text), diagnostics);
  require(rules.has_value() != diagnostics.has_errors());
  stig::to_text(diagnostics);
  stig::to_json(diagnostics);
  if (!rules) return 0;

  const std::string printed = stig::print_rule_set(*rules);
  // Padding can carry a file near the limit over it.
  if (printed.size() > stig::kMaxRuleFileBytes) return 0;
  stig::Diagnostics none;
  const auto again =
      stig::read_rule_set(std::make_shared<stig::SourceFile>("printed", printed), none);
  require(again.has_value() && *again == *rules);
  require(stig::print_rule_set(*again) == printed);
  require(again->comments.size() == rules->comments.size());
  return 0;
}
