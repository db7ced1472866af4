// SPDX-License-Identifier: MIT
// What is tried on candidates, on sets whose answers are known: a column that a lost brick does not
// stop, a pair of rules that race for a site, a row without an end.
#include <doctest/doctest.h>

#include "search/coordination.h"
#include "search/draws.h"
#include "search/operators.h"
#include "search/shapes.h"

namespace stig {
namespace {

std::size_t at(Offset offset) {
  return static_cast<std::size_t>(neighbourhood(Lattice::cubic).index_of(offset));
}

GeneRule beside(Offset brick, Colour seen, Colour place) {
  GeneRule rule;
  rule.when.fill(kGeneAnything);
  rule.when[at(brick)] = CellGene{1} << seen;
  rule.place = place;
  return rule;
}

/// East of the start a brick of colour 2, west of it one of colour 3: nothing else.
Genome both_sides() {
  Genome genome;
  genome.colours = 3;
  genome.rules = {beside({-1, 0, 0}, 1, 2), beside({1, 0, 0}, 1, 3)};
  return genome;
}

/// A brick east of the start or one beside that place, whichever comes first.
Genome race() {
  Genome genome;
  genome.colours = 2;
  // Each waits for an empty cell that the other fills: two places beside each other.
  genome.rules = {beside({-1, 0, 0}, 1, 2), beside({-1, -1, 0}, 1, 2)};
  genome.rules[0].when[at({0, 1, 0})] = 1;
  genome.rules[1].when[at({0, -1, 0})] = 1;
  return genome;
}

struct Tried {
  Trials trials;
  Coordination how;
};

Tried tried(const Genome& genome) {
  Screener screener({9, 60});
  const Screening run = screener.run(genome, 1);
  const auto bricks = built(genome, run);
  const TrialCounts counts{20, 20};
  const Trials trials = try_again(counts, genome, run, bricks, 1, screener);
  return {trials, coordination_of(genome, run, counts, trials, 50'000'000)};
}

}  // namespace

TEST_CASE("a set whose rules do not meet is coordinated, and proved to be") {
  const Tried result = tried(both_sides());
  CHECK(result.trials.same_ends == 1);
  CHECK(result.trials.lost_bricks == 1);  // the start, which both sides grow from, is never lost
  CHECK(result.trials.extra_bricks > 0);
  CHECK(result.trials.extra_bricks < 1);  // one of colour 1 begins a row of its own
  CHECK(is_coordinated(result.how));
}

TEST_CASE("two rules of which each rules the other out end differently, which runs show") {
  const Tried result = tried(race());
  CHECK(result.trials.same_ends > 0);
  CHECK(result.trials.same_ends < 1);
  CHECK(result.how == Coordination::other_ends);
  CHECK(result.trials.lost_bricks == 0);
}

TEST_CASE("the verifier refutes what too few runs have not, and sees growth without end") {
  const Genome genome = race();
  Screener screener({9, 60});
  const Screening run = screener.run(genome, 1);
  CHECK(coordination_of(genome, run, {}, {}, 50'000'000) == Coordination::refuted);
  CHECK(coordination_of(genome, run, {}, {}, 0) == Coordination::not_asked);
  Genome row;
  row.rules = {beside({-1, 0, 0}, 1, 1)};
  const Screening rows = screener.run(row, 1);
  CHECK(rows.saturated);  // at the side of the box
  CHECK(coordination_of(row, rows, {}, {}, 50'000'000) == Coordination::endless);
}

TEST_CASE("a run from the bricks on the way ends as the run itself") {
  CHECK(rc::check("of sets whose orders do not matter", [] {
    const Genome genome = both_sides();
    Screener screener({9, 60});
    const auto end = built(genome, screener.run(genome, 3));
    auto bricks = std::vector<PlacedBrick>{{Cell{}, 1}, {Cell{1, 0, 0}, 2}};
    for (const ScreenedBrick& b :
         screener.run_from(genome, bricks, *rc::gen::arbitrary<std::uint64_t>()).placed) {
      bricks.push_back({b.at, b.brick});
    }
    std::sort(bricks.begin(), bricks.end());
    RC_ASSERT(bricks == end);
  }));
}

TEST_CASE("bricks outside the box are left out of a run") {
  Screener screener({3, 60});
  const Genome genome = both_sides();
  const Screening run = screener.run_from(genome, {{Cell{50, 0, 0}, 1}}, 1);
  CHECK(run.placed.empty());
  CHECK(run.saturated);
}

TEST_CASE("law: mending gives a parent that came to a halt the rule that it lacks") {
  CHECK(rc::check("the missing brick's site is open afterwards", [] {
    Genome genome = both_sides();
    // Beside bricks of colour 3, of which there are none.
    genome.rules = {beside({-1, 0, 0}, 3, 1), beside({0, 0, 1}, 3, 2)};
    Screener screener({9, 60});
    const Screening run = screener.run(genome, 1);
    RC_ASSERT(run.placed.empty());
    DrawSettings settings;
    Random random(*rc::gen::arbitrary<std::uint64_t>(), 0, Purpose::test, 0, 0);
    const std::vector<PlacedBrick> other = {{Cell{}, 1}, {Cell{0, 0, 1}, 2}};
    const auto child = mend(settings, {genome, run}, other, random);
    RC_ASSERT(child.has_value());
    RC_ASSERT(child->rules.size() == genome.rules.size());
    RC_ASSERT(built(*child, screener.run(*child, 1)) == other);
    RC_ASSERT_FALSE(mend(settings, {genome, run}, {{Cell{}, 1}}, random).has_value());
  }));
}

TEST_CASE("distances to a target: turned, moved and coloured it is the same shape") {
  const std::vector<Cell> target = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}};
  const auto distance = [&](const std::vector<PlacedBrick>& bricks) {
    return shape_distance(Lattice::cubic, bricks, target);
  };
  CHECK(distance({{Cell{}, 1}, {Cell{0, 1, 0}, 2}, {Cell{0, 1, 1}, 3}}) == 0);
  CHECK(distance({{Cell{0, -1, -1}, 2}, {Cell{0, 0, -1}, 2}, {Cell{}, 1}}) == 0);
  // Upside down it is another: two cells of four are in both.
  CHECK(distance({{Cell{}, 1}, {Cell{1, 0, 0}, 1}, {Cell{1, 0, -1}, 1}}) == 0.5);
  CHECK(distance({{Cell{}, 1}}) == doctest::Approx(2.0 / 3));
  CHECK(shape_distance(Lattice::cubic, {{Cell{}, 1}}, {}) == 1);
}

}  // namespace stig
