// SPDX-License-Identifier: MIT
// A rule set as a search changes it: a list of rules without names, colours without looks.
//
// A genome has what a search can vary and no more: lattice, floor, one start brick at the
// origin, symmetry as a gene, and rules that place a colour where a pattern and two bounds of
// the height hold. It is no rule set of its own kind: rule_set_of makes the RuleSet that it
// stands for, which all other parts of the toolkit read. What it leaves out (counts, stages,
// probabilities, weights) no operator would know how to keep alive.
//
// Sets of states are 17 bits and not the 64 of rules/state.h, so that a candidate of twenty
// rules is 2.5 kB and is drawn, compared and hashed in microseconds.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rules/rule_set.h"
#include "search/uses.h"

namespace stig::search {

inline constexpr int kMostGenomeColours = 15;
inline constexpr std::size_t kMostGenomeRules = 64;

/// States that a neighbour may show: bit 0 empty, 1..15 the colours, 16 the floor.
using CellGene = std::uint32_t;
inline constexpr CellGene kGeneFloor = CellGene{1} << 16;
inline constexpr CellGene kGeneAnything = (CellGene{1} << 17) - 1;

/// Bounds of a height that every site has.
inline constexpr std::int32_t kNoHeightMin = std::numeric_limits<std::int32_t>::min();
inline constexpr std::int32_t kNoHeightMax = std::numeric_limits<std::int32_t>::max();

struct GeneRule {
  Colour place = 1;
  std::int32_t height_min = kNoHeightMin, height_max = kNoHeightMax;  ///< inclusive
  std::array<CellGene, kMaxNeighbours> when{};  ///< unused ones hold kGeneAnything
  auto operator<=>(const GeneRule&) const = default;
};

struct Genome {
  Lattice lattice = Lattice::cubic;
  bool floor = false;
  Symmetry symmetry = Symmetry::none;
  int colours = 1;   ///< 1..kMostGenomeColours
  Colour start = 1;  ///< of the brick at (0, 0, 0)
  std::vector<GeneRule> rules;
  bool operator==(const Genome&) const = default;
};

/// Does some neighbour have to show a brick? A rule acts beside bricks alone, and a search knows
/// where to try it only when it says beside which.
bool needs_brick(const GeneRule& rule, int neighbours);

/// The rule set with `conflicts: first`: where two rules match, the earlier one in the list acts,
/// so that the order of rules is a gene too.
RuleSet rule_set_of(const Genome& genome);

/// The genome with its colours numbered in the order in which they are first met (the start, then
/// what rules place and ask for, rule by rule), and without those that occur nowhere. Equal for
/// genomes that differ by names of colours alone; translations do not arise, as the start brick
/// is at the origin.
Genome canonical(const Genome& genome);
/// Of the canonical form: the same on every machine.
std::uint64_t genome_hash(const Genome& genome);

/// One line of text for the genome and one for each rule; reading it back gives an equal genome.
std::string genome_text(const Genome& genome);
/// Nothing when the text is no genome.
std::optional<Genome> read_genome(std::string_view text);

}  // namespace stig::search
