// SPDX-License-Identifier: MIT
// Objectives on structures whose measures can be counted by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "lattice/structure.h"
#include "search/draws.h"
#include "search/objectives.h"
#include "search/repeated_parts.h"
#include "search/shapes.h"
#include "support/golden.h"

namespace stig {
namespace {

/// A set of one rule, by which a row of bricks grows to both sides.
Genome row() {
  Genome genome;
  GeneRule rule;
  rule.when.fill(kGeneAnything);
  rule.when[static_cast<std::size_t>(neighbourhood(Lattice::cubic).index_of({-1, 0, 0}))] = 2;
  genome.rules = {rule, rule};
  return genome;
}

double value(std::string_view name, const Genome& genome, double same_ends = 0) {
  Screener screener({9, 100});
  const Screening& run = screener.run(genome, 1);
  const auto bricks = built(genome, run);
  const Measures shape = measure(Structure(genome.lattice, bricks));
  return objectives()[*objective_number(name)].value(
      {genome, run, bricks, shape, {same_ends, 0, 0}});
}

}  // namespace

TEST_CASE("a row of five bricks has the measures of one") {
  CHECK(value("bricks", row()) == 5);
  CHECK(value("rules_used", row()) == 0.5);
  CHECK(value("compactness", row()) == doctest::Approx(8.0 / 5 / 6));
  // Both ends have neighbourhoods of their own, the three within the same.
  CHECK(value("modules", row()) == 1);
  CHECK(value("repetition", row()) == doctest::Approx(0.6));
  CHECK(value("symmetry", row()) == 8);
  CHECK(value("enclosed", row()) == 0);
  CHECK(value("height", row()) == 1);
  CHECK(value("stages", row()) == 4);
  CHECK(value("saturated", row()) == 1);
  CHECK(value("same_ends", row(), 0.25) == 0.25);
  CHECK(value("parallelism", row()) == 1);
  CHECK(value("coordinated", row()) == 0);
  CHECK(value("verdict", row()) == 0);
  CHECK(value("distance", row()) == 1);
  CHECK(value("repeated_parts", row()) == 0);
}

namespace {

std::vector<PlacedBrick> sorted(std::vector<PlacedBrick> bricks) {
  std::sort(bricks.begin(), bricks.end());
  return bricks;
}

/// A U of three bricks wide and two high at `at`, turned about its first brick, and a mark on one
/// arm.
std::vector<PlacedBrick> arch(Cell at, const Orientation& turn) {
  std::vector<PlacedBrick> bricks;
  for (const Offset o :
       {Offset{0, 0, 0}, Offset{1, 0, 0}, Offset{2, 0, 0}, Offset{0, 0, 1}, Offset{2, 0, 1}}) {
    bricks.push_back({at + turn.apply(o), Colour(o.x == 2 && o.z == 1 ? 2 : 1)});
  }
  return bricks;
}

int parts(const std::vector<PlacedBrick>& bricks) {
  return repeated_parts(Lattice::cubic, sorted(bricks));
}

}  // namespace

TEST_CASE("parts that are in two places are counted, turned or not, by their colours") {
  const auto turns = orientations(Lattice::cubic, Symmetry::rotations, false);
  std::vector<PlacedBrick> two = arch({0, 0, 0}, turns[0]);
  // Each of its five bricks has a part of its own kind.
  CHECK(parts(two) == 0);
  for (const Orientation& turn : turns) {
    two.resize(5);
    for (const PlacedBrick& brick : arch({9, 9, 4}, turn)) two.push_back(brick);
    CHECK(parts(two) == 5);
  }
  two.back().brick = 3;
  CHECK(parts(two) < 5);
  // A row's inner parts are of one kind, but need room for two that share no brick.
  const auto row_of = [](int length) {
    std::vector<PlacedBrick> bricks;
    for (int x = 0; x < length; ++x) bricks.push_back({{x, 0, 0}, 1});
    return bricks;
  };
  CHECK(parts(row_of(5)) == 0);
  // The ends, and the bricks beside them, are alike by half a turn.
  CHECK(parts(row_of(6)) == 1);
  CHECK(parts(row_of(8)) == 2);
  CHECK(parts(row_of(9)) == 2);
  CHECK(parts(row_of(14)) == 3);
  CHECK(parts({}) == 0);
  CHECK(parts({{{0, 0, 0}, 1}, {{5, 5, 5}, 1}}) == 0);
}

TEST_CASE("law: repeated parts are the same wherever a structure stands, turned or not") {
  CHECK(rc::check("moved and turned", [] {
    const DrawnGenome drawn = random_genome(random_settings());
    const Lattice lattice = drawn.genome.lattice;
    const Structure structure(lattice, drawn.imagined);
    const auto group = orientations(lattice, Symmetry::rotations, false);
    const auto& g = group[*rc::gen::inRange<std::size_t>(0, group.size())];
    RC_ASSERT(repeated_parts(lattice, transformed(structure, g).bricks()) ==
              repeated_parts(lattice, structure.bricks()));
  }));
}

TEST_CASE("a name that no objective has is not found, and names are distinct") {
  CHECK_FALSE(objective_number("beauty"));
  std::set<std::string_view> names;
  for (const Objective& objective : objectives()) names.insert(objective.name);
  CHECK(names.size() == objectives().size());
}

TEST_CASE("the page about searches lists every objective with its meaning and its source") {
  const std::string page = project_file("docs/search.md");
  for (const Objective& objective : objectives()) {
    const std::string row = "| `" + std::string(objective.name) + "` | " +
                            std::string(objective.doc) + " | " + std::string(objective.source) +
                            " |\n";
    CAPTURE(row);
    CHECK(page.find(row) != std::string::npos);
  }
}

TEST_CASE("law: shapes have equal hashes exactly when their canonical structures are equal") {
  CHECK(rc::check("turned, mirrored, moved; and another structure", [] {
    const DrawnGenome drawn = random_genome(random_settings());
    const Lattice lattice = drawn.genome.lattice;
    const auto hash = [&](const Structure& s) { return shape_hash(lattice, s.bricks()); };
    const Structure structure(lattice, drawn.imagined);
    const auto group = orientations(lattice, Symmetry::rotations_mirrors, false);
    const auto& g = group[*rc::gen::inRange<std::size_t>(0, group.size())];
    RC_ASSERT(hash(transformed(structure, g)) == hash(structure));
    RC_ASSERT(hash(to_origin(structure)) == hash(structure));
    const Structure other(lattice, random_genome(random_settings()).imagined);
    const auto same = [](const Structure& s) {
      return canonical(s, Symmetry::rotations_mirrors, false).bricks();
    };
    RC_ASSERT((hash(other) == hash(structure)) == (same(other) == same(structure)));
  }));
}

}  // namespace stig
