// SPDX-License-Identifier: MIT
// Genomes as rule sets, in a canonical form, and as text.
#include "search/genome.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/hash.h"
#include "base/led_name.h"
#include "lattice/rgb.h"

namespace stig::search {
namespace {

constexpr CellGene kGeneColours = kGeneAnything & ~CellGene{1} & ~kGeneFloor;

StateSet states_of(CellGene gene) {
  if (gene == kGeneAnything) return StateSet::anything();
  const StateSet floor = gene & kGeneFloor ? StateSet::floor() : StateSet();
  return StateSet(gene & ~kGeneFloor) | floor;
}

Rule rule_of(const GeneRule& gene, std::size_t number) {
  Rule rule;
  rule.name = fmt::format("r{}", number);
  rule.place = gene.place;
  for (std::size_t i = 0; i < gene.when.size(); ++i) {
    rule.pattern.allowed[i] = states_of(gene.when[i]);
  }
  if (gene.height_min != kNoHeightMin) rule.height_min = gene.height_min;
  if (gene.height_max != kNoHeightMax) rule.height_max = gene.height_max;
  return rule;
}

/// Numbers colours in the order in which they are met.
class Renaming {
 public:
  void meet(Colour colour) {
    if (new_[colour] == 0) new_[colour] = ++count_;
  }
  void meet_all(CellGene gene) {
    // What accepts every brick, or every one but a few, names no colour in particular.
    if ((gene & kGeneColours) == kGeneColours) return;
    for (Colour c = 1; c <= kMostGenomeColours; ++c) {
      if (gene >> c & 1U) meet(c);
    }
  }
  Colour of(Colour colour) const { return new_[colour]; }
  int count() const { return count_; }
  CellGene of(CellGene gene) const {
    if ((gene & kGeneColours) == kGeneColours) return gene;
    CellGene renamed = gene & ~kGeneColours;
    for (Colour c = 1; c <= kMostGenomeColours; ++c) {
      if (gene >> c & 1U) renamed |= CellGene{1} << new_[c];
    }
    return renamed;
  }

 private:
  std::array<Colour, kMostGenomeColours + 1> new_{};
  Colour count_ = 0;
};

/// Takes words from a text one by one.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}
  std::string_view word() {
    const std::size_t begin = std::min(rest_.find_first_not_of(" \n"), rest_.size());
    const std::size_t end = std::min(rest_.find_first_of(" \n", begin), rest_.size());
    const std::string_view found = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return found;
  }
  std::optional<std::int64_t> number(int base, std::int64_t low, std::int64_t high) {
    const std::string_view text = word();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && value >= low && value <= high ? std::optional(value) : std::nullopt;
  }
  bool done() { return word().empty(); }

 private:
  std::string_view rest_;
};

std::optional<GeneRule> read_rule(Words& words, int colours, int neighbours) {
  GeneRule rule;
  const auto place = words.number(10, 1, colours);
  const auto low = words.number(10, kNoHeightMin, kNoHeightMax);
  const auto high = words.number(10, kNoHeightMin, kNoHeightMax);
  if (!place || !low || !high) return std::nullopt;
  rule.place = static_cast<Colour>(*place);
  rule.height_min = static_cast<std::int32_t>(*low);
  rule.height_max = static_cast<std::int32_t>(*high);
  rule.when.fill(kGeneAnything);
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours); ++i) {
    const auto gene = words.number(16, 1, kGeneAnything);
    if (!gene) return std::nullopt;
    rule.when[i] = static_cast<CellGene>(*gene);
  }
  return needs_brick(rule, neighbours) ? std::optional(rule) : std::nullopt;
}

}  // namespace

bool needs_brick(const GeneRule& rule, int neighbours) {
  return std::any_of(rule.when.begin(), rule.when.begin() + neighbours,
                     [](CellGene gene) { return (gene & (CellGene{1} | kGeneFloor)) == 0; });
}

RuleSet rule_set_of(const Genome& genome) {
  RuleSet set;
  set.name = "found-" + to_hex(genome_hash(genome));
  set.lattice = genome.lattice;
  set.symmetry = genome.symmetry;
  set.floor = genome.floor;
  set.conflicts = Conflicts::first;
  set.bricks = numbered_bricks(genome.colours);
  // As blocks show them, so that a find can go to the compiler as it is.
  for (std::size_t i = 0; i < set.bricks.size(); ++i) set.bricks[i].led = kLedNames[i + 1];
  set.start = {{Cell{}, genome.start}};
  for (const GeneRule& gene : genome.rules) {
    set.rules.push_back(rule_of(gene, set.rules.size() + 1));
  }
  return set;
}

Genome canonical(const Genome& genome) {
  Renaming names;
  names.meet(genome.start);
  for (const GeneRule& rule : genome.rules) {
    names.meet(rule.place);
    for (const CellGene gene : rule.when) names.meet_all(gene);
  }
  Genome same = genome;
  same.colours = names.count();
  same.start = names.of(genome.start);
  for (GeneRule& rule : same.rules) {
    rule.place = names.of(rule.place);
    for (CellGene& gene : rule.when) gene = names.of(gene);
  }
  return same;
}

std::uint64_t genome_hash(const Genome& genome) {
  const Genome same = canonical(genome);
  std::uint64_t h = hash_text("genome 1");
  const auto add = [&h](std::int64_t value) { h = combine(h, static_cast<std::uint64_t>(value)); };
  add(static_cast<int>(same.lattice));
  add(same.floor);
  add(static_cast<int>(same.symmetry));
  add(same.start);
  for (const GeneRule& rule : same.rules) {
    add(rule.place);
    add(rule.height_min);
    add(rule.height_max);
    for (const CellGene gene : rule.when) add(gene);
  }
  return h;
}

std::string genome_text(const Genome& genome) {
  std::string text = fmt::format("{} {} {} {} {} {}\n", static_cast<int>(genome.lattice),
                                 genome.floor ? 1 : 0, static_cast<int>(genome.symmetry),
                                 genome.colours, genome.start, genome.rules.size());
  const auto size = static_cast<std::size_t>(neighbourhood(genome.lattice).size);
  for (const GeneRule& rule : genome.rules) {
    text += fmt::format("{} {} {}", rule.place, rule.height_min, rule.height_max);
    for (std::size_t i = 0; i < size; ++i) text += fmt::format(" {:x}", rule.when[i]);
    text += '\n';
  }
  return text;
}

std::optional<Genome> read_genome(std::string_view text) {
  Words words(text);
  const auto lattice = words.number(10, 0, 1), floor = words.number(10, 0, 1);
  const auto symmetry = words.number(10, 0, 2);
  const auto colours = words.number(10, 1, kMostGenomeColours);
  const auto start = words.number(10, 1, colours.value_or(0));
  const auto count = words.number(10, 0, kMostGenomeRules);
  if (!lattice || !floor || !symmetry || !start || !count) return std::nullopt;
  Genome genome{static_cast<Lattice>(*lattice),   *floor == 1,
                static_cast<Symmetry>(*symmetry), static_cast<int>(*colours),
                static_cast<Colour>(*start),      {}};
  for (std::int64_t r = 0; r < *count; ++r) {
    const auto rule = read_rule(words, genome.colours, neighbourhood(genome.lattice).size);
    if (!rule) return std::nullopt;
    genome.rules.push_back(*rule);
  }
  return words.done() ? std::optional(std::move(genome)) : std::nullopt;
}

}  // namespace stig::search
