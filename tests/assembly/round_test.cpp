// SPDX-License-Identifier: MIT
// Closed chains of columns: where they begin and end, and rules for rings.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "assembly/assemble.h"
#include "assembly/likings.h"
#include "assembly/path.h"
#include "compiler/lattice_walk.h"
#include "lattice/structure_text.h"
#include "support/uses.h"

namespace stig {
namespace {

TargetBricks bricks_of(std::string_view drawn) { return {structure_literal(drawn).bricks(), 0}; }

/// Places about each of its bends, with the bend as the last.
std::size_t rounds(std::string_view drawn) { return round_likings(bricks_of(drawn)).size(); }

AssemblyTask ring_task(int wide, int deep, int levels) {
  AssemblyTask out;
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) {
      if (x > 0 && x < wide - 1 && y > 0 && y < deep - 1) continue;
      for (int z = 0; z < levels; ++z) out.target.cells.push_back({x, y, z});
    }
  }
  out.target.colours.assign(out.target.cells.size(), StateSet::anything());
  out.robot = paper_robot();
  out.robots = 1;
  out.wording.name = "ring";
  return out;
}

TEST_CASE("steps go round a ring, not through the last column, which is farther than all others") {
  const TargetBricks ring = bricks_of(". . .\n. . .\n1 1 .\n---\n1 1 1\n1 . 1\n1 1 1\n");
  const Cell first{1, 0, 0}, last{0, 0, 0};
  const std::vector<int> steps = steps_from(ring, first, last);
  const auto at = [&](Cell cell) { return steps[ring.brick_at(cell)]; };
  CHECK(at(first) == 0);
  CHECK(at({2, 2, 0}) == 3);
  CHECK(at({0, 1, 0}) == 6);
  CHECK(at(last) == 7);
  CHECK(at({0, 0, 1}) == 7);
  // What lies on the first is in the way of the last, and comes after it.
  CHECK(at({1, 0, 1}) == 7);
}

TEST_CASE("what closes at a bend is gone round, from both sides of it; what has no hole is not") {
  CHECK(rounds("1 1 1\n1 . 1\n1 1 1\n") == 8);
  CHECK(rounds("1 . .\n. . .\n. . .\n---\n1 1 1\n1 . 1\n1 1 1\n") == 16);
  // The letter B has two holes, and P one and a stem.
  CHECK(rounds("1 1 1\n1 . 1\n1 1 1\n1 . 1\n1 1 1\n") == 8);
  CHECK(rounds("1 1 1\n1 . 1\n1 1 1\n1 . .\n1 . .\n") == 6);
  CHECK(rounds("1 1 1\n1 . .\n1 1 1\n") == 0);
  CHECK(rounds("1 1 1 1 1\n") == 0);
  CHECK(rounds("1 1\n1 1\n") == 0);
  CHECK(rounds("1 1 1 1\n1 1 1 1\n1 1 . 1\n1 1 1 1\n") == 2);
}

TEST_CASE("rings are found, and robots complete them") {
  CHECK(rc::check([] {
    const int wide = *rc::gen::inRange(3, 6), deep = *rc::gen::inRange(3, 6);
    const AssemblyTask task = ring_task(wide, deep, 1);
    const Assembly made = assemble(task, 1);
    RC_ASSERT(made.plan);
    check_completes(*made.plan->rules);
  }));
  for (const auto& [wide, deep] : {std::pair(4, 3), {6, 4}, {6, 6}, {9, 5}}) {
    CAPTURE(wide);
    CAPTURE(deep);
    // Some have rules for one robot alone, so others are looked for until the effort is used up.
    CHECK(assemble(ring_task(wide, deep, 2), 0.05).plan);
  }
}

}  // namespace
}  // namespace stig
