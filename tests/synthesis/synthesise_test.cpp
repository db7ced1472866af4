// SPDX-License-Identifier: MIT
// What comes out is held to an exhaustive search over all orders of events, and the
// solver's answers to other solvers.
#include "synthesis/synthesise.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/random.h"
#include "lattice/event_orders.h"
#include "lattice/rgb.h"
#include "rules/rule_checks.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "synthesis/check_rules.h"
#include "synthesis/emit.h"
#include "synthesis/proof_files.h"
#include "synthesis/shapes.h"
#include "verify/verify.h"

namespace stig {
namespace {

/// Grown at random, every cell a neighbour of an earlier one.
Target random_target(Lattice lattice, std::size_t cells, std::uint32_t seed) {
  const Neighbourhood& n = neighbourhood(lattice);
  Random random(seed, 0, Purpose::test, 0, 0);
  Target target;
  target.lattice = lattice;
  target.cells = {Cell{0, 0, 0}};
  while (target.cells.size() < cells) {
    const Cell from = target.cells[random.below(target.cells.size())];
    const Cell to = from + n.offsets[random.below(static_cast<std::uint64_t>(n.size))];
    if (to.z < 0 || std::find(target.cells.begin(), target.cells.end(), to) != target.cells.end()) {
      continue;
    }
    target.cells.push_back(to);
  }
  std::sort(target.cells.begin(), target.cells.end());
  target.colours.assign(cells, StateSet::anything());
  return target;
}

RuleSet rules_of(const Solution& s, const Target& target) {
  return make_rule_set(*s.frame, s.colours, s.colour_count, target.bricks, s.rules,
                       {"made", "made", "a test"});
}

/// Every order of events from the start ends in the target.
void check_all_orders(const RuleSet& rules, const Target& target) {
  const EventOrders found = explore_event_orders(RuleTable(rules), rules.start, std::nullopt);
  REQUIRE(found.complete);
  REQUIRE(found.ends.size() == 1);
  std::vector<Cell> cells;
  for (const PlacedBrick& b : found.ends[0].bricks()) cells.push_back(b.at);
  CHECK(cells == target.cells);
  CHECK(to_origin(found.ends[0]).bricks() == rules.expect->structure);
}

/// The verifier, which knows nothing of how the rules were made, proves as much.
void check_proved(const RuleSet& rules, const Target& target) {
  const VerifyResult result = verify::verify(rules, {});
  CHECK(result.verdict == ProofVerdict::proved);
  REQUIRE(result.structure);
  CHECK(to_origin(*result.structure).bricks() == rules.expect->structure);
  CHECK(result.structure->size() == target.cells.size());
}

/// The file that is written is read back without a complaint.
void check_file(const RuleSet& rules) {
  Diagnostics diagnostics;
  const auto again =
      read_rule_set(std::make_shared<SourceFile>("made.yaml", print_rule_set(rules)), diagnostics);
  CAPTURE(to_text(diagnostics));
  CHECK(diagnostics.all().empty());
  REQUIRE(again);
  CHECK(print_rule_set(*again) == print_rule_set(rules));
}

TEST_CASE("rule sets for random targets build them in every order of events") {
  int compiled = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const Lattice lattice = seed % 3 == 0 ? Lattice::hexagonal : Lattice::cubic;
    const Target target = random_target(lattice, 5 + seed % 12, seed);
    SynthesisOptions options;
    options.floor = seed % 2 == 0;
    options.merge = seed % 4 != 1;
    options.effort = 0.1;
    options.fewest = seed % 5 == 0 ? Fewest::rules : Fewest::colours;
    const Synthesis result = synthesise(target, options);
    if (!result.best) continue;
    ++compiled;
    const RuleSet rules = rules_of(*result.best, target);
    check_all_orders(rules, target);
    check_proved(rules, target);
    check_file(rules);
  }
  CHECK(compiled == 60);
}

TEST_CASE("symmetric targets, too, also about the middle of four cells") {
  for (const int side : {3, 4}) {
    for (const Symmetry symmetry : {Symmetry::rotations, Symmetry::rotations_mirrors}) {
      SynthesisOptions options;
      options.symmetry = symmetry;
      options.effort = 0.1;
      const Target target = box({side, side, 2});
      const Synthesis result = synthesise(target, options);
      REQUIRE(result.best);
      CHECK(rules_of(*result.best, target).start.size() == (side == 3 ? 1U : 4U));
      if (side == 3) check_all_orders(rules_of(*result.best, target), target);
      check_proved(rules_of(*result.best, target), target);
      check_file(rules_of(*result.best, target));
    }
  }
}

TEST_CASE("colours that the target gives are kept, wildcards are free") {
  const Target target = staircase(ColourUse::given);
  const Synthesis result = synthesise(target, {});
  REQUIRE(result.best);
  check_all_orders(rules_of(*result.best, target), target);
  for (std::size_t i = 0; i < target.cells.size(); ++i) {
    const Frame& frame = *result.best->frame;
    const auto orbit = static_cast<std::size_t>(frame.orbit_of[i]);
    CHECK(target.colours[i].contains(result.best->colours[orbit]));
  }
}

TEST_CASE("for given colours an order is found that no family has") {
  int found = 0;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    Target target = random_target(Lattice::cubic, 14, seed);
    const Frame frame = make_frame(target, {{target.cells.front()}});
    Random random(seed, 0, Purpose::test, 1, 0);
    const Order order = grown(frame, "random", [&](Cell) {
      return std::vector<std::int32_t>{static_cast<std::int32_t>(random.below(1000))};
    });
    BadOrder bad;
    const auto schedule = make_schedule(frame, order, bad);
    REQUIRE(schedule);
    ColouringSearch search(*schedule, 0);
    Colouring colours;
    if (search.differences().hopeless()) continue;
    int k = search.at_least();
    while (k < kMaxColours && search.colour(k, {}, colours) != Answered::yes) ++k;
    if (k == kMaxColours) continue;
    for (std::size_t i = 0; i < target.cells.size(); ++i) {
      const auto orbit = static_cast<std::size_t>(frame.orbit_of[i]);
      target.colours[i] = StateSet::of(colours[orbit]);
    }
    target.bricks = numbered_bricks(k);
    SynthesisOptions options;
    options.start = {target.cells.front()};
    options.effort = 0.25;
    const Synthesis result = synthesise(target, options);
    if (!result.best) continue;
    ++found;
    check_proved(rules_of(*result.best, target), target);
    for (std::size_t i = 0; i < target.cells.size(); ++i) {
      const auto orbit = static_cast<std::size_t>(result.best->frame->orbit_of[i]);
      CHECK(target.colours[i].contains(result.best->colours[orbit]));
    }
  }
  MESSAGE(found << " of 10 found");
  CHECK(found >= 8);
}

