// SPDX-License-Identifier: MIT
// Genomes as text and in their canonical form.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "search/draws.h"

namespace stig {
namespace {

CellGene renamed(CellGene gene, const std::vector<Colour>& names) {
  if (gene == kGeneAnything) return gene;
  CellGene out = gene & (CellGene{1} | kGeneFloor);
  for (std::size_t c = 1; c < names.size(); ++c) {
    if (gene >> c & 1U) out |= CellGene{1} << names[c];
  }
  return out;
}

/// With colour c called names[c].
Genome renamed(Genome genome, const std::vector<Colour>& names) {
  genome.start = names[genome.start];
  for (GeneRule& rule : genome.rules) {
    rule.place = names[rule.place];
    for (CellGene& gene : rule.when) gene = renamed(gene, names);
  }
  return genome;
}

}  // namespace

TEST_CASE("law: a genome's text reads back") {
  CHECK(rc::check("read ∘ print is the identity", [] {
    const Genome genome = random_genome(random_settings()).genome;
    RC_ASSERT(read_genome(genome_text(genome)) == genome);
  }));
}

TEST_CASE("what is no genome's text is refused") {
  DrawSettings settings;
  settings.rules = 2;
  Random random(1, 0, kDrawing, 0, 0);
  DrawnGenome drawn;
  draw_genome(settings, random, drawn);
  const std::string good = genome_text(drawn.genome);
  REQUIRE(read_genome(good).has_value());
  CHECK_FALSE(read_genome(""));
  CHECK_FALSE(read_genome("0 0 0 2 3 0"));  // a start of a third colour
  CHECK_FALSE(read_genome("0 0 0 16 1 0"));
  CHECK_FALSE(read_genome("2 0 0 1 1 0"));
  CHECK_FALSE(read_genome(good + " 1"));
  CHECK_FALSE(read_genome(good.substr(0, good.size() - 4)));
  CHECK(read_genome("0 0 0 1 1 0")->rules.empty());
  // A rule that asks for no brick.
  std::string anything = "0 0 0 1 1 1 1 0 0";
  for (int i = 0; i < kMaxNeighbours; ++i) anything += " 1ffff";
  CHECK_FALSE(read_genome(anything));
}

TEST_CASE("law: the hash of a genome does not depend on what colours are called") {
  CHECK(rc::check("hash and canonical form, colours permuted", [] {
    const Genome genome = random_genome(random_settings()).genome;
    std::vector<Colour> names(static_cast<std::size_t>(genome.colours) + 1);
    std::iota(names.begin(), names.end(), Colour{0});
    const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1000);
    Random random(seed, 0, Purpose::test, 0, 0);
    for (std::size_t c = names.size() - 1; c > 1; --c) {
      std::swap(names[c], names[1 + random.below(c)]);
    }
    const Genome other = renamed(genome, names);
    RC_ASSERT(canonical(other) == canonical(genome));
    RC_ASSERT(genome_hash(other) == genome_hash(genome));
    RC_ASSERT(canonical(canonical(genome)) == canonical(genome));
  }));
}

TEST_CASE("law: the hash of a genome notices a change of any rule") {
  CHECK(rc::check("another height, another pattern, another colour", [] {
    const Genome genome = random_genome(random_settings()).genome;
    Genome other = genome;
    GeneRule& rule = other.rules[*rc::gen::inRange<std::size_t>(0, other.rules.size())];
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        rule.height_max = rule.height_max == 7 ? 8 : 7;
        break;
      case 1:
        rule.when[0] = rule.when[0] == 1 ? kGeneAnything : CellGene{1};
        break;
      default:
        rule.height_min = rule.height_min == -3 ? -4 : -3;
    }
    RC_ASSERT(genome_hash(other) != genome_hash(genome));
  }));
}

TEST_CASE("bricks have the names that blocks show, as the compiler asks for") {
  Genome genome;
  genome.colours = 3;
  const RuleSet set = rule_set_of(genome);
  REQUIRE(set.bricks.size() == 3);
  CHECK(set.bricks[0].led == "Q1");
  CHECK(set.bricks[2].led == "Q3");
}

}  // namespace stig
