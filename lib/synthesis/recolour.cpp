// SPDX-License-Identifier: MIT
// Finds few cells whose given colours stand in the way. First all cells are free; then as
// many as possible are bound to their given colours again, one after the other. The result
// is minimal in that no change can be taken back, for one order; finding the least number
// of changes would be a MaxSAT problem.
#include "synthesis/recolour.h"

#include <cassert>

namespace stig::synthesis {
namespace {

/// What one order may cost.
constexpr auto kStepsOfOrder = static_cast<std::uint64_t>(kStepsOfEffort / 20);

/// Asks for a colouring of a schedule in which some orbits must keep their colours.
bool can_keep(Schedule schedule, const std::vector<StateSet>& allowed, int named,
              const Allowance& allowance, Colouring& colours) {
  assert(allowed.size() == schedule.frame->orbits.size());
  Frame frame = *schedule.frame;
  for (std::size_t i = 0; i < allowed.size(); ++i) frame.orbits[i].colours = allowed[i];
  schedule.frame = &frame;
  ColouringSearch search(schedule, named);
  allowance.spend(search.cost());
  return search.colour(named, {allowance, {}}, colours) == Answered::yes;
}

/// The colours that make the fewest changes, as far as taking back one after the other
/// goes; nothing when no colours do.
std::optional<Colouring> least_changed(const Schedule& schedule, int named,
                                       const Allowance& allowance) {
  const std::vector<Orbit>& orbits = schedule.frame->orbits;
  std::vector<StateSet> allowed(orbits.size(), StateSet::bricks(named));
  Colouring given;
  for (const Orbit& orbit : orbits) {
    const bool single = orbit.colours.is_single();
    given.push_back(single ? orbit.colours.first() : Colour{1});
  }
  Colouring colours = given;
  if (!can_keep(schedule, allowed, named, allowance, colours)) return std::nullopt;
  // Cells that kept their colour without being asked are bound at once, which saves a
  // question each.
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    if (colours[i] == given[i]) allowed[i] = orbits[i].colours & StateSet::bricks(named);
  }
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    if (!orbits[i].colours.is_single() || colours[i] == given[i]) continue;
    std::vector<StateSet> tighter = allowed;
    tighter[i] = orbits[i].colours;
    Colouring again = colours;
    if (!can_keep(schedule, tighter, named, allowance, again)) continue;
    allowed = std::move(tighter);
    colours = std::move(again);
  }
  return colours;
}

std::vector<std::pair<Cell, Colour>> changes_of(const Frame& frame, const Target& target,
                                                const Colouring& colours) {
  std::vector<std::pair<Cell, Colour>> changes;
  for (std::size_t i = 0; i < frame.cells.size(); ++i) {
    const Colour colour = colours[static_cast<std::size_t>(frame.orbit_of[i])];
    if (!target.colours[i].contains(colour)) changes.emplace_back(frame.cells[i], colour);
  }
  return changes;
}

}  // namespace

std::optional<Recoloured> find_recolouring(const Target& target, const Placing& placing,
                                           const Allowance& allowance) {
  const int named = static_cast<int>(target.bricks.size());
  if (named == 0 || find_asymmetry(target, placing)) return std::nullopt;
  const Frame frame = make_frame(target, placing);
  std::vector<Order> orders = all_orders(frame, 1000);
  for (const OrderPlan& plan : order_plans()) {
    if (orders.size() >= 200) break;
    orders.push_back(plan.make(frame));
  }
  std::optional<Recoloured> best;
  for (const Order& order : orders) {
    if (allowance.passed()) break;
    BadOrder bad;
    const auto schedule = make_schedule(frame, order, bad, {256, std::size_t{1} << 22});
    if (!schedule) continue;
    allowance.spend(cost_of(*schedule));
    const auto colours = least_changed(*schedule, named, allowance.within(kStepsOfOrder));
    if (!colours) continue;
    auto changes = changes_of(frame, target, *colours);
    if (changes.empty() || (best && changes.size() >= best->changes.size())) continue;
    best = Recoloured{target, std::move(changes)};
    for (const auto& [cell, colour] : best->changes) {
      best->target.colours[static_cast<std::size_t>(index_in(target.cells, cell))] =
          StateSet::of(colour);
    }
  }
  return best;
}

}  // namespace stig::synthesis
