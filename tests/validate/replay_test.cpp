// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "rules/rule_reader.h"
#include "support/uses.h"
#include "validate/replay_events.h"

namespace stig {
namespace {

/// What is said against a Q2 beside the start, of rules whose one for Q2 has this key too.
std::string against(const std::string& key) {
  const std::string text =
      "stigc: 1\nname: t\nlattice: cubic\nsymmetry: none\nfloor: true\n"
      "bricks:\n  1: {name: Q1, color: \"#e6194b\", led: Q1}\n"
      "  2: {name: Q2, color: \"#3cb44b\", led: Q2}\n"
      "start:\n  - {at: [0, 0, 0], brick: 1}\n"
      "rules:\n"
      "  - name: beside\n    place: 2\n    when: |\n"
      "      ? ? ?   ? ? ?   ? ? ?\n      ? ? ?   1 * ?   ? ? ?\n      ? ? ?   ? ? ?   ? ? ?\n"
      "    " +
      key +
      "\n  - name: above\n    place: 2\n    when: |\n"
      "      ? ? ?   ? ? ?   ? ? ?\n      ? ? ?   ? * ?   ? 1 ?\n      ? ? ?   ? ? ?   ? ? ?\n";
  Diagnostics diagnostics;
  const auto rules = read_rule_set(std::make_shared<const SourceFile>("t.yaml", text), diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(rules);
  BuildTarget target;
  target.rules = &*rules;
  BrickEvent event;
  event.cell = {1, 0, 0};
  event.led = led_of(*rules, 2);
  const Replayed replayed = replay_events(target, {event});
  REQUIRE(replayed.against);
  return replayed.against->reason;
}

bool ends(const std::string& text, const std::string& how) {
  INFO(text);
  return text.ends_with("the nearest rule, 'beside', " + how);
}

TEST_CASE("a placement against the rules names the condition that fails, whichever it is") {
  CHECK(ends(against("stage: 2"), "is not for stage 1"));
  CHECK(ends(against("height: {min: 1}"), "is not for height 0"));
  CHECK(ends(against("count: [{of: [1], among: all, min: 2}]"), "counts 1 neighbour of 1"));
  CHECK(ends(against("count: [{of: [1], among: faces, min: 2}]"),
             "counts 1 neighbour at its faces of 1"));
}

}  // namespace
}  // namespace stig
