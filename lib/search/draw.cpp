// SPDX-License-Identifier: MIT
// Rules from an imagined growth (see the header). Growths have a few dozen bricks, so views are
// gathered by a look at each of them.
#include "search/draw.h"

#include <algorithm>
#include <cassert>

namespace stig::search {
namespace {

/// True with a chance given in 2^-32: one word, where unit() takes two.
bool happens(double chance, Random& random) {
  return static_cast<double>(random.next()) < chance * 0x1p32;
}

std::uint32_t pick(std::uint32_t bound, Random& random) {
  return static_cast<std::uint32_t>(std::uint64_t{random.next()} * bound >> 32);
}

/// The index of the k-th neighbour that shares a face.
std::size_t face(const Neighbourhood& n, std::uint32_t k) {
  std::size_t i = 0;
  while (!n.is_face[i] || k-- > 0) ++i;
  return i;
}

/// What is seen from a free site, as sets of one state; nothing where a brick is in the site.
bool look(const DrawSettings& settings, const std::vector<PlacedBrick>& bricks, Cell site,
          std::array<CellGene, kMaxNeighbours>& seen) {
  const Neighbourhood& n = neighbourhood(settings.lattice);
  seen.fill(kGeneAnything);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    seen[i] = settings.floor && site.z + n.offsets[i].z < 0 ? kGeneFloor : CellGene{1};
  }
  for (const PlacedBrick& brick : bricks) {
    const Offset from = brick.at - site;
    if (from == Offset{}) return false;
    const int index = n.index_of(from);
    if (index >= 0) seen[static_cast<std::size_t>(index)] = CellGene{1} << brick.brick;
  }
  return true;
}

/// The brick that the site was found by stays as it is, so that a brick is needed.
void loosen(const DrawSettings& settings, int anchor, GeneRule& rule, Random& random) {
  const int size = neighbourhood(settings.lattice).size;
  for (int i = 0; i < size; ++i) {
    if (i == anchor || !happens(settings.wildcards, random)) continue;
    rule.when[static_cast<std::size_t>(i)] = kGeneAnything;
  }
}

}  // namespace

std::optional<DrawnRule> draw_rule(const DrawSettings& settings,
                                   const std::vector<PlacedBrick>& bricks, Random& random) {
  assert(!bricks.empty());
  const Neighbourhood& n = neighbourhood(settings.lattice);
  DrawnRule drawn;
  // Most bricks of a growth have a free side, and the sides of one are soon tried.
  for (int tries = 0; tries < 64; ++tries) {
    const PlacedBrick& beside = bricks[pick(static_cast<std::uint32_t>(bricks.size()), random)];
    const std::size_t side = face(n, pick(static_cast<std::uint32_t>(n.faces), random));
    drawn.site = beside.at + n.offsets[side];
    if (settings.floor && drawn.site.z < 0) continue;
    if (!look(settings, bricks, drawn.site, drawn.rule.when)) continue;
    loosen(settings, n.opposite(static_cast<int>(side)), drawn.rule, random);
    drawn.rule.place =
        static_cast<Colour>(1 + pick(static_cast<std::uint32_t>(settings.colours), random));
    if (happens(settings.heights, random)) {
      (pick(2, random) == 0 ? drawn.rule.height_min : drawn.rule.height_max) = drawn.site.z;
    }
    return drawn;
  }
  return std::nullopt;
}

std::optional<GeneRule> rule_for(const DrawSettings& settings,
                                 const std::vector<PlacedBrick>& bricks,
                                 const PlacedBrick& wanted) {
  GeneRule rule;
  rule.place = wanted.brick;
  if (settings.floor && wanted.at.z < 0) return std::nullopt;
  if (!look(settings, bricks, wanted.at, rule.when)) return std::nullopt;
  if (!needs_brick(rule, neighbourhood(settings.lattice).size)) return std::nullopt;
  return rule;
}

void draw_genome(const DrawSettings& settings, Random& random, DrawnGenome& out) {
  assert(settings.colours >= 1 && settings.colours <= kMostGenomeColours);
  assert(settings.rules >= 1 && static_cast<std::size_t>(settings.rules) <= kMostGenomeRules);
  Genome& genome = out.genome;
  genome.lattice = settings.lattice;
  genome.floor = settings.floor;
  genome.symmetry = settings.symmetry.value_or(static_cast<Symmetry>(pick(3, random)));
  genome.colours = settings.colours;
  genome.start =
      static_cast<Colour>(1 + pick(static_cast<std::uint32_t>(settings.colours), random));
  genome.rules.clear();
  out.imagined.assign(1, {Cell{}, genome.start});
  while (genome.rules.size() < static_cast<std::size_t>(settings.rules)) {
    const auto drawn = draw_rule(settings, out.imagined, random);
    if (!drawn) continue;  // by bad luck alone: a finite growth has free sides
    genome.rules.push_back(drawn->rule);
    out.imagined.push_back({drawn->site, drawn->rule.place});
  }
}

}  // namespace stig::search
