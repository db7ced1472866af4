// SPDX-License-Identifier: MIT
#include "rules/field_hash.h"
#include "rules/rule_printer.h"

namespace stig {

std::uint64_t rule_set_hash(const RuleSet& rules) {
  FieldHash hash(neighbourhood(rules.lattice).size);
  hash.add(rules);
  return hash.value();
}

}  // namespace stig
