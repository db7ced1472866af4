// SPDX-License-Identifier: MIT
#include "compiler/target_states.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "base/hash.h"

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

std::size_t BrickSet::count() const {
  std::size_t out = 0;
  for (const std::uint64_t word : words_) out += static_cast<std::size_t>(std::popcount(word));
  return out;
}

std::uint64_t BrickSet::hash() const {
  std::uint64_t out = 0;
  for (const std::uint64_t word : words_) out = combine(out, word);
  return out;
}

std::uint32_t brick_added(const BrickSet& before, const BrickSet& after, std::size_t bricks) {
  std::uint32_t i = 0;
  while (i < bricks && before.has(i) == after.has(i)) ++i;
  return i;
}

TargetStates::TargetStates(const RuleSet& rules, const VerifyResult& proof)
    : rules_(&rules), model_(std::make_unique<Model>(rules, proof.run)) {
  assert(proof.verdict == ProofVerdict::proved);
  const auto add = [this](Cell cell, Colour colour) {
    numbers_[cell] = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back(cell);
    colours_.push_back(colour);
  };
  for (const PlacedBrick& brick : rules.start) add(brick.at, brick.brick);
  start_ = cells_.size();
  for (const Deposit& deposit : proof.run) add(deposit.site, deposit.colour);
  const auto by_level = [](const Cell& a, const Cell& b) { return a.z < b.z; };
  const auto [low, high] = std::minmax_element(cells_.begin(), cells_.end(), by_level);
  floor_level_ = low->z;
  levels_ = high->z - low->z + 1;
}

TargetStates::TargetStates(TargetStates&&) noexcept = default;
TargetStates::~TargetStates() = default;

BrickSet TargetStates::start() const {
  BrickSet out(bricks());
  for (std::size_t i = 0; i < start_; ++i) out.add(i);
  return out;
}

std::optional<std::uint32_t> TargetStates::rule_for(const BrickSet& state,
                                                    std::size_t brick) const {
  if (brick < start_ || state.has(brick)) return std::nullopt;
  const StageSite& site = model_->sites[brick - start_];
  Mask around = 0;
  for (Mask rest = site.bricks; rest != 0; rest &= rest - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(rest));
    if (state.has(start_ + site.brick[k])) around |= bit(static_cast<int>(k));
  }
  if (around == 0 && !site.beside) return std::nullopt;
  for (const LocalRule& rule : site.rules) {
    if (rule.colour == site.colour && rule.matches(around)) return rule.source.rule;
  }
  return std::nullopt;
}

std::vector<std::uint32_t> TargetStates::open(const BrickSet& state) const {
  std::vector<std::uint32_t> out;
  for (std::size_t i = start_; i < bricks(); ++i) {
    if (rule_for(state, i)) out.push_back(static_cast<std::uint32_t>(i));
  }
  return out;
}

Structure TargetStates::structure(const BrickSet& state) const {
  Structure out(rules_->lattice);
  for (std::size_t i = 0; i < bricks(); ++i) {
    if (state.has(i)) out.place(cells_[i], colours_[i]);
  }
  return out;
}

}  // namespace stig
