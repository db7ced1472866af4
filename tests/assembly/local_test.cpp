// SPDX-License-Identifier: MIT
// The proof column by column against a walk over all structures.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "assembly/assemble.h"
#include "assembly/targets.h"
#include "compiler/columns.h"
#include "compiler/concurrent.h"
#include "compiler/lattice_walk.h"
#include "compiler/local_policy.h"
#include "compiler/local_situations.h"
#include "support/small_sets.h"
#include "support/uses.h"

namespace stig {
namespace {

bool closed(const Precedence& precedence, const BrickSet& state) {
  for (std::size_t i = 0; i < precedence.bricks(); ++i) {
    if (state.has(i) && !state.contains(precedence.below(i))) return false;
  }
  return true;
}

/// Is each column that a robot can come to in the structure one of the situations?
void check_covered(const TargetStates& target, const LocalSituations& local, const BrickSet& state,
                   ApproachSide side) {
  const BrickSet none(target.bricks());
  for (const auto& [v, u] : columns_before(target, state, side)) {
    std::size_t met = 0, most = 100'000;
    REQUIRE(local.for_each(side, u, v, none, none, most, [&](const LocalSituation& at) {
      met += state.contains(at.least) && at.most.contains(state) ? 1 : 0;
    }));
    CHECK(met == 1);
  }
}

/// What rules allow, whatever robots do, lies within the precedence and its situations.
void check_structures(const RuleSet& rules) {
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(rules, paper_robot(), {}, diagnostics);
  REQUIRE(compiled.target);
  const TargetStates& target = *compiled.target;
  const Precedence precedence = precedence_of(target);
  Sight sight(target, paper_robot());
  const LocalSituations local(target, precedence, sight);
  std::set<BrickSet> known = {target.start()};
  std::vector<BrickSet> todo = {target.start()};
  while (!todo.empty()) {
    const BrickSet state = todo.back();
    todo.pop_back();
    REQUIRE(closed(precedence, state));
    for (const ApproachSide side : kAllSides) check_covered(target, local, state, side);
    for (const std::uint32_t brick : target.open(state)) {
      BrickSet next = state;
      next.add(brick);
      if (known.insert(next).second) todo.push_back(next);
    }
  }
}

/// What is proved column by column holds for one robot and, where it says so, for any number.
void check_proof(const RuleSet& rules, CompiledRules& compiled) {
  const TargetStates& target = *compiled.target;
  LatticeWalk walk{rules, compiled};
  walk.walk({rules.start.begin(), rules.start.end()});
  REQUIRE(walk.ends.size() == 1);
  CHECK(walk.ends.begin()->size() == target.bricks());
  if (!compiled.concurrency.conflicts.empty()) return;
  Policy all = explore(target, paper_robot(), compiled.sides, {PlacementKinds::all, true}, {});
  all.complete = true;  // by the proof
  const Concurrency crew = check_concurrency(target, paper_robot(), all, *compiled.decision);
  CHECK(crew.conflicts.empty());
}

TEST_CASE("what stands is closed, and what a robot can meet is one of the situations") {
  for (const char* name : {"staircase", "stepped-pyramid"}) check_structures(shipped(name));
  for (const char* name : {"line", "column", "plate", "wall", "u", "plus"}) {
    check_structures(rule_set(STIG_TESTS_DIR "/compiler/" + std::string(name) + ".yaml"));
  }
}

TEST_CASE("shipped sets that are proved column by column complete") {
  int proved = 0;
  for (const char* name : {"line", "column", "plate", "wall", "u", "plus"}) {
    CAPTURE(name);
    const RuleSet rules = rule_set(STIG_TESTS_DIR "/compiler/" + std::string(name) + ".yaml");
    Diagnostics diagnostics;
    CompiledRules compiled = compile_rules(rules, paper_robot(), {}, diagnostics);
    REQUIRE(compiled.decision);
    if (!settle_locally(paper_robot(), {}, compiled)) continue;
    ++proved;
    CHECK(compiled.local_situations > 0);
    check_proof(rules, compiled);
  }
  CHECK(proved >= 3);
}

TEST_CASE("rules for targets by chance, proved column by column, complete too") {
  int proved = 0;
  CHECK(rc::check([&] {
    const auto kind = *rc::gen::elementOf(
        std::vector<std::string_view>(kTargetKinds.begin(), kTargetKinds.end()));
    AssemblyTask task;
    task.target = drawn_target(kind, *rc::gen::inRange<std::uint64_t>(1, 1000));
    RC_PRE(task.target.cells.size() <= 8U);
    task.robot = paper_robot();
    task.wording.name = "target";
    Assembly made = assemble(task, 0.02);
    RC_PRE(made.plan.has_value());
    if (!settle_locally(task.robot, {}, made.plan->compiled)) return;
    ++proved;
    check_proof(*made.plan->rules, made.plan->compiled);
  }));
  CHECK(proved > 50);
}

Target solid(int wide, int deep, int high) {
  Target out;
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) {
      for (int z = 0; z < high; ++z) out.cells.push_back({x, y, z});
    }
  }
  out.colours.assign(out.cells.size(), StateSet::anything());
  return out;
}

