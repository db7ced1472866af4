// SPDX-License-Identifier: MIT
// Skeletons and fills: few rules with heights, each set held to the verifier.
#include "synthesis/by_skeleton.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "synthesis/emit.h"
#include "synthesis/scaffold.h"
#include "synthesis/shapes.h"
#include "synthesis/skeleton_rules.h"
#include "verify/verify.h"

namespace stig {
namespace {

RuleSet rules_of(const Solution& s) {
  return make_rule_set(*s.frame, s.colours, s.colour_count, {}, s.rules,
                       {"made", "made", "a test"});
}

/// The verifier proves that every order of events ends in the target; the file is read back.
void check_proved(const Solution& s, const Target& target) {
  const RuleSet rules = rules_of(s);
  const VerifyResult result = verify::verify(rules, {});
  CHECK(result.verdict == ProofVerdict::proved);
  REQUIRE(result.structure);
  std::vector<Cell> cells;
  for (const PlacedBrick& b : result.structure->bricks()) cells.push_back(b.at);
  CHECK(cells == target.cells);
  Diagnostics diagnostics;
  const auto again =
      read_rule_set(std::make_shared<SourceFile>("made.yaml", print_rule_set(rules)), diagnostics);
  CAPTURE(to_text(diagnostics));
  CHECK(diagnostics.all().empty());
  CHECK(again);
}

TEST_CASE("a column takes one colour and one rule, whatever its height") {
  for (const int height : {2, 8, 19, 30, 90}) {
    for (const bool floor : {false, true}) {
      CAPTURE(height);
      SynthesisOptions options;
      options.floor = floor;
      const Target target = box({1, 1, height});
      const Synthesis result = synthesise(target, options);
      REQUIRE(result.best);
      CHECK(result.best->colour_count == 1);
      CHECK(result.best->rules.size() == 1);
      check_proved(*result.best, target);
    }
  }
}

TEST_CASE("a cube takes five rules, whatever its side") {
  for (const int side : {3, 5, 8, 12}) {
    CAPTURE(side);
    const Target target = box({side, side, side});
    const auto solution = solve_by_skeleton(target, {}, {});
    REQUIRE(solution);
    CHECK(solution->rules.size() == 5);
    check_proved(*solution, target);
  }
  const Synthesis large = synthesise(box({12, 12, 12}), {});
  REQUIRE(large.best);
  CHECK(large.best->rules.size() == 5);
}

TEST_CASE("a pyramid grows from its top with one colour") {
  const Target target = pyramid(6);
  const auto solution = solve_by_skeleton(target, {}, {});
  REQUIRE(solution);
  CHECK(solution->colour_count == 1);
  check_proved(*solution, target);
}

/// A tower, an L, lying or standing, or a box, of random measures.
Target random_solid(Random& random) {
  const auto upto = [&](int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low + 1)));
  };
  const int wide = upto(1, 3), high = upto(2, 14), arm = upto(2, 6), kind = upto(0, 3);
  if (kind == 0) return box({2, 2, high});
  if (kind == 1) return box({upto(2, 6), upto(2, 6), upto(2, 6)});
  if (kind == 2) {
    return carved({wide + arm, 2, high}, [=](Cell c) { return c.x < wide || c.z == 0; });
  }
  return carved({wide + arm, wide + arm, high}, [=](Cell c) { return c.x < wide || c.y < wide; });
}

TEST_CASE("rule sets with heights for unseen solids build them in every order") {
  int with_heights = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    Random random(seed, 0, Purpose::test, 0, 0);
    const Target target = random_solid(random);
    SynthesisOptions options;
    options.floor = seed % 2 == 0;
    const auto solution = solve_by_skeleton(target, options, {});
    if (!solution) continue;
    ++with_heights;
    check_proved(*solution, target);
  }
  CHECK(with_heights >= 25);
}

TEST_CASE("rules with heights that were tampered with are refused") {
  const Target target = box({4, 4, 4});
  const auto grid = make_solid_grid(target, false);
  REQUIRE(grid);
  const std::int32_t start = grid->place_of({0, 0, 0});
  const std::vector<Fill> fills = safe_fills(*grid, 2, {});
  const auto skeleton = find_skeleton(*grid, start, fills, {});
  REQUIRE(skeleton);
  const auto made = make_skeleton_rules(*grid, *skeleton, false, {});
  REQUIRE(made);
  CHECK(order_of_growth(*grid, made->colours, start, made->rules, {}));
  for (std::size_t k = 0; k < made->rules.size(); ++k) {
    std::vector<MergedRule> rules = made->rules;
    rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(k));
    CHECK_FALSE(order_of_growth(*grid, made->colours, start, rules, {}));
    rules = made->rules;
    rules[k].place = static_cast<Colour>(rules[k].place % made->colour_count + 1);
    CHECK_FALSE(order_of_growth(*grid, made->colours, start, rules, {}));
    rules = made->rules;
    rules[k].pattern = Pattern();
    rules[k].height_min = rules[k].height_max = std::nullopt;
    CHECK_FALSE(order_of_growth(*grid, made->colours, start, rules, {}));
  }
}

TEST_CASE("the longest run is found in any direction") {
  CHECK(longest_run(box({1, 7, 3})).size() == 7);
  CHECK(longest_run(box({130, 1, 1})).size() == 130);
}

}  // namespace
}  // namespace stig
