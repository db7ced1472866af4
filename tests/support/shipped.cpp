// SPDX-License-Identifier: MIT
#include "support/shipped.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "rules/rule_reader.h"
#include "support/uses.h"

namespace stig {

RuleSet shipped(const std::string& name) {
  Diagnostics diagnostics;
  auto rules =
      read_rule_set_file(std::string(STIG_SOURCE_DIR) + "/rulesets/" + name + ".yaml", diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(rules.has_value());
  return *std::move(rules);
}

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(STIG_SOURCE_DIR) + "/rulesets")) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace stig
