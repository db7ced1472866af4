// SPDX-License-Identifier: MIT
// Views and stages for all engines. The hot path is a deposit: the 5 x 5 x 5 cells around
// it are gathered once, and all 26 neighbours' views are cut out of them. Near the sides of
// a periodic box and in narrow ones cells repeat, so views are read there cell by cell; the
// two paths give the same views.
#include "lattice/world.h"

#include <algorithm>
#include <cassert>

#include "lattice/cell_marks.h"

namespace stig::lattice {

LatticeWorld::LatticeWorld(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                           std::optional<Box> box)
    : rules_(&rules),
      size_(static_cast<std::size_t>(rules.neighbours().size)),
      box_(box),
      structure_(rules.lattice(), start) {
  const Neighbourhood& n = rules.neighbours();
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    const Offset o = n.offsets[i];
    step_[i] = Surroundings::index(o.x, o.y, o.z) - Surroundings::index(0, 0, 0);
  }
}

bool LatticeWorld::placeable(Cell site) const {
  if (rules_->floor() && site.z < 0) return false;
  return !box_ || box_->contains(site);
}

State LatticeWorld::at(Cell cell) const {
  if (rules_->floor() && cell.z < 0) return kFloor;
  return structure_.at(wrap(cell));
}

/// The gathered path covers all but the sides of a periodic box.
View LatticeWorld::view(Cell site) const {
  if (!wraps_near(site)) {
    Surroundings around;
    gather(site, around);
    return view_within(around, kCentre);
  }
  const Neighbourhood& n = rules_->neighbours();
  View view;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    view.at[i] = at(site + n.offsets[i]);
  }
  return view;
}

bool LatticeWorld::is_site(Cell site) const {
  if (!placeable(site) || at(site) != kEmpty) return false;
  const View seen = view(site);
  return std::any_of(seen.at.begin(), seen.at.begin() + static_cast<std::ptrdiff_t>(size_),
                     is_brick);
}

/// Two cells from a side, since a neighbour's neighbour is two away.
bool LatticeWorld::wraps_near(Cell cell) const {
  if (!box_ || !box_->periodic) return false;
  const Offset from_low = cell - box_->low;
  const auto near = [](std::int32_t at, std::int32_t size) { return at < 2 || at >= size - 2; };
  return near(from_low.x, box_->size.x) || near(from_low.y, box_->size.y) ||
         near(from_low.z, box_->size.z);
}

void LatticeWorld::gather(Cell cell, Surroundings& out) const {
  structure_.gather(cell, out);
  if (!rules_->floor() || cell.z >= 2) return;
  // Levels of the 5×5×5 below z = 0; they are the first in memory. Floor is no brick and is
  // stored nowhere; it is painted into what is read.
  const int below = std::min(5, 2 - cell.z);
  std::fill_n(out.at.begin(), below * Surroundings::kLevel, kFloor);
}

bool LatticeWorld::stage_spent() const {
  const std::int64_t limit = rules_->stage_limit(stage_);
  return limit > 0 && deposits_in_stage_ >= limit;
}

bool LatticeWorld::next_stage() {
  if (stage_ >= rules_->stage_count()) return false;
  ++stage_;
  deposits_in_stage_ = 0;
  return true;
}

/// Linear in the structure; engines call it at the beginning and keep the set up to date
/// themselves.
std::vector<Cell> LatticeWorld::candidates() const {
  const Neighbourhood& n = rules_->neighbours();
  CellMarks sites;
  structure_.for_each([&](Cell cell, Colour) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
      const Cell site = wrap(cell + n.offsets[i]);
      if (placeable(site) && at(site) == kEmpty) sites.set(site, 1);
    }
  });
  return sites.cells_with(1);
}

std::vector<Cell> LatticeWorld::enabled_sites() const {
  std::vector<Cell> sites = candidates();
  std::erase_if(sites, [&](Cell site) { return !rules_->enabled(view(site), site.z, stage_); });
  return sites;
}

void LatticeWorld::look_at(Cell cell) {
  if (around_cell_ == cell) return;
  gather(cell, around_);
  around_cell_ = cell;
}

Match LatticeWorld::choose(Cell site, Random& random) {
  look_at(site);
  const bool wraps = wraps_near(site);
  rules_->matches(wraps ? view(site) : view_within(around_, kCentre), site.z, stage_, matches_);
  return chosen(*rules_, matches_, random);
}

Match chosen(const RuleTable& rules, const std::vector<Match>& matches, Random& random) {
  assert(!matches.empty());
  if (rules.conflicts() != Conflicts::random || matches.size() == 1) return matches.front();
  // Weights choose among the matches of one site; rounding may leave a rest of zero, and
  // the last match then takes it.
  double total = 0;
  for (const Match& m : matches) total += rules.weight(m.rule);
  double rest = random.unit() * total;
  for (const Match& m : matches) {
    rest -= rules.weight(m.rule);
    if (rest < 0) return m;
  }
  return matches.back();
}

}  // namespace stig::lattice
