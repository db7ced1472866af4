// SPDX-License-Identifier: MIT
// The claim for several robots against two and three of them, every interleaving walked.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <set>

#include "crew_oracle.h"
#include "support/uses.h"

namespace stig {
namespace {

struct Checked {
  RuleSet rules;
  Diagnostics diagnostics;
  CompiledRules compiled;

  explicit Checked(RuleSet set, std::optional<int> robots = 1, std::size_t states = 100'000)
      : rules(std::move(set)) {
    CompileOptions options;
    options.robots = robots;
    options.limits.states = states;
    compiled = compile_rules(rules, paper_robot(), options, diagnostics);
  }
  /// The tree as it was before a smaller one was looked for, which may leave less to be decided.
  void take_first_tree() {
    const Abilities robot = paper_robot();
    compiled.policy =
        explore(*compiled.target, robot, compiled.sides, {PlacementKinds::ahead, false});
    compiled.decision = settle(*compiled.target, compiled.policy);
    if (!compiled.decision) return;
    compiled.concurrency =
        check_concurrency(*compiled.target, robot, compiled.policy, *compiled.decision);
  }
  std::set<ConflictKind> conflicts() const {
    std::set<ConflictKind> out;
    for (const Conflict& one : compiled.concurrency.conflicts) out.insert(one.kind);
    return out;
  }
};

std::string names(const std::set<ConflictKind>& kinds) {
  std::string out;
  for (const ConflictKind kind : kinds) out += std::string(to_string(kind)) + " ";
  return out;
}

/// What a crew meets is what the check says.
void check_against_crew(const Checked& one, std::size_t robots) {
  REQUIRE(one.compiled.decision);
  const Crew crew(one.rules, one.compiled, robots);
  CAPTURE(robots);
  CHECK(names(crew.failures) == names(one.conflicts()));
  CHECK(crew.whole.size() == 1);
}

TEST_CASE("any number of robots may build the staircase, the pyramid, a line and a column") {
  for (const RuleSet& rules : {shipped("staircase"), rule_set(STIG_TESTS_DIR "/compiler/line.yaml"),
                               rule_set(STIG_TESTS_DIR "/compiler/column.yaml")}) {
    CAPTURE(rules.name);
    const Checked one(rules);
    CHECK(one.conflicts().empty());
    check_against_crew(one, 2);
    check_against_crew(one, 3);
  }
  const Checked pyramid(shipped("stepped-pyramid"));
  CHECK(pyramid.conflicts().empty());
  CHECK(!pyramid.compiled.concurrency.ways_cross);
  check_against_crew(pyramid, 2);
}

TEST_CASE("two robots lock each other where one would not") {
  const Checked lock(rule_set(STIG_TESTS_DIR "/compiler/refused/P713-lock.yaml"));
  CHECK(lock.diagnostics.all().empty());
  CHECK(lock.conflicts() == std::set{ConflictKind::stuck, ConflictKind::barred});
  check_against_crew(lock, 3);
  CHECK(Crew(lock.rules, lock.compiled, 2).failures.contains(ConflictKind::stuck));
  // One after the other does it.
  const Crew alone(lock.rules, lock.compiled, 1);
  CHECK(alone.failures.empty());
  CHECK(alone.whole.size() == 1);
  // The brick that was one too many, and what it stood beside when it was decided on.
  const Conflict& stuck = lock.compiled.concurrency.conflicts.front();
  REQUIRE(stuck.placed);
  CHECK(lock.compiled.policy.states[stuck.state].count() == 3);
  CHECK(lock.compiled.policy.states[stuck.decided_in].count() == 1);
  CHECK(lock.compiled.target->cell(stuck.placed->brick).z == 0);
}

TEST_CASE("a robot is walled in by another's work, which is a warning where one may be meant") {
  const std::string file = STIG_TESTS_DIR "/compiler/conflicts/walled.yaml";
  const Checked walled(rule_set(file));
  CHECK(walled.conflicts() == std::set{ConflictKind::walled_in});
  check_against_crew(walled, 2);
  check_against_crew(walled, 3);
  // From two sides robots cannot wait for each other in a circle; from three they might.
  CHECK(!walled.compiled.concurrency.ways_cross);
  RuleSet wider = walled.rules;
  wider.physical->sides.emplace_back("-x");
  wider.start.push_back({{4, -3, 0}, 1});  // hides the arm's foot from -x
  const Checked three(wider);
  REQUIRE(three.compiled.decision);
  CHECK(three.compiled.concurrency.ways_cross);
  const Checked unsaid(rule_set(file), std::nullopt);
  CHECK(unsaid.compiled.decision);
  REQUIRE(unsaid.diagnostics.all().size() == 1);
  CHECK(unsaid.diagnostics.all()[0].code == Code::P714);
  const Checked two(rule_set(file), 2);
  CHECK(!two.compiled.decision);
  REQUIRE(two.diagnostics.all().size() == 1);
  CHECK(two.diagnostics.all()[0].code == Code::P713);
}

TEST_CASE("what was right once is no longer wanted") {
  Checked outdated(rule_set(STIG_TESTS_DIR "/compiler/conflicts/outdated.yaml"));
  CHECK(outdated.conflicts().empty());
  outdated.take_first_tree();
  CHECK(outdated.conflicts() == std::set{ConflictKind::outdated, ConflictKind::barred});
  check_against_crew(outdated, 2);
  check_against_crew(outdated, 3);
}

TEST_CASE("in a ring robots shut each other in, unless each has sides of its own") {
  const std::string file = STIG_TESTS_DIR "/compiler/ring.yaml";
  const Checked ring(rule_set(file));
  CHECK(ring.conflicts() == std::set{ConflictKind::walled_in});
  check_against_crew(ring, 2);
  CHECK(ring.compiled.concurrency.one_a_side);
  const Crew crew(ring.rules, ring.compiled, 2, true);
  CHECK(crew.failures.empty());
  CHECK(crew.whole.size() == 1);
  const Checked two(rule_set(file), 2);
  CHECK(two.compiled.decision);
  CHECK(two.diagnostics.all().empty());
  // One of them would share a side, of two.
  const Checked three(rule_set(file), 3);
  CHECK(!three.compiled.decision);
  CHECK(to_text(three.diagnostics).find("up to 2 robots, each with sides of its own") !=
        std::string::npos);
  CompileOptions anywhere;
  anywhere.own_sides = false;
  Diagnostics diagnostics;
  const RuleSet rules = rule_set(file);
  CHECK(!compile_rules(rules, paper_robot(), anywhere, diagnostics).decision);
  CHECK(diagnostics.all()[0].code == Code::P713);
}

/// Some bricks at the start, and rules by which bricks of a higher colour come next to those of a
/// lower one, mostly on a further condition.
class AnySite {
 public:
  RuleSet make() {
    rules_.name = "any site";
    rules_.floor = true;
    rules_.conflicts = Conflicts::random;
    rules_.symmetry = one_in(6) ? Symmetry::rotations : Symmetry::none;
    for (const char* led : {"Q1", "Q2", "Q3", "Q4"}) {
      rules_.bricks.push_back({std::string(led + 1), led, "#e6194b", led, {}});
    }
    BrickMap start;
    for (int i = number(1, 3); i > 0; --i) {
      start.emplace(Cell{number(0, 4), number(0, 2), 0}, static_cast<Colour>(number(1, 2)));
    }
    for (const auto& [cell, colour] : start) rules_.start.push_back({cell, colour});
    rules_.physical = PhysicalSpec{};
    for (const ApproachSide side : kAllSides) {
      if (!one_in(3)) rules_.physical->sides.emplace_back(to_string(side));
    }
    for (int i = number(2, 5); i > 0; --i) add_rule();
    return rules_;
  }

