// SPDX-License-Identifier: MIT
// The fast event engine against the one for all worlds.
#include <doctest/doctest.h>

#include "lattice/swarm.h"
#include "search/draws.h"
#include "search/screen.h"

namespace stig {
namespace {

std::vector<ScreenedBrick> by_the_swarm(const Genome& genome, const ScreenConfig& screen,
                                        std::uint64_t seed, SwarmResult& result) {
  const RuleSet rules = rule_set_of(genome);
  SwarmConfig config;
  config.motion = Motion::event;
  config.seed = seed;
  config.max_deposits = screen.most_deposits;
  config.box = lay_box({{screen.side, screen.side, screen.side}, std::nullopt, false}, rules.start,
                       rules.floor);
  std::vector<ScreenedBrick> placed;
  SwarmHooks hooks;
  hooks.deposit = [&](const Deposit& d) { placed.push_back({d.site, d.colour, d.match.rule}); };
  result = run_swarm(RuleTable(rules), rules.start, config, hooks);
  return placed;
}

}  // namespace

TEST_CASE("law: a screening is the run that the event engine makes") {
  CHECK(rc::check("deposits, their rules and the end", [] {
    const ScreenConfig config{*rc::gen::inRange(1, 21), *rc::gen::inRange<std::uint64_t>(0, 300)};
    Screener screener(config);
    // One screener for several genomes: nothing of a run may be left for the next.
    for (int run = 0; run < 3; ++run) {
      const Genome genome = random_genome(random_settings()).genome;
      const auto seed = *rc::gen::arbitrary<std::uint64_t>();
      SwarmResult expected;
      const auto placed = by_the_swarm(genome, config, seed, expected);
      const Screening& found = screener.run(genome, seed);
      RC_ASSERT(found.placed == placed);
      RC_ASSERT(found.saturated == (expected.terminated == Terminated::saturated));
      RC_ASSERT(built(genome, found) == expected.structure.bricks());
      for (std::size_t r = 0; r < genome.rules.size(); ++r) {
        RC_ASSERT(found.fired[r] == expected.rules[r].fired);
      }
    }
  }));
}

TEST_CASE("open sites are counted before each deposit") {
  // One rule, "beside a brick of colour 1 to the west, place colour 1": a row with one open site.
  Genome genome;
  GeneRule rule;
  rule.when.fill(kGeneAnything);
  rule.when[static_cast<std::size_t>(neighbourhood(Lattice::cubic).index_of({-1, 0, 0}))] = 2;
  genome.rules = {rule};
  Screener screener({20, 500});
  const Screening& run = screener.run(genome, 1);
  CHECK(run.saturated);
  CHECK(run.placed.size() == 10);  // to the side of the box
  CHECK(run.open_sites == 10);
  genome.symmetry = Symmetry::rotations;
  CHECK(screener.run(genome, 1).open_sites > 400);
}

}  // namespace stig
