// SPDX-License-Identifier: MIT
// What every engine shares: a structure in its box, the rules on it, the stage it
// is in, and the re-evaluation of sites around a new brick. Engines keep their own
// record of which sites are enabled.
#pragma once

#include <optional>
#include <vector>

#include "base/random.h"
#include "lattice/box.h"
#include "lattice/structure.h"
#include "lattice/uses.h"
#include "rules/rule_table.h"

namespace stig::lattice {

/// Of the matches of a site, one or more, the one that acts (see swarm.h); draws from `random` only
/// under `conflicts: random`.
Match chosen(const RuleTable& rules, const std::vector<Match>& matches, Random& random);

class LatticeWorld {
 public:
  LatticeWorld(const RuleTable& rules, const std::vector<PlacedBrick>& start,
               std::optional<Box> box);

  const RuleTable& rules() const { return *rules_; }
  const Structure& structure() const { return structure_; }
  Structure take_structure() { return std::move(structure_); }
  const std::optional<Box>& box() const { return box_; }
  int stage() const { return stage_; }

  /// May a brick ever be placed here: inside the box, not below the floor?
  bool placeable(Cell site) const;
  /// The cell that stands for `site`: wrapped in a periodic box.
  Cell wrap(Cell site) const { return box_ ? box_->wrap(site) : site; }
  State at(Cell cell) const;
  View view(Cell site) const;
  /// Can there be an event: empty, placeable, beside a brick?
  bool is_site(Cell site) const;

  /// Places a brick and calls site(neighbour, view) for every empty, placeable neighbour
  /// to which the new brick can make a difference. Counts the deposit towards the stage's limit.
  template <class Site>
  void deposit(Cell cell, Colour colour, const Site& site) {
    look_at(cell);
    around_.at[kCentre] = colour;
    place(cell, colour);
    for_each_neighbour_view(cell, site);
  }

  /// Places a brick and no more: for engines that see the neighbours for themselves.
  void place(Cell cell, Colour colour) {
    structure_.place(cell, colour);
    around_cell_.reset();
    ++deposits_in_stage_;
  }

  /// Has the stage had its deposits?
  bool stage_spent() const;
  /// Goes to the next stage; false when there is none.
  bool next_stage();
  /// The empty, placeable cells beside a brick, in cell order.
  std::vector<Cell> candidates() const;
  /// Sites that some rule of the present stage matches, in cell order.
  std::vector<Cell> enabled_sites() const;

  /// The rule that acts at an enabled site.
  Match choose(Cell site, Random& random);

 private:
  static constexpr std::size_t kCentre = Surroundings::index(0, 0, 0);

  /// Gathers into around_, unless it holds that cell's surroundings already.
  void look_at(Cell cell);
  /// With around_ at `cell`: visit(neighbour, view) for the empty, placeable neighbours of `cell`.
  template <class Visit>
  void for_each_neighbour_view(Cell cell, const Visit& visit) const;
  /// Does the box's wrapping or floor show in the 5×5×5 around `cell`?
  bool wraps_near(Cell cell) const;
  void gather(Cell cell, Surroundings& out) const;
  /// The view from the site with this index in the surroundings of a cell.
  View view_within(const Surroundings& around, int site) const {
    View view;
    for (std::size_t k = 0; k < size_; ++k) {
      view.at[k] = around.at[static_cast<std::size_t>(site + step_[k])];
    }
    return view;
  }

  const RuleTable* rules_;
  std::size_t size_;  ///< of the neighbourhood
  std::optional<Box> box_;
  Structure structure_;
  int stage_ = 1;
  std::int64_t deposits_in_stage_ = 0;
  /// The surroundings that choose() looked at; deposit() mostly follows in the same cell.
  Surroundings around_;
  std::optional<Cell> around_cell_;
  std::vector<Match> matches_;  ///< saves allocations
  /// Steps between cells of Surroundings, by neighbour index.
  std::array<int, kMaxNeighbours> step_{};
};

template <class Visit>
void LatticeWorld::for_each_neighbour_view(Cell cell, const Visit& visit) const {
  const Neighbourhood& n = rules_->neighbours();
  if (wraps_near(cell)) {
    for (std::size_t i = 0; i < size_; ++i) {
      const Cell neighbour = wrap(cell + n.offsets[i]);
      if (placeable(neighbour) && at(neighbour) == kEmpty) visit(neighbour, view(neighbour));
    }
    return;
  }
  for (std::size_t i = 0; i < size_; ++i) {
    if (!rules_->sees(static_cast<std::size_t>(n.opposite(static_cast<int>(i))))) continue;
    const int site = static_cast<int>(kCentre) + step_[i];
    const Cell neighbour = cell + n.offsets[i];
    if (around_.at[static_cast<std::size_t>(site)] != kEmpty || !placeable(neighbour)) continue;
    visit(neighbour, view_within(around_, site));
  }
}

}  // namespace stig::lattice