 private:
  static int number(int low, int high) { return *rc::gen::inRange(low, high + 1); }
  static bool one_in(int n) { return number(1, n) == 1; }

  void add_rule() {
    // At times the mirror image of the last one about x or y, or the same on another condition.
    if (!rules_.rules.empty() && one_in(2)) return add_another(rules_.rules.back());
    Rule rule;
    rule.place = static_cast<Colour>(number(2, 4));
    const bool up = one_in(3);
    if (!up) rule.height_max = 0;
    if (up) rule.height_min = 1;
    const Offset beside[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    from_ = up ? Offset{0, 0, -1} : beside[number(0, 3)];
    colour_ = StateSet::of(static_cast<State>(number(1, rule.place - 1)));
    add(rule);
  }

  void add_another(Rule rule) {
    if (one_in(2)) {
      const Neighbourhood& n = neighbourhood(Lattice::cubic);
      const int x = one_in(2) ? -1 : 1, y = -x;
      Pattern turned;
      for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
        const Offset o = n.offsets[i];
        const auto image = static_cast<std::size_t>(n.index_of({x * o.x, y * o.y, o.z}));
        turned.allowed[image] = rule.pattern.allowed[i];
      }
      rule.pattern = turned;
      from_ = {x * from_.x, y * from_.y, from_.z};
      rules_.rules.push_back(rule);
    } else {
      rule.pattern = {};
      add(rule);
    }
  }

  void add(Rule rule) {
    const Neighbourhood& n = neighbourhood(Lattice::cubic);
    for (int more = number(0, 2); more > 0; --more) {
      rule.pattern.allowed[static_cast<std::size_t>(number(0, n.size - 1))] =
          one_in(2) ? StateSet::empty_cell() : StateSet::bricks(4);
    }
    rule.pattern.allowed[static_cast<std::size_t>(n.index_of(from_))] = colour_;
    rule.name = "rule " + std::to_string(rules_.rules.size());
    rules_.rules.push_back(rule);
  }

  RuleSet rules_;
  Offset from_;
  StateSet colour_;
};

TEST_CASE("on rule sets by chance crews of three meet what the check says, and hardly less") {
  int clear = 0, conflicts = 0, stricter = 0, one_a_side = 0;
  CHECK(rc::check("no failure is left out", [&] {
    for (int i = 0; i < 4; ++i) {
      Checked one(AnySite().make(), 1, 300);
      if (!one.compiled.decision) continue;
      if (*rc::gen::inRange(0, 2) == 1) one.take_first_tree();
      if (!one.compiled.decision) continue;
      const Crew crew(one.rules, one.compiled, 3);
      const std::set<ConflictKind> said = one.conflicts();
      RC_ASSERT(
          std::includes(said.begin(), said.end(), crew.failures.begin(), crew.failures.end()));
      RC_ASSERT(crew.whole.size() == 1U);
      ++(said.empty() ? clear : conflicts);
      if (one.compiled.concurrency.one_a_side) {
        ++one_a_side;
        const Crew apart(one.rules, one.compiled, 3, true);
        RC_ASSERT(apart.failures.empty());
        RC_ASSERT(apart.whole.size() == 1U);
      }
      stricter += crew.failures != said ? 1 : 0;
    }
  }));
  MESSAGE(clear, " without conflict, ", conflicts, " with; ", stricter,
          " said to have more kinds than crews of three meet, ", one_a_side,
          " without one where no two share a side");
  CHECK(clear > 100);
  CHECK(conflicts > 0);
  CHECK(2 * stricter <= conflicts);
}

}  // namespace
}  // namespace stig
