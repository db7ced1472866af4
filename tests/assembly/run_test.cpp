// SPDX-License-Identifier: MIT
// Runs that so few colours do not do for: held to what a solver of other rules finds.
#include "assembly/run.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "assembly/targets.h"
#include "compiler/support.h"
#include "lattice/structure_text.h"
#include "support/uses.h"
#include "synthesis/synthesise.h"

namespace stig {
namespace {

TargetBricks drawn(std::string_view text) { return {structure_literal(text).bricks(), 0}; }

std::vector<FreeRun> too_long(std::string_view text, int colours,
                              std::optional<Cell> start = std::nullopt) {
  const TargetBricks target = drawn(text);
  const auto brick = start ? std::optional(target.brick_at(*start)) : std::nullopt;
  return runs_too_long(target, brick, colours);
}

TEST_CASE("a line of one brick less than twice the colours may do, a longer one does not") {
  CHECK(too_long("1 1 1 1 1 1 1\n", 4).empty());
  CHECK(too_long("1 1 1 1 1 1 1 1\n", 4).size() == 1);
  CHECK(too_long("1 1 1 1 1\n", 3).empty());
  CHECK_FALSE(too_long("1 1 1 1 1 1\n", 3).empty());
  CHECK(too_long("1 1 1 1 1 1 1\n", 4, Cell{3, 0, 0}).empty());
  CHECK_FALSE(too_long("1 1 1 1 1 1 1\n", 4, Cell{2, 0, 0}).empty());
}

TEST_CASE("what stands beside a run, or before its free end, tells its bricks apart") {
  CHECK(too_long("1 1 1 1 1 1 1 1\n. . . 1 . . . .\n", 4).empty());
  CHECK(too_long("1 1 1 1 1 1 1 1 . 1\n1 1 . . . . . . . 1\n1 1 1 1 1 1 1 1 1 1\n", 4).empty());
  // Of two arms one may hold the start.
  CHECK(too_long("1 1 1 1 1 1 1\n1 1 . . . . .\n", 4).empty());
  const auto runs = too_long("1 1 1 1 1 1 1\n1 1 . . . . .\n1 1 1 1 1 1 1\n", 4);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].front() == Cell{2, 0, 0});
  CHECK(runs[0].back() == Cell{6, 0, 0});
}

TEST_CASE("whatever rules are found, no run was too long for their colours") {
  int made = 0;
  CHECK(rc::check([&] {
    const auto kind = *rc::gen::element<std::string_view>("letter", "ring", "wall", "height map");
    const Target target = drawn_target(kind, *rc::gen::inRange<std::uint64_t>(1, 1000));
    RC_PRE(target.cells.size() <= 14U);
    SynthesisOptions options;
    options.heights = false;
    options.effort = 0.01;
    options.start = {*rc::gen::elementOf(target.cells)};
    const Synthesis found = synthesise(target, options);
    if (!found.best) return;
    ++made;
    std::vector<PlacedBrick> bricks;
    for (const Cell cell : target.cells) bricks.push_back({cell, 1});
    const TargetBricks whole(bricks, 0);
    const int colours = found.best->colour_count;
    RC_ASSERT(runs_too_long(whole, std::nullopt, colours).empty());
    RC_ASSERT(runs_too_long(whole, whole.brick_at(options.start.front()), colours).empty());
  }));
  CHECK(made > 50);
}

}  // namespace
}  // namespace stig
