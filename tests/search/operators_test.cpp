// SPDX-License-Identifier: MIT
// Mutation and crossover keep genomes sound, and change what they say they change.
#include <doctest/doctest.h>

#include "search/draws.h"
#include "search/operators.h"

namespace stig {
namespace {

bool sound(const Genome& genome) { return read_genome(genome_text(genome)) == genome; }

}  // namespace

TEST_CASE("law: children are genomes with as many rules as their first parent") {
  CHECK(rc::check("mutants and crosses", [] {
    const DrawSettings settings = random_settings();
    const Genome one = random_genome(settings).genome, two = random_genome(settings).genome;
    Screener screener({12, 80});
    const Screening first = screener.run(one, 1);
    const Screening second = screener.run(two, 1);
    Random random(*rc::gen::arbitrary<std::uint64_t>(), 0, Purpose::test, 0, 0);
    const Genome mutant = mutate(settings, {one, first}, random);
    RC_ASSERT(sound(mutant));
    RC_ASSERT(mutant.rules.size() == one.rules.size());
    const Genome cross = cross_over({one, first}, {two, second}, random);
    RC_ASSERT(sound(cross));
    RC_ASSERT(cross.rules.size() == one.rules.size());
    for (const GeneRule& rule : cross.rules) {
      const auto has = [&](const Genome& parent) {
        return std::find(parent.rules.begin(), parent.rules.end(), rule) != parent.rules.end();
      };
      RC_ASSERT((has(one) || has(two)));
    }
  }));
}

TEST_CASE("mutants mostly differ in rules that never fired") {
  DrawSettings settings;
  settings.symmetry = Symmetry::none;
  Screener screener({20, 500});
  int idle_changed = 0, busy_changed = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed, 0, kDrawing, 0, 0);
    DrawnGenome drawn;
    draw_genome(settings, random, drawn);
    const Screening& run = screener.run(drawn.genome, seed);
    const Genome mutant = mutate(settings, {drawn.genome, run}, random);
    for (std::size_t r = 0; r < mutant.rules.size(); ++r) {
      if (mutant.rules[r] == drawn.genome.rules[r]) continue;
      ++(run.fired[r] == 0 ? idle_changed : busy_changed);
    }
  }
  CHECK(idle_changed > 2 * busy_changed);
  CHECK(busy_changed > 0);
}

}  // namespace stig