TEST_CASE("impossible targets say which reason stands in the way") {
  const Target apart = carved({3, 1, 1}, [](Cell c) { return c.x != 1; });
  Synthesis result = synthesise(apart, {});
  REQUIRE(result.obstacle);
  CHECK(result.obstacle->kind == Obstacle::Kind::not_connected);

  SynthesisOptions options;
  options.start = {{5, 5, 5}};
  result = synthesise(box({2, 1, 1}), options);
  REQUIRE(result.obstacle);
  CHECK(result.obstacle->kind == Obstacle::Kind::bad_start);

  options.start = {{0, 0, 0}};
  options.most_colours = 6;
  result = synthesise(box({7, 1, 1}), options);
  REQUIRE(result.obstacle);
  CHECK(result.obstacle->kind == Obstacle::Kind::colours);

  result = synthesise(drawn("1 1 1 1", ColourUse::given), {});
  REQUIRE(result.obstacle);
  CHECK(result.obstacle->kind == Obstacle::Kind::look_alike);
}

TEST_CASE("a fault is found in rules that were tampered with") {
  const Target target = box({3, 2, 2});
  SynthesisOptions options;
  options.heights = false;
  const Synthesis result = synthesise(target, options);
  REQUIRE(result.best);
  BadOrder bad;
  const auto schedule = make_schedule(*result.best->frame, result.best->order, bad);
  REQUIRE(schedule);
  const RuleSet rules = rules_of(*result.best, target);
  CHECK_FALSE(find_fault(*schedule, result.best->colours, rules));
  for (std::size_t k = 0; k < rules.rules.size(); ++k) {
    RuleSet fewer = rules;
    fewer.rules.erase(fewer.rules.begin() + static_cast<std::ptrdiff_t>(k));
    CHECK(find_fault(*schedule, result.best->colours, fewer));
    RuleSet wider = rules;
    wider.rules[k].pattern = Pattern();
    CHECK(find_fault(*schedule, result.best->colours, wider));
  }
}

/// 10 satisfiable, 20 not; -1 when the program is not there.
int ask(const std::string& program, const std::string& cnf) {
  if (std::system(("command -v " + program + " > /dev/null").c_str()) != 0) return -1;
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("stig-cross-check-" + std::to_string(getpid()) + ".cnf"))
                               .string();
  std::ofstream(path) << cnf;
  const int status = std::system((program + " " + path + " > /dev/null 2>&1").c_str());
  std::filesystem::remove(path);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 0;
}

TEST_CASE("other solvers agree that so many colours do, and one fewer do not") {
  for (const Target& target :
       {box({4, 4, 4}), hollow_box(4), box({9, 2, 1}), staircase(ColourUse::free)}) {
    const Frame frame = make_frame(target, {{target.cells.front()}});
    BadOrder bad;
    for (const OrderPlan& plan : order_plans()) {
      const auto schedule = make_schedule(frame, plan.make(frame), bad);
      if (!schedule) continue;
      ColouringSearch search(*schedule, 0);
      if (search.differences().hopeless()) continue;
      Colouring colours;
      int k = search.at_least();
      while (search.colour(k, {}, colours) != Answered::yes) ++k;
      for (const char* program : {"minisat", "picosat"}) {
        const int more = ask(program, print_cnf(search.differences(), 0, k, search.naming()));
        CHECK((more == 10 || more == -1));
        if (k == 1) continue;
        const int fewer = ask(program, print_cnf(search.differences(), 0, k - 1, search.naming()));
        CHECK((fewer == 20 || fewer == -1));
      }
      break;
    }
  }
}

}  // namespace
}  // namespace stig
