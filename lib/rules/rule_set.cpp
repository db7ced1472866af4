// SPDX-License-Identifier: MIT
#include "rules/rule_set.h"

#include <algorithm>
#include <cassert>

#include "base/led_name.h"

namespace stig::rules {
Colour RuleSet::colour_of(std::string_view symbol) const {
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    if (bricks[i].symbol == symbol) return static_cast<Colour>(i + 1);
  }
  return 0;
}

/// Gaps in the numbers are reported by the checks; here the highest counts.
int RuleSet::highest_kind() const {
  int out = 0;
  for (const Brick& brick : bricks) out = std::max(out, kind_named(brick.led).value_or(0));
  return out;
}

int RuleSet::stage_count() const {
  int highest = 1;
  for (const Rule& rule : rules) highest = std::max(highest, rule.stage);
  return highest;
}

// Equality compares what a file says and not where it says it: the members that are ranges are
// not among those listed.
bool operator==(const RuleSet& a, const RuleSet& b) { return same_fields(a, b); }

std::string_view to_string(Conflicts conflicts) {
  switch (conflicts) {
    case Conflicts::error:
      return "error";
    case Conflicts::random:
      return "random";
    case Conflicts::first:
      return "first";
  }
  assert(false);
  return "";
}

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::coordinated:
      return "coordinated";
    case Verdict::order_dependent:
      return "order-dependent";
    case Verdict::endless:
      return "endless";
  }
  assert(false);
  return "";
}

}  // namespace stig::rules
