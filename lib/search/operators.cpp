// SPDX-License-Identifier: MIT
// Mutation and crossover (see the header).
#include "search/operators.h"

#include <algorithm>
#include <cassert>

namespace stig::search {
namespace {

/// The rules that fired not at all, or all if each did or chance wants any.
std::size_t rule_to_change(const Parent& parent, Random& random) {
  std::vector<std::size_t> idle;
  for (std::size_t r = 0; r < parent.run.fired.size(); ++r) {
    if (parent.run.fired[r] == 0) idle.push_back(r);
  }
  const std::size_t rules = parent.genome.rules.size();
  if (idle.empty() || random.below(4) == 0) return random.below(rules);
  return idle[random.below(idle.size())];
}

/// One neighbour's states: a wildcard, nothing, or one colour.
void change_cell(const DrawSettings& settings, GeneRule& rule, Random& random) {
  const auto size = static_cast<std::size_t>(neighbourhood(settings.lattice).size);
  CellGene& gene = rule.when[random.below(size)];
  switch (random.below(3)) {
    case 0:
      gene = kGeneAnything;
      break;
    case 1:
      gene = 1;
      break;
    default:
      gene = CellGene{1} << (1 + random.below(static_cast<std::uint64_t>(settings.colours)));
  }
}

void change_rule(const DrawSettings& settings, const Parent& parent, Genome& child,
                 Random& random) {
  const std::size_t number = rule_to_change(parent, random);
  GeneRule& rule = child.rules[number];
  const GeneRule before = rule;
  switch (random.below(6)) {
    case 0:
      change_cell(settings, rule, random);
      break;
    case 1:
      rule.place =
          static_cast<Colour>(1 + random.below(static_cast<std::uint64_t>(settings.colours)));
      break;
    case 2:
      std::swap(rule, child.rules[random.below(child.rules.size())]);
      return;
    default:
      if (const auto drawn = draw_rule(settings, built(parent.genome, parent.run), random)) {
        rule = drawn->rule;
      }
  }
  if (!needs_brick(rule, neighbourhood(settings.lattice).size)) rule = before;
}

/// The rules that fired in the order in which they first did, then the others.
std::vector<std::uint32_t> by_first_firing(const Parent& parent) {
  std::vector<std::uint32_t> order;
  std::vector<bool> met(parent.genome.rules.size(), false);
  const auto meet = [&](std::uint32_t rule) {
    if (!met[rule]) order.push_back(rule);
    met[rule] = true;
  };
  for (const ScreenedBrick& brick : parent.run.placed) meet(brick.rule);
  for (std::uint32_t r = 0; r < met.size(); ++r) meet(r);
  return order;
}

/// The chosen rules in the order of their genome, which decides between rules that both match.
void append(const Genome& from, std::vector<std::uint32_t> chosen, Genome& child) {
  std::sort(chosen.begin(), chosen.end());
  for (const std::uint32_t r : chosen) child.rules.push_back(from.rules[r]);
}

/// Rules for the sites that the other end has filled and the parent's has not.
std::vector<GeneRule> missing_rules(const DrawSettings& settings,
                                    const std::vector<PlacedBrick>& end,
                                    const std::vector<PlacedBrick>& other_end) {
  std::vector<GeneRule> rules;
  for (const PlacedBrick& wanted : other_end) {
    if (const auto rule = rule_for(settings, end, wanted)) rules.push_back(*rule);
  }
  return rules;
}

}  // namespace

std::optional<Genome> mend(const DrawSettings& settings, const Parent& parent,
                           const std::vector<PlacedBrick>& other_end, Random& random) {
  std::vector<std::size_t> idle;
  for (std::size_t r = 0; r < parent.run.fired.size(); ++r) {
    if (parent.run.fired[r] == 0) idle.push_back(r);
  }
  const auto rules = missing_rules(settings, built(parent.genome, parent.run), other_end);
  if (idle.empty() || rules.empty()) return std::nullopt;
  Genome child = parent.genome;
  child.rules[idle[random.below(idle.size())]] = rules[random.below(rules.size())];
  return child;
}

Genome mutate(const DrawSettings& settings, const Parent& parent, Random& random) {
  Genome child = parent.genome;
  if (child.rules.empty()) return child;
  if (!settings.symmetry && random.below(16) == 0) {
    child.symmetry = static_cast<Symmetry>(random.below(3));
  }
  const std::uint64_t changes = 1 + random.below(4);
  for (std::uint64_t i = 0; i < changes; ++i) change_rule(settings, parent, child, random);
  return child;
}

Genome cross_over(const Parent& early, const Parent& late, Random& random) {
  assert(early.genome.lattice == late.genome.lattice && early.genome.floor == late.genome.floor &&
         early.genome.colours == late.genome.colours);
  std::vector<std::uint32_t> first = by_first_firing(early), last = by_first_firing(late);
  const std::size_t rules = first.size();
  const std::size_t kept = std::min(rules, 1 + static_cast<std::size_t>(random.below(rules + 1)));
  const std::size_t taken = std::min(rules - kept, last.size());
  // Rules that never fired stand behind the others, and belong to no stage: of the other parent's
  // those are taken that fired last.
  const auto fired = static_cast<std::size_t>(std::count_if(
      late.run.fired.begin(), late.run.fired.end(), [](std::uint64_t n) { return n > 0; }));
  const std::size_t end = std::max(fired, taken);
  Genome child = early.genome;
  child.rules.clear();
  append(early.genome, {first.begin(), first.begin() + static_cast<std::ptrdiff_t>(kept)}, child);
  append(late.genome,
         {last.begin() + static_cast<std::ptrdiff_t>(end - taken),
          last.begin() + static_cast<std::ptrdiff_t>(end)},
         child);
  return child;
}

}  // namespace stig::search
