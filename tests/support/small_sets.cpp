// SPDX-License-Identifier: MIT
#include "support/small_sets.h"

#include <doctest/doctest.h>

#include "rules/rule_reader.h"
#include "support/uses.h"

namespace stig {

RuleSet small_set(const std::string& rules, const std::string& head) {
  const auto unless = [&](const std::string& key, const std::string& text) {
    return ("\n" + head).find("\n" + key + ":") == std::string::npos ? text : std::string();
  };
  const std::string text =
      "stigc: 1\nname: small\n" + unless("lattice", "lattice: cubic\n") +
      unless("symmetry", "symmetry: none\n") +
      unless("bricks",
             "bricks:\n  1: {name: one, color: \"#e6194b\"}\n"
             "  2: {name: two, color: \"#3cb44b\"}\n  3: {name: three, color: \"#4363d8\"}\n") +
      unless("start", "start:\n  - {at: [0, 0, 0], brick: 1}\n") + head + "rules:\n" + rules;
  Diagnostics diagnostics;
  const auto set =
      read_rule_set(std::make_shared<const SourceFile>("small.yaml", text), diagnostics);
  REQUIRE_MESSAGE(set.has_value(), to_text(diagnostics));
  return *set;
}

std::string east_of(const std::string& west, const std::string& brick, const std::string& more) {
  return "  - name: " + brick + " east of " + west + "\n    place: " + brick + "\n" + more +
         "    when: |\n      ? ? ?   ? ? ?   ? ? ?\n      ? ? ?   " + west +
         " * ?   ? ? ?\n      ? ? ?   ? ? ?   ? ? ?\n";
}

}  // namespace stig
