// SPDX-License-Identifier: MIT
// What can be said of one stage before anything is proved: the bricks that a first run
// deposits, and for every site that they concern the rules that could ever act there.
//
// Sites are the bricks, numbered in the order of the run, and after them the border: the
// empty cells beside them. A *local state* of a site is the set of the stage's bricks
// among its neighbours, as a mask over neighbour indices; whatever else is around the
// site (earlier bricks, floor, nothing) stays as it is while the stage lasts.
//
// In a periodic box of a side below three a cell can be a neighbour several times; it
// then has the bit of its lowest index alone.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lattice/cell_map.h"
#include "verify/entry_index.h"
#include "verify/stage_run.h"
#include "verify/uses.h"

namespace stig::verify {

/// A set of neighbour indices.
using Mask = std::uint32_t;
inline constexpr Mask bit(int index) { return Mask{1} << index; }

/// count_in_view as a function of the local state.
struct LocalCount {
  /// Bricks that count, and bricks whose absence does.
  struct Layer {
    Mask if_filled = 0, if_empty = 0;
  };
  int always = 0;             ///< counted whatever the state
  std::vector<Layer> layers;  ///< one; more where a cell is a neighbour several times
  int min = 0, max = 0;

  bool holds(Mask state) const;
  /// Does it hold from a state on, whatever bricks come besides?
  bool holds_from(Mask state) const;
  /// The brick with this bit counts once more in these cases.
  void add(Mask bit, bool filled, bool empty);
};

/// An entry that matches in exactly those local states that have all of `need`, nothing of
/// `forbid`, and satisfy the counts.
struct LocalRule {
  Match source;
  Colour colour = 0;
  Mask need = 0, forbid = 0;
  std::vector<LocalCount> counts;

  bool matches(Mask state) const;
  /// The bricks that make a difference to it.
  Mask sees() const;
};

struct StageSite {
  Cell at;
  std::uint32_t number = 0;
  Colour colour = 0;                                  ///< what the run places here; 0: border
  Mask bricks = 0;                                    ///< neighbours that are bricks of this stage
  std::array<std::uint32_t, kMaxNeighbours> brick{};  ///< their numbers
  bool beside = false;           ///< has a neighbouring brick from before the stage
  std::vector<LocalRule> rules;  ///< by rising rule; none: no rule can ever act
};

class StageModel {
 public:
  /// `before`: the world at the beginning of its present stage; `run`: all of the stage's
  /// deposits in a run that ended. All arguments must outlive the model.
  StageModel(const RuleSet& rules, const RuleTable& table, const LatticeWorld& before,
             const std::vector<Deposit>& run);

  const RuleSet& rules() const { return *rules_; }
  const RuleTable& table() const { return *table_; }
  const LatticeWorld& before() const { return *before_; }
  const std::vector<Deposit>& run() const { return *run_; }
  std::size_t bricks() const { return run_->size(); }
  /// Bricks and border.
  std::size_t sites() const { return bricks() + border_.size(); }
  Cell at(std::uint32_t site) const {
    return site < bricks() ? (*run_)[site].site : border_[site - bricks()];
  }
  /// The site's number, or none.
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::uint32_t number(Cell cell) const { return numbers_.at(before_->wrap(cell)); }

  /// Everything about one site; `out`'s memory is used again.
  void look(std::uint32_t site, StageSite& out) const;
  /// The index seen from a site of the cell at index `second` of its neighbour `first`:
  /// kSelf the site itself, -1 none of its neighbours.
  static constexpr int kSelf = kMaxNeighbours;
  int two_steps(int first, int second) const {
    return two_steps_[static_cast<std::size_t>(first)][static_cast<std::size_t>(second)];
  }
  /// Does only the first of the matching rules act?
  bool first_acts() const { return rules_->conflicts == Conflicts::first; }

 private:
  void number_border();
  LocalRule local_rule(const Entry& entry, const StageSite& site, const View& fixed,
                       const std::array<std::int8_t, kMaxNeighbours>& alias) const;

  const RuleSet* rules_;
  const RuleTable* table_;
  const LatticeWorld* before_;
  const std::vector<Deposit>* run_;
  EntryIndex index_;
  CellMap<std::uint32_t> numbers_{kNone};
  std::vector<Cell> border_;
  std::array<std::array<std::int8_t, kMaxNeighbours>, kMaxNeighbours> two_steps_{};
  mutable std::vector<std::uint32_t> possible_;  ///< saves allocations
};

/// Colours that may be placed at a site in a local state, as a set of colours: under
/// `conflicts: first` that of the first match, else those of all matches. Bit 0 is unused.
/// Rules act beside bricks alone; `beside`: there is one, whatever the state says.
std::uint64_t colours_placed(const StageModel& model, const StageSite& site, Mask state,
                             bool beside);

}  // namespace stig::verify
