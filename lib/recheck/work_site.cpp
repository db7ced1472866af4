// SPDX-License-Identifier: MIT
// A brick is due in all structures of a range when the rules act there whatever its neighbours
// are that may or may not stand, and with its colour alone.
#include "recheck/work_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <set>

#include "base/text.h"
#include "rules/cell_text.h"
#include "sensing/led_code.h"

namespace stig::recheck {

namespace {

constexpr int kMostOpen = 12;  ///< neighbours that the rules ask for and that may stand or not

}  // namespace

WorkSite::WorkSite(const RuleSet& rules, const Figures& robot,
                   const WorkCertificate& the_certificate)
    : certificate(the_certificate),
      whole(the_certificate),
      view(robot, the_certificate.looks, std::min(robot.levels(), whole.levels()) + 1),
      room(whole, robot),
      rules_(rules),
      acting_(rules) {}

std::string WorkSite::name(std::uint32_t brick) const {
  return "the brick at " + cell_text(whole.cell(brick));
}

const std::vector<std::uint32_t>& WorkSite::about(const Before& at) {
  const auto [known, added] = about_.try_emplace({at.side, at.u, at.v});
  if (added) {
    for (const NearCell& c : view.cells()) {
      known->second.push_back(whole.at(at.side, {at.u + c.du, at.v + c.dv, c.z}));
    }
  }
  return known->second;
}

std::optional<Put> WorkSite::wish(const Before& at, const Bricks& sure) {
  const std::vector<std::uint32_t>& bricks = about(at);
  std::string shown(bricks.size(), '\0');
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    if (bricks[i] != kNoBrick && sure.has(bricks[i])) {
      shown[i] = static_cast<char>(whole.colour(bricks[i]));
    }
  }
  return decide(certificate, view, view.known(shown), at.side);
}

/// A block is put in front of a brick, beside one, or on one.
std::uint32_t WorkSite::meant(const Before& at, const Put& put, const Range& there,
                              std::string& why) {
  const auto& [du, dv, z] = put.cell;
  const auto stands = [&](const Seen& place) {
    const std::uint32_t one = whole.at(at.side, place);
    return one != kNoBrick && there.sure.has(one);
  };
  const std::uint32_t brick = whole.at(at.side, {at.u + du, at.v + dv, z});
  const bool on_top = du == 0 && dv == 0;
  if (brick == kNoBrick || whole.colour(brick) != put.colour) {
    why = fmt::format("from {} robots put a brick where the structure has none of that colour",
                      kSideNames[static_cast<std::size_t>(at.side)]);
    return kNoBrick;
  }
  if (there.maybe.has(brick)) why = name(brick) + " is put where one may stand";
  const bool near = on_top || (du >= 0 && std::abs(du) + std::abs(dv) == 1);
  if (!near || !stands({at.u, at.v, on_top ? z - 1 : z})) {
    why = name(brick) + " is put where no brick of the column is certain to be next to it";
  }
  if (why.empty()) why = fault({brick, at.side}, there);
  return why.empty() ? brick : kNoBrick;
}

std::string WorkSite::fault(const Deed& deed, const Range& there) {
  if (!always_due(deed.brick, there)) return "the rules may not want " + name(deed.brick);
  const std::string obstacle = room.obstacle(deed.brick, deed.side, there);
  if (obstacle.empty()) return {};
  return fmt::format("{} may be out of reach from {}: {}", name(deed.brick),
                     kSideNames[static_cast<std::size_t>(deed.side)], obstacle);
}

bool WorkSite::always_due(std::uint32_t brick, const Range& there) const {
  const Neighbourhood& near = neighbourhood(rules_.lattice);
  const Cell at = whole.cell(brick);
  Outlook outlook;
  outlook.z = at.z;
  for (std::size_t i = 0; i < static_cast<std::size_t>(near.size); ++i) {
    const Cell cell = at + near.offsets[i];
    const std::uint32_t one = whole.at(cell);
    outlook.shows[i] = rules_.floor && cell.z < 0 ? kFloor : kEmpty;
    if (one == kNoBrick || !there.maybe.has(one)) continue;
    outlook.shows[i] = whole.colour(one);
    if (there.sure.has(one)) {
      outlook.beside_brick = true;
    } else {
      outlook.open |= NeighbourSet{1} << i;
    }
  }
  std::vector<RuleCandidate> candidates;
  acting_.candidates(outlook, 1, candidates);
  const NeighbourSet asked = acting_.asked_about(outlook, candidates);
  if (std::popcount(asked) > kMostOpen) return false;
  // All subsets of what is asked about, the whole of it first and the empty set last.
  for (NeighbourSet some = asked;; some = (some - 1) & asked) {
    const Action action = acting_.act(outlook, candidates, some, whole.colour(brick));
    if (!action.acts || action.other) return false;
    if (some == 0) return true;
  }
}

std::string form_fault(const RuleSet& rules, const Figures& robot,
                       const WorkCertificate& certificate) {
  if (rules.lattice != Lattice::cubic) return "robots build on the cubic lattice alone";
  if (rules.stage_count() > 1) return "no robot knows stages";
  if (certificate.sides.empty() || certificate.looks.empty()) return "it has no side, or no look";
  if (certificate.ordered && certificate.bricks.size() > kMostOrderedWork) {
    return fmt::format("more than {} bricks in order are not checked", kMostOrderedWork);
  }
  std::set<Cell> cells;
  for (const WorkBrick& one : certificate.bricks) {
    if (!cells.insert(one.brick.at).second) {
      return fmt::format("two bricks are at {}", cell_text(one.brick.at));
    }
    if (one.brick.brick > rules.colours()) return "the rules have no such colour";
  }
  std::set<PlacedBrick> start(rules.start.begin(), rules.start.end());
  for (std::size_t i = 0; i < certificate.start; ++i) start.erase(certificate.bricks[i].brick);
  if (!start.empty() || certificate.start != rules.start.size()) return "the start is another";
  if (cells.begin()->z != 0 && rules.floor) {
    const bool on_floor =
        std::any_of(cells.begin(), cells.end(), [](const Cell& c) { return c.z == 0; });
    if (!on_floor) return "nothing stands on the floor";
  }
  for (const WorkLook& look : certificate.looks) {
    if (look.lift > robot.lift_travel) return "the lift does not go so high for a look";
  }
  return {};
}

WorkReport check_work(const RuleSet& rules, const Figures& robot,
                      const WorkCertificate& certificate) {
  WorkReport out;
  out.refusal = form_fault(rules, robot, certificate);
  if (!out.refusal.empty()) return out;
  Figures seeing = robot;
  seeing.leds_needed = sensing::leds_needed(std::max(1, rules.highest_kind()));
  WorkSite site(rules, seeing, certificate);
  out.refusal = certificate.ordered ? check_ordered(site, out) : check_walked(site, out);
  out.accepted = out.refusal.empty();
  return out;
}

}  // namespace stig::recheck
