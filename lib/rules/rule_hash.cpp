// SPDX-License-Identifier: MIT
// The hash of a rule set's meaning, by which certificates and traces name the set that they
// belong to. Its value is part of their formats: what is fed in, and in which order, cannot
// change. Both follow the lists of members beside the structs (rule_set.h, rule.h), so moving
// an entry there breaks every certificate in use; Hashed::when_set (key_field.h) is the way to
// add one.
#include "rules/field_hash.h"
#include "rules/rule_printer.h"

namespace stig::rules {

std::uint64_t rule_set_hash(const RuleSet& rules) {
  FieldHash hash(neighbourhood(rules.lattice).size);
  hash.add(rules);
  return hash.value();
}

}  // namespace stig::rules
