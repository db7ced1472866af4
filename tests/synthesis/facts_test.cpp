// SPDX-License-Identifier: MIT
// Facts that were computed independently beforehand: T5 to T8 and T10 of the project's
// list, and the table of a slow prototype, which each row must not fall behind.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "lattice/event_orders.h"
#include "support/uses.h"
#include "synthesis/check_rules.h"
#include "synthesis/emit.h"
#include "synthesis/shapes.h"
#include "synthesis/synthesise.h"

namespace stig {
namespace {

Colouring given_colours(const Frame& frame) {
  Colouring colours;
  for (const Orbit& orbit : frame.orbits) colours.push_back(orbit.colours.first());
  return colours;
}

struct Judged {
  int good = 0;
  std::size_t fewest_rules = 1000, entries = 0;
};

/// Every order of the orbits, each start in turn, with the target's own colours.
Judged judge_all(const Target& target, Symmetry symmetry,
                 const std::vector<std::vector<Cell>>& starts) {
  Judged judged;
  for (const std::vector<Cell>& start : starts) {
    const Frame frame = make_frame(target, {start, symmetry});
    const Colouring colours = given_colours(frame);
    for (const Order& order : all_orders(frame, 100000)) {
      BadOrder bad;
      const auto schedule = make_schedule(frame, order, bad);
      if (!schedule || !find_clashes(*schedule, colours, 1, 1).empty()) continue;
      ++judged.good;
      const auto rules = exact_rules(*schedule, colours);
      if (rules.size() >= judged.fewest_rules) continue;
      judged.fewest_rules = rules.size();
      judged.entries = 0;
      for (const ExactRule& rule : rules) judged.entries += rule.images.size();
    }
  }
  return judged;
}

TEST_CASE("T5: 130 of 720 choices of start and order give the staircase, the best has 4 rules") {
  const Target target = staircase(ColourUse::given);
  std::vector<std::vector<Cell>> starts;
  for (const Cell c : target.cells) starts.push_back({c});
  const Judged judged = judge_all(target, Symmetry::none, starts);
  CHECK(judged.good == 130);
  CHECK(judged.fewest_rules == 4);
}

TEST_CASE("T6: 6 of 120 orders give the stepped cross, the best has 10 rules, 37 turned") {
  const Judged judged =
      judge_all(stepped_cross(ColourUse::given), Symmetry::rotations, {{Cell{2, 2, 0}}});
  CHECK(judged.good == 6);
  CHECK(judged.fewest_rules == 10);
  CHECK(judged.entries == 37);
}

TEST_CASE("T7: what start and rules share, the target must have") {
  SynthesisOptions options;
  options.symmetry = Symmetry::rotations;
  options.start = {{0, 0, 0}};
  const Synthesis result = synthesise(staircase(ColourUse::free), options);
  REQUIRE(result.obstacle);
  CHECK(result.obstacle->kind == Obstacle::Kind::asymmetric);
  CHECK_FALSE(result.best);
}

TEST_CASE("a turn about an edge's middle takes cells to where there are none, and it is said so") {
  SynthesisOptions options;
  options.symmetry = Symmetry::rotations;
  options.start = {{0, 0, 0}, {1, 0, 0}};
  const Synthesis result = synthesise(box({2, 2, 1}), options);
  REQUIRE(result.obstacle);
  CHECK(result.obstacle->kind == Obstacle::Kind::asymmetric);
  CHECK(result.obstacle->what.find("lies between cells") != std::string::npos);
}

int fewest_colours(const Target& target, Cell start) {
  SynthesisOptions options;
  options.start = {start};
  const Synthesis result = synthesise(target, options);
  REQUIRE(result.best);
  CHECK(result.best->fewer_refuted);
  return result.best->colour_count;
}

TEST_CASE("T8: a straight line from its end needs as many colours as cells, from its middle half") {
  for (int n = 2; n <= 9; ++n) CHECK(fewest_colours(box({n, 1, 1}), {0, 0, 0}) == n);
  CHECK(fewest_colours(box({7, 1, 1}), {3, 0, 0}) == 4);
}

TEST_CASE("T10: the four short rules of the stepped cross are found") {
  SynthesisOptions options;
  options.symmetry = Symmetry::rotations;
  options.floor = true;
  options.fewest = Fewest::rules;
  const Synthesis result = synthesise(stepped_cross(ColourUse::given), options);
  REQUIRE(result.best);
  CHECK(result.best->colour_count == 3);
  CHECK(result.best->rules.size() == 4);
}

struct Row {
  const char* name;
  Target target;
  Symmetry symmetry;
  Cell start;
  int colours;
  std::size_t rules;
};

std::vector<Row> table() {
  return {{"staircase", staircase(ColourUse::free), Symmetry::none, {0, 0, 0}, 3, 4},
          {"stepped cross", stepped_cross(ColourUse::free), Symmetry::rotations, {2, 2, 0}, 3, 10},
          {"plate 7x7", box({7, 7, 1}), Symmetry::rotations, {3, 3, 0}, 4, 14},
          {"pyramid", pyramid(5), Symmetry::rotations, {5, 5, 0}, 6, 84},
          {"hollow box 5", hollow_box(5), Symmetry::none, {0, 0, 0}, 5, 92},
          {"cube 8", box({8, 8, 8}), Symmetry::none, {0, 0, 0}, 8, 309},
          {"cube 10", box({10, 10, 10}), Symmetry::none, {0, 0, 0}, 10, 408}};
}

TEST_CASE("no row of the prototype's table is better in colours or rules") {
  for (const Row& row : table()) {
    CAPTURE(row.name);
    SynthesisOptions options;
    options.symmetry = row.symmetry;
    options.start = {row.start};
    options.effort = 0.25;
    const Synthesis result = synthesise(row.target, options);
    REQUIRE(result.best);
    CHECK(result.best->colour_count <= row.colours);
    CHECK(result.best->rules.size() <= row.rules);
  }
}

TEST_CASE("breadth first by faces without ties, the table's colours are the fewest") {
  for (const Row& row : table()) {
    CAPTURE(row.name);
    const Frame frame = make_frame(row.target, {{row.start}, row.symmetry});
    const std::vector<std::int32_t> distance = distances(frame, Steps::faces);
    const Order order = grown(frame, "breadth first", [&](Cell c) {
      const int cell = index_in(frame.cells, c);
      const int orbit = frame.orbit_of[static_cast<std::size_t>(cell)];
      return std::vector{distance[static_cast<std::size_t>(orbit)], c.x, c.y, c.z};
    });
    BadOrder bad;
    const auto schedule = make_schedule(frame, order, bad);
    REQUIRE(schedule);
    ColouringSearch search(*schedule, 0);
    Colouring colours;
    CHECK(search.colour(row.colours, {}, colours) == Answered::yes);
    CHECK(search.colour(row.colours - 1, {}, colours) == Answered::no);
  }
}

}  // namespace
}  // namespace stig
