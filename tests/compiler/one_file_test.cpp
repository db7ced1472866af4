// SPDX-License-Identifier: MIT
// One rule file, two structures: what robots build that follow it from one side, and from four.
#include <doctest/doctest.h>

#include <algorithm>

#include "certify/check.h"
#include "compiler/decision_text.h"
#include "rules/rule_printer.h"
#include "rules/worked_from.h"
#include "support.h"
#include "support/uses.h"

namespace stig {
namespace {

/// In order, and moved so that the first is in the origin.
std::vector<PlacedBrick> sorted(std::vector<PlacedBrick> bricks) {
  std::sort(bricks.begin(), bricks.end());
  const Offset off = bricks.front().at - Cell{0, 0, 0};
  for (PlacedBrick& brick : bricks) brick.at = brick.at + Offset{-off.x, -off.y, -off.z};
  return bricks;
}

/// What is proved to stand in the end, by the compiler, and by the checker of certificates.
std::vector<PlacedBrick> built(const RuleSet& rules, const std::vector<ApproachSide>& sides,
                               std::string& decision) {
  CompileOptions options;
  options.sides = sides;
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(rules, paper_robot(), options, diagnostics);
  REQUIRE_MESSAGE(compiled.decision, to_text(diagnostics));
  CHECK(compiled.concurrency.conflicts.empty());
  REQUIRE(compiled.proof.certificate);
  const CheckReport checked = check_certificate(rules, *compiled.proof.certificate, std::nullopt);
  REQUIRE(checked.accepted);
  decision = decision_text(rules, *compiled.decision);
  CHECK(sorted(checked.structure) == sorted(compiled.proof.structure->bricks()));
  return sorted(checked.structure);
}

TEST_CASE("the rules of the pyramid, worked from one side, are the staircase") {
  const RuleSet file = shipped("stepped-pyramid"), staircase = shipped("staircase");
  std::string decision, staircase_decision;
  const RuleSet from_x = worked_from(file, {"+x"});
  const auto steps = built(from_x, {ApproachSide::plus_x}, decision);
  CHECK(steps == sorted(staircase.expect->structure));
  CHECK(steps == built(staircase, {}, staircase_decision));
  CHECK(decision == staircase_decision);
  // A certificate for the one is one for the other.
  CHECK(rule_set_hash(from_x) == rule_set_hash(staircase));

  const auto pyramid = built(file, {}, decision);
  CHECK(pyramid.size() == 15);
  CHECK(pyramid == sorted(file.expect->structure));
  CHECK(decision != staircase_decision);

  const auto two = built(worked_from(file, {"+x", "-y"}),
                         {ApproachSide::plus_x, ApproachSide::minus_y}, decision);
  CHECK(two.size() == 9);
}

}  // namespace
}  // namespace stig
