// SPDX-License-Identifier: MIT
// The shipped rule sets, for tests.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "rules/rule_reader.h"

namespace stig::support {

/// rulesets/NAME.yaml; fails the test with its diagnostics if it cannot be read.
inline RuleSet shipped(const std::string& name) {
  Diagnostics diagnostics;
  auto rules = read_rule_set_file(STIG_SOURCE_DIR "/rulesets/" + name + ".yaml", diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(rules.has_value());
  return *std::move(rules);
}

}  // namespace stig::support
