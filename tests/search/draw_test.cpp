// SPDX-License-Identifier: MIT
// Random genomes: each rule can fire, and the same numbers draw the same genome.
#include <doctest/doctest.h>

#include "lattice/swarm.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "rules/rule_table.h"
#include "search/draws.h"

namespace stig {
namespace {

bool matches(const RuleTable& table, const View& view, std::int32_t z, std::uint32_t rule) {
  std::vector<Match> found;
  table.matches(view, z, 1, found);
  return std::any_of(found.begin(), found.end(), [&](const Match& m) { return m.rule == rule; });
}

}  // namespace

TEST_CASE("law: a drawn rule matches where its brick went in the imagined growth") {
  CHECK(rc::check("each rule, on the bricks before it", [] {
    const DrawnGenome drawn = random_genome(random_settings());
    const RuleSet rules = rule_set_of(drawn.genome);
    const RuleTable table(rules);
    RC_ASSERT(drawn.imagined.size() == rules.rules.size() + 1);
    Structure structure(rules.lattice);
    structure.place(drawn.imagined[0].at, drawn.imagined[0].brick);
    for (std::uint32_t r = 0; r < rules.rules.size(); ++r) {
      const PlacedBrick& next = drawn.imagined[r + 1];
      RC_ASSERT(next.brick == rules.rules[r].place);
      RC_ASSERT(matches(table, view_at(structure, table, std::nullopt, next.at), next.at.z, r));
      structure.place(next.at, next.brick);
    }
  }));
}

TEST_CASE("law: what is drawn keeps to its settings") {
  CHECK(rc::check("colours, lattice, floor, bricks asked for", [] {
    DrawSettings settings = random_settings();
    settings.symmetry = Symmetry::rotations;
    const Genome genome = random_genome(settings).genome;
    RC_ASSERT(genome.lattice == settings.lattice);
    RC_ASSERT(genome.floor == settings.floor);
    RC_ASSERT(genome.symmetry == Symmetry::rotations);
    RC_ASSERT(static_cast<int>(genome.rules.size()) == settings.rules);
    for (const GeneRule& rule : genome.rules) {
      RC_ASSERT(rule.place >= 1 && rule.place <= settings.colours);
      RC_ASSERT(needs_brick(rule, neighbourhood(genome.lattice).size));
    }
  }));
}

TEST_CASE("without wildcards a pattern says every neighbour's state, with them all the time none") {
  DrawSettings settings;
  Random random(3, 0, kDrawing, 0, 0);
  DrawnGenome drawn;
  const auto open_cells = [&](const GeneRule& rule) {
    return std::count(rule.when.begin(), rule.when.end(), kGeneAnything);
  };
  settings.wildcards = 0;
  draw_genome(settings, random, drawn);
  for (const GeneRule& rule : drawn.genome.rules) CHECK(open_cells(rule) == 0);
  settings.wildcards = 1;
  draw_genome(settings, random, drawn);
  for (const GeneRule& rule : drawn.genome.rules) CHECK(open_cells(rule) == kMaxNeighbours - 1);
}

TEST_CASE("law: what a genome stands for is a sound file of rules") {
  CHECK(rc::check("printed and read again", [] {
    const RuleSet rules = rule_set_of(random_genome(random_settings()).genome);
    Diagnostics diagnostics;
    const auto source = std::make_shared<SourceFile>("found.yaml", print_rule_set(rules));
    const auto again = read_rule_set(source, diagnostics);
    RC_ASSERT(again.has_value());
    RC_ASSERT(rule_set_hash(*again) == rule_set_hash(rules));
  }));
}

}  // namespace stig
