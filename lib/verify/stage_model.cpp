// SPDX-License-Identifier: MIT
// Reduces the rules to functions of a site's local state. While a stage lasts, everything
// around a site but this stage's bricks is fixed, so an oriented pattern becomes two masks
// (needed, forbidden) and a count becomes popcounts of masks. All proofs then work on
// 32-bit masks. The model says nothing of what is reachable; it holds whichever bricks of
// the run are there.
#include "verify/stage_model.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace stig::verify {

/// Over layers, since in a narrow periodic box one brick can be a neighbour several times
/// and then counts as often.
bool LocalCount::holds(Mask state) const {
  int number = always;
  for (const Layer& layer : layers) {
    number += std::popcount(state & layer.if_filled) + std::popcount(~state & layer.if_empty);
  }
  return number >= min && number <= max;
}

/// Sufficient: a brick may only raise the number (no layer counts an absence alone), and
/// all bricks together do not exceed the maximum.
bool LocalCount::holds_from(Mask state) const {
  int most = always;
  for (const Layer& layer : layers) {
    if ((layer.if_empty & ~layer.if_filled) != 0) return false;
    most += std::popcount(layer.if_filled);
  }
  return holds(state) && most <= max;
}

/// Each layer holds a brick at most once; further occurrences go to further layers.
void LocalCount::add(Mask bit, bool filled, bool empty) {
  const auto free = [&](const Layer& layer) {
    return ((layer.if_filled | layer.if_empty) & bit) == 0;
  };
  if (!filled && !empty) return;
  auto layer = std::find_if(layers.begin(), layers.end(), free);
  if (layer == layers.end()) layer = layers.insert(layers.end(), Layer{});
  if (filled) layer->if_filled |= bit;
  if (empty) layer->if_empty |= bit;
}

bool LocalRule::matches(Mask state) const {
  if ((state & need) != need || (state & forbid) != 0) return false;
  return std::all_of(counts.begin(), counts.end(),
                     [&](const LocalCount& count) { return count.holds(state); });
}

/// A brick that counts both filled and empty makes no difference, hence the exclusive or.
Mask LocalRule::sees() const {
  Mask seen = need | forbid;
  for (const LocalCount& count : counts) {
    for (const LocalCount::Layer& layer : count.layers) seen |= layer.if_filled ^ layer.if_empty;
  }
  return seen;
}

StageModel::StageModel(const RuleSet& rules, const RuleTable& table, const LatticeWorld& before,
                       const std::vector<Deposit>& run)
    : rules_(&rules),
      table_(&table),
      before_(&before),
      run_(&run),
      index_(rules, table, before.stage()) {
  const Neighbourhood& n = table.neighbours();
  // For chains of neighbours of neighbours; -1 marks those out of sight.
  for (auto& row : two_steps_) row.fill(-1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(n.size); ++j) {
      const Offset sum = n.offsets[i] + n.offsets[j];
      two_steps_[i][j] = static_cast<std::int8_t>(sum == Offset{} ? kSelf : n.index_of(sum));
    }
  }
  for (std::uint32_t i = 0; i < run.size(); ++i) {
    assert(numbers_.at(run[i].site) == kNone);  // each site is filled once
    numbers_[run[i].site] = i;
  }
  number_border();
}

/// Border cells are those where a brick could be placed wrongly. Cells outside the box,
/// floor and earlier bricks are none.
void StageModel::number_border() {
  const Neighbourhood& n = table_->neighbours();
  for (const Deposit& deposit : *run_) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      const Cell cell = before_->wrap(deposit.site + n.offsets[i]);
      if (numbers_.at(cell) != kNone || !before_->placeable(cell)) continue;
      if (before_->at(cell) != kEmpty) continue;
      numbers_[cell] = static_cast<std::uint32_t>(bricks() + border_.size());
      border_.push_back(cell);
    }
  }
}

