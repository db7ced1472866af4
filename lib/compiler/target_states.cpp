// SPDX-License-Identifier: MIT
#include "compiler/target_states.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace stig {

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

std::optional<std::uint32_t> TargetStates::rule_for(const BrickSet& state,
                                                    std::size_t brick) const {
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

}  // namespace stig
