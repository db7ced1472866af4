// SPDX-License-Identifier: MIT
// The structures on the way to a proved one, as sets of its bricks. The rules' local form
// is that of the verifier (verify/stage_model.h), computed once for each brick; what can be
// placed in a structure is then a test of masks.
#include "compiler/target_states.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

namespace stig::compiler {

struct TargetStates::Model {
  RuleTable table;
  LatticeWorld before;
  StageModel stage;
  std::vector<StageSite> sites;  ///< by brick after the start's

  Model(const RuleSet& rules, const std::vector<Deposit>& run)
      : table(rules),
        before(world_at_stage(table, rules.start, std::nullopt, 1)),
        stage(rules, table, before, run),
        sites(run.size()) {
    for (std::uint32_t i = 0; i < run.size(); ++i) stage.look(i, sites[i]);
  }
};

namespace {

/// The start's bricks, then those of the proof's run.
std::vector<PlacedBrick> bricks_of(const RuleSet& rules, const VerifyResult& proof) {
  std::vector<PlacedBrick> out = rules.start;
  for (const Deposit& deposit : proof.run) out.push_back({deposit.site, deposit.colour});
  return out;
}

}  // namespace

TargetStates::TargetStates(const RuleSet& rules, const VerifyResult& proof)
    : TargetBricks(bricks_of(rules, proof), rules.start.size()),
      rules_(&rules),
      model_(std::make_unique<Model>(rules, proof.run)) {
  assert(proof.verdict == ProofVerdict::proved);
}

TargetStates::TargetStates(TargetStates&&) noexcept = default;
TargetStates::~TargetStates() = default;

/// Rules that place another colour are never right in a proved set, and the first that
/// matches is the one to name.
std::optional<std::uint32_t> TargetStates::rule_for(const BrickSet& state,
                                                    std::size_t brick) const {
  assert(brick < bricks());
  if (brick < start_bricks() || state.has(brick)) return std::nullopt;
  const StageSite& site = model_->sites[brick - start_bricks()];
  Mask around = 0;
  for (Mask rest = site.bricks; rest != 0; rest &= rest - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(rest));
    if (state.has(start_bricks() + site.brick[k])) around |= bit(static_cast<int>(k));
  }
  if (around == 0 && !site.beside) return std::nullopt;
  for (const LocalRule& rule : site.rules) {
    if (rule.colour == site.colour && rule.matches(around)) return rule.source.rule;
  }
  return std::nullopt;
}

/// Counts would have to be evaluated for all sets between the two, so rules with counts are
/// left out; that only makes the answer more cautious.
bool TargetStates::due_between(const BrickSet& least, const BrickSet& most,
                               std::size_t brick) const {
  assert(brick < bricks());
  if (brick < start_bricks()) return false;
  const StageSite& site = model_->sites[brick - start_bricks()];
  Mask low = 0, high = 0;
  for (Mask rest = site.bricks; rest != 0; rest &= rest - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(rest));
    if (least.has(start_bricks() + site.brick[k])) low |= bit(static_cast<int>(k));
    if (most.has(start_bricks() + site.brick[k])) high |= bit(static_cast<int>(k));
  }
  if (low == 0 && !site.beside) return false;
  return std::any_of(site.rules.begin(), site.rules.end(), [&](const LocalRule& rule) {
    return rule.colour == site.colour && rule.counts.empty() && (rule.need & ~low) == 0 &&
           (rule.forbid & high) == 0;
  });
}

namespace {

/// Calls with the place of each bit, rising.
template <class Visit>
void for_each_place(Mask mask, const Visit& visit) {
  for (Mask rest = mask; rest != 0; rest &= rest - 1) {
    visit(static_cast<std::size_t>(std::countr_zero(rest)));
  }
}

/// By place, which other neighbours of the site come before the one there.
using Below = std::array<Mask, kMaxNeighbours>;

/// Whatever stands is closed, so no rule ever sees one brick without those that come before it.
bool ever_matches(const LocalRule& rule, const Below& below) {
  bool out = true;
  for_each_place(rule.need, [&](std::size_t k) { out = out && (rule.forbid & below[k]) == 0; });
  return out;
}

}  // namespace

/// Intersections over the rules that place the brick's colour: what all of them need, and
/// what all of them forbid.
Demands TargetStates::demands(std::size_t brick, const ComesBefore& comes_before) const {
  assert(brick >= start_bricks());
  const StageSite& site = model_->sites[brick - start_bricks()];
  const auto number = [&](std::size_t place) {
    return static_cast<std::uint32_t>(start_bricks() + site.brick[place]);
  };
  Below below{};
  Mask after = 0;  ///< what comes after the brick is not there while its site is empty
  for_each_place(site.bricks, [&](std::size_t k) {
    if (comes_before(static_cast<std::uint32_t>(brick), number(k))) {
      after |= bit(static_cast<int>(k));
    }
    for_each_place(site.bricks & ~bit(static_cast<int>(k)), [&](std::size_t j) {
      if (comes_before(number(j), number(k))) below[k] |= bit(static_cast<int>(j));
    });
  });
  Mask always = site.bricks, never = site.bricks;
  for (const LocalRule& rule : site.rules) {
    const bool in_vain = (rule.need & after) != 0 || !ever_matches(rule, below);
    if (rule.colour != site.colour || in_vain) continue;
    always &= rule.need;
    never &= rule.forbid;
  }
  Demands out;
  for_each_place(always, [&](std::size_t k) { out.always.push_back(number(k)); });
  for_each_place(never, [&](std::size_t k) { out.never.push_back(number(k)); });
  return out;
}

std::vector<std::uint32_t> TargetStates::open(const BrickSet& state) const {
  std::vector<std::uint32_t> out;
  for (std::size_t i = start_bricks(); i < bricks(); ++i) {
    if (rule_for(state, i)) out.push_back(static_cast<std::uint32_t>(i));
  }
  return out;
}

Structure TargetStates::structure(const BrickSet& state) const {
  Structure out(rules_->lattice);
  for (std::size_t i = 0; i < bricks(); ++i) {
    if (state.has(i)) out.place(cell(i), colour(i));
  }
  return out;
}

}  // namespace stig::compiler