/// Rules are found that any number of robots can follow; returns how many there are.
std::size_t check_assembled(int wide, int deep, int high) {
  AssemblyTask task;
  task.target = solid(wide, deep, high);
  task.robot = paper_robot();
  task.wording.name = "large";
  const Assembly made = assemble(task, 1);
  REQUIRE(made.plan);
  CHECK(made.plan->any_number);
  CHECK(made.plan->compiled.local_situations > 0);
  CHECK(made.plan->work.size() + 1 == task.target.cells.size());
  return made.plan->rules->rules.size();
}

TEST_CASE("a wall and a plate that no walk gets through are compiled, for any number of robots") {
  check_assembled(12, 1, 3);
  check_assembled(7, 7, 1);
}

TEST_CASE("a wall, plates and a slab of more than 200 bricks are compiled at small effort") {
  check_assembled(68, 1, 3);
  check_assembled(12, 12, 2);
  // Rows beside the spine share their rules: a plate of 576 bricks takes few more than one of 400.
  CHECK(check_assembled(20, 20, 1) < 120);
  CHECK(check_assembled(24, 24, 1) < 130);
}

TEST_CASE("plates too wide for a spine in four colours are counted, by rules that hardly grow") {
  CHECK(check_assembled(30, 70, 1) < 140);
  CHECK(check_assembled(66, 65, 1) < 150);
}

/// Of the bricks that three rules put, and two more by the rules given, whether the one at `below`
/// comes before that at `above` in every order.
bool comes_before(const std::string& more, Cell below, Cell above) {
  const RuleSet rules = small_set(R"(  - name: first
    place: 2
    when: |
      . . .   . . .   . . .
      . . .   1 * .   . . .
      . . .   . . .   . . .
  - name: second
    place: 3
    when: |
      . . .   . . .   . . .
      . . .   . * .   . . .
      . . .   1 2 .   . . .
  - name: third
    place: 2
    when: |
      . . .   . . .   . . .
      . . .   3 * .   . . .
      . . .   2 . .   . . .
)" + more);
  const VerifyResult proof = verify::verify(rules, {});
  REQUIRE(proof.verdict == ProofVerdict::proved);
  const TargetStates target(rules, proof);
  REQUIRE(target.bricks() == 5);
  return precedence_of(target).below(target.brick_at(above)).has(target.brick_at(below));
}

TEST_CASE("a rule that never fires does not hide what another demands") {
  // The last rule would put the same brick without its western and northern neighbours, but the
  // northwestern one never stands without the western.
  CHECK(comes_before(R"(  - name: fourth
    place: 1
    when: |
      . . .   3 2 .   . . .
      . . .   2 * .   . . .
      . . .   . . .   . . .
  - name: never
    place: 1
    when: |
      . . .   3 . .   . . .
      . . .   . * .   . . .
      . . .   . . .   . . .
)",
                     {2, 1, 0}, {2, 0, 0}));
}

TEST_CASE("a rule that asks for a brick that comes later does not hide what another demands") {
  // The last rule would put the third's brick without its western neighbour, but asks for the
  // fourth's, which waits for it.
  CHECK(comes_before(R"(  - name: fourth
    place: 1
    when: |
      . . .   ? 2 .   . . .
      . . .   2 * .   . . .
      . . .   . . .   . . .
  - name: never
    place: 2
    when: |
      . . .   . . .   . . .
      . . .   . * .   . . .
      . . .   2 1 .   . . .
)",
                     {1, 1, 0}, {2, 1, 0}));
}

}  // namespace
}  // namespace stig