void StageModel::look(std::uint32_t number, StageSite& out) const {
  assert(number < sites());
  const Neighbourhood& n = table_->neighbours();
  out.at = at(number);
  out.number = number;
  out.colour = number < bricks() ? (*run_)[number].colour : Colour{0};
  out.bricks = 0;
  out.rules.clear();
  // The view of the world before the stage: all of the stage's own bricks are still missing
  // in it.
  View fixed = before_->view(out.at);
  PossibleStates possible;
  std::array<std::int8_t, kMaxNeighbours> alias{};
  const bool small = before_->box() && before_->box()->periodic;
  out.beside = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    alias[i] = static_cast<std::int8_t>(i);
    possible[i] = StateSet::of(fixed.at[i]);
    out.beside = out.beside || is_brick(fixed.at[i]);
    if (fixed.at[i] != kEmpty) continue;
    const std::uint32_t brick = this->number(out.at + n.offsets[i]);
    // A cell that is its own neighbour (periodic box of side 1) stays empty while the site
    // is.
    if (brick >= bricks() || brick == number) continue;
    possible[i] = possible[i] | StateSet::of((*run_)[brick].colour);
    // The loop over earlier indices runs in periodic boxes alone; elsewhere neighbours are
    // distinct.
    for (std::size_t k = 0; small && k < i; ++k) {
      if ((out.bricks & bit(static_cast<int>(k))) == 0 || out.brick[k] != brick) continue;
      alias[i] = static_cast<std::int8_t>(k);
      break;
    }
    out.brick[i] = brick;
    if (alias[i] == static_cast<std::int8_t>(i)) out.bricks |= bit(static_cast<int>(i));
  }
  index_.possible(possible, out.at.z, possible_);
  for (const std::uint32_t e : possible_) {
    LocalRule rule = local_rule(table_->entries()[e], out, fixed, alias);
    // An entry that needs and forbids the same brick was admitted by the index, which looks
    // at neighbours one by one, but matches never.
    if ((rule.need & rule.forbid) == 0) out.rules.push_back(std::move(rule));
  }
}

LocalRule StageModel::local_rule(const Entry& entry, const StageSite& site, const View& fixed,
                                 const std::array<std::int8_t, kMaxNeighbours>& alias) const {
  const Neighbourhood& n = table_->neighbours();
  LocalRule rule;
  rule.source = entry.source;
  rule.colour = table_->place(entry.source.rule);
  const auto is_stage_brick = [&](std::size_t i) {
    return (site.bricks >> static_cast<unsigned>(alias[i]) & 1U) != 0;
  };
  const auto colour = [&](std::size_t i) {
    return (*run_)[site.brick[static_cast<std::size_t>(alias[i])]].colour;
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    if (!is_stage_brick(i)) continue;
    if (!entry.pattern.allowed[i].contains(kEmpty)) rule.need |= bit(alias[i]);
    if (!entry.pattern.allowed[i].contains(colour(i))) rule.forbid |= bit(alias[i]);
  }
  for (const CountCondition& condition : rules_->rules[entry.source.rule].counts) {
    LocalCount count;
    count.min = condition.min;
    count.max = condition.max;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      if (condition.faces_only && !n.is_face[i]) continue;
      if (!is_stage_brick(i)) {
        count.always += condition.of.contains(fixed.at[i]) ? 1 : 0;
        continue;
      }
      count.add(bit(alias[i]), condition.of.contains(colour(i)), condition.of.contains(kEmpty));
    }
    rule.counts.push_back(count);
  }
  return rule;
}

/// Weights and probabilities are ignored on purpose: whatever may happen counts.
std::uint64_t colours_placed(const StageModel& model, const StageSite& site, Mask state,
                             bool beside) {
  std::uint64_t colours = 0;
  if (!beside && state == 0) return 0;
  for (const LocalRule& rule : site.rules) {
    if (!rule.matches(state)) continue;
    colours |= std::uint64_t{1} << rule.colour;
    if (model.first_acts()) return colours;
  }
  return colours;
}

}  // namespace stig::verify
