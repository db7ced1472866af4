// SPDX-License-Identifier: MIT
// The sites of a world in a solid box that are open, for the event engine: views are asked about
// where they stand, in BoxCells, and of most neighbours of a new brick a glance tells that they
// stay closed. CellSites (event_engine.cpp) is the same for all worlds, and a law in the tests
// holds one to the other.
#pragma once

#include "lattice/box_cells.h"
#include "lattice/uses.h"
#include "lattice/world.h"

namespace stig::lattice {

class BoxSites {
 public:
  using Site = CellNumber;

  static bool fit(const std::optional<Box>& box) { return BoxCells::fit(box); }
  /// Opens the sites around the bricks that stand. The world has a box that fits.
  explicit BoxSites(LatticeWorld& world);
  ~BoxSites() { BoxCells::give_back(std::move(cells_)); }
  BoxSites(const BoxSites&) = delete;
  BoxSites& operator=(const BoxSites&) = delete;

  std::size_t size() const { return open_.size(); }
  Site operator[](std::size_t i) const { return open_[i]; }
  Cell cell(Site site) const { return cells_->cell(site); }
  /// The rule that acts at an open site.
  Match choose(Site site, Random& random);
  void deposit(Site site, Cell cell, Colour colour);
  /// Opens what the world's stage, which has just begun, opens.
  void begin_stage();

 private:
  /// From a cell to a neighbour whose view it is in.
  struct Look {
    std::int32_t step;
    std::int32_t dz;
    std::uint32_t opposite;  ///< what the cell is to that neighbour
  };

  void lay_start();
  void close(Site site, Colour colour);
  void look_around(Site site, Cell cell, Colour colour);
  void see(Site site);
  void mark(Site site, std::uint64_t stages);
  void set_open(Site site, bool open);
  void sort_open();
  std::uint64_t present() const { return 1 | std::uint64_t{1} << world_->stage(); }
  StandingView view(Site site) const {
    const BoxCells::Record& record = cells_->record(site);
    return {cells_->at(site), step_.data(), record.occupied, record.hash};
  }

  LatticeWorld* world_;
  const RuleTable* rules_;
  OpeningFilter filter_;
  std::unique_ptr<BoxCells> cells_;
  std::vector<Site>& open_;
  bool staged_;
  std::size_t floor_code_;
  std::array<std::int32_t, kMaxNeighbours> step_{};
  std::array<Look, kMaxNeighbours> looks_{};  ///< those that can decide whether a rule matches
  std::size_t look_count_ = 0;
  BoxCells::Record on_floor_{};  ///< of a cell with nothing around but the floor below
  std::vector<Match> matches_;   ///< saves allocations
};

}  // namespace stig::lattice
