// SPDX-License-Identifier: MIT
// What a deposit costs here: of each neighbour a byte, one term of a hash and a look into the table
// of exact entries, which mostly misses, and the bit sets of those other entries alone that ask for
// the new brick. Whole views are matched only of sites that were open before.
#include "lattice/box_sites.h"

#include <algorithm>
#include <cassert>

namespace stig::lattice {
namespace {

std::optional<std::size_t> floor_code_of(const RuleTable& rules) {
  if (!rules.floor()) return std::nullopt;
  return rules.floor_code();
}

}  // namespace

BoxSites::BoxSites(LatticeWorld& world)
    : world_(&world),
      rules_(&world.rules()),
      filter_(rules_->opening_filter()),
      cells_(BoxCells::take(*world.box(), floor_code_of(*rules_))),
      open_(cells_->open()),
      staged_(rules_->stage_count() > 1),
      floor_code_(rules_->floor_code()) {
  if (staged_) cells_->with_stages();
  const Neighbourhood& n = rules_->neighbours();
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    const Offset o = n.offsets[i];
    const auto opposite = static_cast<std::uint32_t>(n.opposite(static_cast<int>(i)));
    step_[i] = cells_->step(o);
    if (rules_->sees(opposite)) looks_[look_count_++] = {step_[i], o.z, opposite};
    if (static_cast<int>(i) < n.first_below) continue;
    on_floor_.hash ^= kViewHash.word[i][kFloor];
    on_floor_.occupied |= 1U << i;
  }
  lay_start();
}

/// The bricks come one after another, as if deposited; sites are open in the order of cells then,
/// as LatticeWorld::candidates has them.
void BoxSites::lay_start() {
  const auto each = [&](const auto& visit) {
    world_->structure().for_each(
        [&](Cell at, Colour colour) { visit(cells_->number(at), at, colour); });
  };
  each([&](Site site, Cell, Colour colour) { close(site, colour); });
  each([&](Site site, Cell at, Colour colour) { look_around(site, at, colour); });
  sort_open();
}

/// The least that is true of a brick.
void BoxSites::close(Site site, Colour colour) {
  CodedCell& cell = (*cells_)[site];
  if ((cell.marks & kSeenCell) == 0) cells_->note(site);
  cell = {colour, kSeenCell | kClosedCell};
}

/// Begins the record of a cell.
void BoxSites::see(Site site) {
  (*cells_)[site].marks = kSeenCell;
  cells_->note(site);
  // The margin sees to it that there is a cell below.
  const bool on_floor = rules_->floor() && (*cells_)[site - 1].code == floor_code_;
  cells_->record(site) = on_floor ? on_floor_ : BoxCells::Record{};
  if (staged_) cells_->stages(site) = 0;
}

/// The list changes as CellMarks does: the last takes the place of one that goes.
void BoxSites::set_open(Site site, bool open) {
  std::uint32_t& place = cells_->record(site).place;
  if ((place != 0) == open) return;
  if (open) {
    open_.push_back(site);
    place = static_cast<std::uint32_t>(open_.size());
    return;
  }
  open_[place - 1] = open_.back();
  cells_->record(open_.back()).place = place;
  open_.pop_back();
  place = 0;
}

void BoxSites::sort_open() {
  std::sort(open_.begin(), open_.end());
  for (std::size_t i = 0; i < open_.size(); ++i) {
    cells_->record(open_[i]).place = static_cast<std::uint32_t>(i + 1);
  }
}

void BoxSites::mark(Site site, std::uint64_t stages) {
  if (staged_) cells_->stages(site) = stages;
  set_open(site, (stages & present()) != 0);
}

Match BoxSites::choose(Site site, Random& random) {
  rules_->matches(view(site), cell(site).z, world_->stage(), matches_);
  return chosen(*rules_, matches_, random);
}

void BoxSites::deposit(Site site, Cell cell, Colour colour) {
  mark(site, 0);
  world_->place(cell, colour);
  close(site, colour);
  look_around(site, cell, colour);
}

void BoxSites::look_around(Site site, Cell cell, Colour colour) {
  const int stage = world_->stage();
  for (std::size_t k = 0; k < look_count_; ++k) {
    const Look& look = looks_[k];
    const auto near = static_cast<Site>(static_cast<std::int32_t>(site) + look.step);
    const std::uint8_t marks = (*cells_)[near].marks;
    if ((marks & kClosedCell) != 0) continue;
    if ((marks & kSeenCell) == 0) see(near);
    BoxCells::Record& record = cells_->record(near);
    record.hash ^= kViewHash.word[look.opposite][colour];
    record.occupied |= 1U << look.opposite;
    // Where nothing was open, what opens now asks for the new brick; but rules that match without
    // any brick wait for the first.
    const bool was_open = staged_ ? cells_->stages(near) != 0 : record.place != 0;
    if (was_open || ((marks & kSeenCell) == 0 && rules_->asks_for_none())) {
      mark(near, rules_->open_stages(view(near), cell.z + look.dz, stage));
    } else if (filter_.may_open(record.hash, look.opposite, colour)) {
      const std::uint64_t stages =
          rules_->newly_open_stages(view(near), look.opposite, cell.z + look.dz, stage);
      if (stages != 0) mark(near, stages);
    }
  }
}

void BoxSites::begin_stage() {
  for (const Site site : open_) cells_->record(site).place = 0;
  open_.clear();
  for (const Site site : cells_->seen()) {
    const bool brick = ((*cells_)[site].marks & kClosedCell) != 0;
    if (!brick && (cells_->stages(site) & present()) != 0) open_.push_back(site);
  }
  sort_open();
}

}  // namespace stig::lattice
