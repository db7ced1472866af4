// SPDX-License-Identifier: MIT
// Small certificates written by hand, and what is wrong with changed ones.
#include "certify/check.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "base/hash.h"
#include "certify/space.h"
#include "lattice/box.h"
#include "rules/rule_printer.h"
#include "support/small_sets.h"
#include "support/uses.h"

namespace stig {
namespace {

/// Neighbour indices (neighbourhood.h) as masks.
constexpr std::uint32_t kWest = 1U << 12, kEast = 1U << 13, kNorth = 1U << 10, kSouth = 1U << 15;

Certificate certificate_for(const RuleSet& rules, const std::vector<CertifiedStage>& stages) {
  Certificate certificate{rule_set_hash(rules), rules.box, stages, rules.start.size()};
  for (const CertifiedStage& stage : stages) certificate.bricks += stage.order.size();
  return certificate;
}

std::string refusal(const RuleSet& rules, const std::vector<CertifiedStage>& stages) {
  const CheckReport report = check_certificate(rules, certificate_for(rules, stages));
  CHECK(report.accepted == report.refusal.empty());
  return report.refusal;
}

/// A rule that looks at level neighbours alone; rows y+1, y, y-1.
std::string level_rule(const std::string& place, const std::string& back, const std::string& row,
                       const std::string& front, const std::string& more = "") {
  static int number = 0;
  return fmt::format(
      "  - name: rule {}\n    place: {}\n{}    when: |\n      ? ? ?   {}   ? ? ?\n"
      "      ? ? ?   {}   ? ? ?\n      ? ? ?   {}   ? ? ?\n",
      ++number, place, more, back, row, front);
}

/// A row 1 2 3, placed from west to east.
RuleSet row_set() { return small_set(east_of("1", "2") + east_of("2", "3")); }
CertifiedStage row_stage() { return {{{{1, 0, 0}, 2, 0}, {{2, 0, 0}, 3, kWest}}, {}, {}}; }

/// 1 in the middle and 2s east and west of it; a 3 where both 2s stand beside, south of 1.
RuleSet fork_set() {
  return small_set(level_rule("2", ". . .", "1 * .", "? ? ?") +
                   level_rule("2", ". . .", ". * 1", "? ? ?") +
                   level_rule("3", "2 1 2", "? * ?", "? ? ?"));
}
CertifiedStage fork_stage() {
  const std::uint32_t both = 1U << 9 | 1U << 11;
  return {{{{1, 0, 0}, 2, 0}, {{-1, 0, 0}, 2, 0}, {{0, -1, 0}, 3, both}}, {}, {}};
}

TEST_CASE("a row in its order") {
  const RuleSet rules = row_set();
  const CheckReport report = check_certificate(rules, certificate_for(rules, {row_stage()}));
  CHECK(report.refusal.empty());
  CHECK(report.accepted);
  CHECK(report.structure ==
        std::vector<PlacedBrick>{{{0, 0, 0}, 1}, {{1, 0, 0}, 2}, {{2, 0, 0}, 3}});
  CHECK(report.sites == 2 + 26 + 9 + 9 - 2);
}

TEST_CASE("bricks on two sides in any order, and one that waits for both") {
  CHECK(refusal(fork_set(), {fork_stage()}).empty());
}

TEST_CASE("a certificate is for its rules, in their box, with their stages") {
  const RuleSet rules = row_set();
  Certificate certificate = certificate_for(rules, {row_stage()});
  CHECK(check_certificate(fork_set(), certificate).refusal.find("hash") != std::string::npos);
  certificate.bricks = 4;
  CHECK(check_certificate(rules, certificate).refusal ==
        "the structure has 3 bricks, and the certificate says 4");
  CHECK(refusal(rules, {row_stage(), {}}) == "the certificate has 2 stages, and the rules have 1");
  certificate = certificate_for(rules, {row_stage()});
  certificate.box = BoxSpec{{3, 3, 3}, Cell{0, 0, 0}, false};
  CHECK(check_certificate(rules, certificate).refusal ==
        "the certificate is for the box 3x3x3 at (0, 0, 0), and asked for is unbounded space");
  CHECK(check_certificate(rules, certificate, certificate.box).accepted);
  certificate.box->size.x = 2;
  CHECK(check_certificate(rules, certificate, certificate.box).refusal ==
        "stage 1: no brick can be placed at (2, 0, 0)");
}

TEST_CASE("a box without a place is laid as the lattice lays it") {
  for (const bool floor : {false, true}) {
    for (int size = 1; size < 9; ++size) {
      const std::vector<PlacedBrick> start{{{-3, 2, 1}, 1}, {{0, 4, 7}, 1}};
      const BoxSpec spec{{size, size, size}, {}, false};
      CHECK(placed_box(spec, start, floor).origin == lay_box(spec, start, floor).low);
    }
  }
}

TEST_CASE("(1) the run: places, colours, an acting rule") {
  const RuleSet rules = row_set();
  CertifiedStage stage = row_stage();
  stage.order[1].at = {1, 0, 0};
  stage.order[1].before = 0;
  CHECK(refusal(rules, {stage}) == "stage 1: there is a brick already at (1, 0, 0)");
  stage = row_stage();
  stage.order[0].colour = 4;
  CHECK(refusal(rules, {stage}) ==
        "stage 1: the brick at (1, 0, 0) has a colour that the rules do not know");
  stage = row_stage();
  stage.order[1].at = {1, 1, 0};
  stage.order[1].before = 0;
  CHECK(refusal(rules, {stage}) ==
        "stage 1: no rule places the brick at (1, 1, 0) when its turn comes");
  stage = row_stage();
  stage.order[0].colour = 3;
  CHECK(refusal(rules, {stage}) ==
        "stage 1: the rule '2 east of 1' can place a brick '2' at (1, 0, 0), where the structure "
        "has '3'");
}

TEST_CASE("`before` points to earlier bricks and holds") {
  const RuleSet rules = row_set();
  CertifiedStage stage = row_stage();
  stage.order[0].before = kEast;
  CHECK(refusal(rules, {stage}) ==
        "stage 1: neighbour 13 of the brick at (1, 0, 0) is no brick that comes earlier");
  stage.order[0].before = kWest;  // the start is no brick of the stage
  CHECK(refusal(rules, {stage}) ==
        "stage 1: neighbour 12 of the brick at (1, 0, 0) is no brick that comes earlier");
}

TEST_CASE("(3) a brick without its `before` is one that other orders may miss") {
  CertifiedStage stage = fork_stage();
  stage.order[2].before = 0;
  CHECK(refusal(fork_set(), {stage}).empty());  // the site's rule asks for both anyhow
  stage.order[2].before = 1U << 9;
  CHECK(refusal(fork_set(), {stage}).empty());
  // A rule that needs one of the two alone: now `before` says too much.
  const RuleSet rules = small_set(level_rule("2", ". . .", "1 * .", "? ? ?") +
                                  level_rule("2", ". . .", ". * 1", "? ? ?") +
                                  level_rule("3", "? 1 2", "? * ?", "? ? ?"));
  CHECK(refusal(rules, {fork_stage()})
            .find("can place the brick at (0, -1, 0) when a brick that "
                  "should be there before it is not") != std::string::npos);
}

TEST_CASE("(3) a site that more bricks close again") {
  // 2 east of 1 if nothing is south of it; 3 south of 1, later under the 2.
  const RuleSet rules = small_set(level_rule("2", "? ? ?", "1 * ?", ". . ?") +
                                  level_rule("3", "? 1 ?", ". * ?", "? ? ?"));
  const CertifiedStage stage{{{{1, 0, 0}, 2, 0}, {{0, -1, 0}, 3, 0}}, {}, {}};
  CHECK(refusal(rules, {stage}) ==
        "stage 1: the brick at (1, 0, 0) can be placed, and can no longer be when more bricks "
        "stand around it");
}

TEST_CASE("(3) a site outside that some rule fills") {
  const RuleSet rules = row_set();
  CertifiedStage stage = row_stage();
  stage.order.pop_back();
  CHECK(refusal(rules, {stage}) ==
        "stage 1: the rule '3 east of 2' can place a brick '3' at (2, 0, 0), where the structure "
        "has none");
}

TEST_CASE("a rule that asks for no brick is no event where none stands beside") {
  RuleSet rules = row_set();
  Rule rule;
  rule.name = "anywhere";
  rule.place = 3;
  rules.rules.push_back(rule);
  CHECK(refusal(rules, {row_stage()}).find("'anywhere'") != std::string::npos);
  rules.start.clear();
  CHECK(refusal(rules, {{}}).empty());
}

/// A 2 east and a 3 north of a 1 in either order, each with a rule for when it comes first
/// and one for when it comes second.
RuleSet window_set() {
  return small_set(
      level_rule("2", ". . .", "1 * .", "? ? ?") + level_rule("3", ". . .", ". * .", ". 1 .") +
      level_rule("2", "3 . .", "1 * .", "? ? ?") + level_rule("3", ". . .", ". * .", ". 1 2"));
}
CertifiedStage window_stage() {
  return {{{{1, 0, 0}, 2, 0}, {{0, 1, 0}, 3, 0}}, {}, {{{0, 1}, {}, {{0}, {1}, {2}, {3}}}}};
}

TEST_CASE("(4) windows") {
  const RuleSet rules = window_set();
  CHECK(refusal(rules, {window_stage()}).empty());

  CertifiedStage stage = window_stage();
  stage.windows[0].fillings = {{0}, {1}, {3}};
  CHECK(refusal(rules, {stage}) ==
        "stage 1: the brick at (0, 1, 0) can be placed in a filling of 0 bricks, and the window "
        "does not list the filling with it");
  stage.windows[0].fillings = {{1}, {2}, {3}};
  CHECK(refusal(rules, {stage}) == "stage 1: a window does not list the empty filling");
  stage.windows[0].fillings = {{0}, {2}, {1}, {3}};
  CHECK(refusal(rules, {stage}) == "stage 1: the fillings of a window do not rise");
  stage.windows[0].fillings = {{0}, {1}, {2}, {3}, {4}};
  CHECK(refusal(rules, {stage}) == "stage 1: a filling has a wrong length");
  stage.windows[0].fillings = {{0, 0}};
  CHECK(refusal(rules, {stage}) == "stage 1: a filling has a wrong length");

  stage = window_stage();
  stage.windows[0].group = {0, 2};
  CHECK(refusal(rules, {stage}) == "stage 1: a window names no brick");
  stage.windows[0].group = {0, 0};
  CHECK(refusal(rules, {stage}).find("is in the group of a window and in another") !=
        std::string::npos);
  stage.windows = {{{0}, {1, 1}, {{0}}}};
  CHECK(refusal(rules, {stage}) == "stage 1: the brick at (0, 1, 0) is twice in one window");
  stage.windows = {{{0}, {}, {{0}, {1}}}, {{1}, {}, {{0}, {1}}}};
  CHECK(refusal(rules, {stage}) ==
        "stage 1: the brick at (1, 0, 0) is in the group of a window that does not have all "
        "bricks around it");
  stage.windows = {{{0}, {1}, {{0}, {1}, {2}, {3}}}, {{1}, {}, {{0}, {1}}}};
  CHECK(refusal(rules, {stage}).find("is in the group of a window and in another") !=
        std::string::npos);
}

TEST_CASE("(4) a brick of a context, with and without its filling") {
  const RuleSet rules = window_set();
  CertifiedStage stage = window_stage();
  stage.windows = {{{0}, {1}, {{0}, {1}, {2}, {3}}}};
  CHECK(refusal(rules, {stage}).empty());
  stage.windows = {{{0}, {1}, {{0}, {1}, {3}}}};
  CHECK(refusal(rules, {stage}).find("can be placed in a filling of 0 bricks") !=
        std::string::npos);
  stage.windows = {{{0}, {1}, {{0}, {1}, {2}}}};
  CHECK(refusal(rules, {stage}).find("can be placed in a filling of 1 brick") != std::string::npos);
}

TEST_CASE("(4) a group brick has nothing before it, and a filling is no dead end") {
  CertifiedStage stage = row_stage();
  stage.windows = {{{1}, {0}, {{0}, {1}, {2}, {3}}}};
  CHECK(refusal(row_set(), {stage}) ==
        "stage 1: the brick at (2, 0, 0) is in a group and has bricks before it");
  stage.order[1].before = 0;
  CHECK(refusal(row_set(), {stage}).empty());
  // Where the 3 came first the 2 can no longer come.
  const RuleSet rules = small_set(level_rule("2", ". . .", "1 * .", "? ? ?") +
                                  level_rule("3", ". . .", ". * .", ". 1 ."));
  const CertifiedStage blocked{{{{1, 0, 0}, 2, 0}}, {}, {{{0}, {}, {{0}, {1}}}}};
  CHECK(refusal(rules, {blocked}).find("where the structure has none") != std::string::npos);
  const RuleSet two_ways = small_set(level_rule("2", ". . .", "1 * .", "? ? ?") +
                                     level_rule("3", ". . .", ". * .", ". 1 ?"));
  const CertifiedStage dead{
      {{{1, 0, 0}, 2, 0}, {{0, 1, 0}, 3, 0}}, {}, {{{0, 1}, {}, {{0}, {1}, {2}, {3}}}}};
  CHECK(refusal(two_ways, {dead}) ==
        "stage 1: a filling of 1 brick is a dead end: no rule places a brick of the group of the "
        "brick at (1, 0, 0)");
}

TEST_CASE("far facts are chains of steps") {
  const RuleSet rules = small_set(east_of("1", "2") + east_of("2", "3") + east_of("3", "2"),
                                  "box: {size: [4, 1, 1], origin: [0, 0, 0]}\n");
  CertifiedStage stage{{{{1, 0, 0}, 2, 0}, {{2, 0, 0}, 3, kWest}, {{3, 0, 0}, 2, kWest}}, {}, {}};
  CHECK(refusal(rules, {stage}).empty());
  stage.far = {{2, 1, 0}};
  CHECK(refusal(rules, {stage}).empty());
  stage.far = {{2, 0}};
  CHECK(refusal(rules, {stage}) ==
        "stage 1: a far fact has a step that is none, from (3, 0, 0) to (1, 0, 0)");
  stage.far = {{3, 0}};
  CHECK(refusal(rules, {stage}) == "stage 1: a far fact names no brick");
}

TEST_CASE("a far fact tells of two bricks around a site that no steps within its view join") {
  // A hook from (0, 1, 0) round to (2, 1, 0). At (1, 0, 0) stands a trap: it would act were
  // the hook's end there and its beginning not.
  std::string head = "conflicts: random\nbricks:\n";
  for (int i = 1; i <= 6; ++i) {
    head += fmt::format("  {}: {{name: b{}, color: \"#00000{}\"}}\n", i, i, i);
  }
  const RuleSet rules = small_set(
      level_rule("2", "? ? ?", "? * ?", "? 1 ?") + level_rule("3", "? ? ?", "? * ?", "? 2 ?") +
          level_rule("4", "? ? ?", "3 * ?", "? ? ?") + level_rule("5", "? ? ?", "4 * ?", "? ? ?") +
          level_rule("6", "? 5 ?", "? * ?", "? ? ?") + level_rule("1", ". ? 6", "? * ?", "? ? ?"),
      head);
  CertifiedStage stage{{{{0, 1, 0}, 2, 0},
                        {{0, 2, 0}, 3, kSouth},
                        {{1, 2, 0}, 4, kWest},
                        {{2, 2, 0}, 5, kWest},
                        {{2, 1, 0}, 6, kNorth}},
                       {},
                       {}};
  CHECK(refusal(rules, {stage}).find("can place a brick '1' at (1, 0, 0)") != std::string::npos);
  stage.far = {{4, 3, 2, 1, 0}};
  CHECK(refusal(rules, {stage}).empty());
}

TEST_CASE("(5) a stage's number of deposits") {
  const std::string rules = level_rule("2", ". . .", "1 * .", "? ? ?", "    stage: 1\n") +
                            level_rule("2", "? ? ?", "2 * ?", "? ? ?", "    stage: 1\n") +
                            level_rule("3", "? 1 ?", "? * ?", "? ? ?", "    stage: 2\n");
  const RuleSet set = small_set(rules, "stages: {1: 2}\n");
  const CertifiedStage last{{{{0, -1, 0}, 3, 0}}, {}, {}};
  // After two deposits a third would follow, had the stage not ended.
  CertifiedStage first{{{{1, 0, 0}, 2, 0}, {{2, 0, 0}, 2, kWest}}, {}, {}};
  CHECK(refusal(set, {first, last}).find("at (3, 0, 0), where the structure has none") !=
        std::string::npos);
  first.order[1].before = 0;
  first.windows = {{{0, 1}, {}, {{0}, {1}, {3}}}};
  CHECK(refusal(set, {first, last}).empty());
  first.windows[0].fillings = {{0}, {1}};
  CHECK(refusal(set, {first, last}).find("can be placed in a filling of 1 brick") !=
        std::string::npos);
  first.windows.clear();
  first.order.push_back({{3, 0, 0}, 2, kWest});
  CHECK(refusal(set, {first, last}) == "stage 1: 3 bricks placed, and the stage ends with 2");
  // With one deposit fewer the stage has not ended: what follows must not be left out.
  first.order = {{{1, 0, 0}, 2, 0}};
  first.windows = {{{0}, {}, {{0}, {1}}}};
  CHECK(refusal(set, {first, last}).find("at (2, 0, 0), where the structure has none") !=
        std::string::npos);
}

TEST_CASE("heights, counts, stages and `conflicts: first` as the rules say") {
  const std::string high = "    height: {min: 1}\n";
  CHECK(refusal(small_set(east_of("1", "2", high)), {{}}).empty());
  CHECK_FALSE(refusal(small_set(east_of("1", "2", "    height: {max: 0}\n")), {{}}).empty());
  const std::string counted = "    count:\n      - {of: [1], among: faces, min: 2}\n";
  CHECK(refusal(small_set(east_of("1", "2", counted)), {{}}).empty());
  const RuleSet first = small_set(east_of("1", "2") + level_rule("3", "? ? ?", "# * ?", "? ? ?"),
                                  "conflicts: first\nbox: {size: [3, 1, 1], origin: [0, 0, 0]}\n");
  const CertifiedStage stage{{{{1, 0, 0}, 2, 0}, {{2, 0, 0}, 3, kWest}}, {}, {}};
  CHECK(refusal(first, {stage}).empty());
  RuleSet any = first;
  any.conflicts = Conflicts::random;
  CHECK(refusal(any, {stage}).find("can place a brick '3' at (1, 0, 0)") != std::string::npos);
}

TEST_CASE("too many local states are refused, not waited for") {
  // Nothing is known of the 25 bricks around the middle of a cube that stays empty there.
  RuleSet rules = small_set(east_of("1", "2"), "box: {size: [3, 3, 3], origin: [0, 0, 0]}\n");
  rules.rules[0].pattern = Pattern{};
  CountCondition count;
  count.of = StateSet::of(2);
  rules.rules[0].counts.push_back(count);
  CertifiedStage stage;
  const Neighbourhood& n = neighbourhood(Lattice::cubic);
  for (const Offset offset : n.offsets) {
    const Cell at = Cell{1, 1, 1} + offset;
    if (at != Cell{0, 0, 0}) stage.order.push_back({at, 2, 0});
  }
  std::sort(stage.order.begin(), stage.order.end(),
            [](const CertifiedBrick& a, const CertifiedBrick& b) { return a.at < b.at; });
  CHECK(refusal(rules, {stage}) == "stage 1: the site (1, 1, 1) has more than 65536 local states");
}

}  // namespace
}  // namespace stig
