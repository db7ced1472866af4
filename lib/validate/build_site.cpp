// SPDX-License-Identifier: MIT
#include "validate/build_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "base/text.h"
#include "physical/readout/lattice_reading.h"

namespace stig::validate {
namespace {

// Scenes say places to the hundredth of a millimetre, so this is for scenes written by hand.
constexpr double kStartTolerance = 0.002;  ///< m, of a start brick from its cell

// The offset in cells, as numbers that can be scaled and turned.
Vec3 vector_of(Offset o) {
  return {static_cast<double>(o.x), static_cast<double>(o.y), static_cast<double>(o.z)};
}

struct FixedBlock {
  Pose X_WB;
  Led led = Led::off;
  bool taken = false;  ///< by a structure that was found
};

std::vector<FixedBlock> fixed_blocks(const PlacedScene& placed) {
  std::vector<FixedBlock> out;
  for (std::size_t i = 0; i < placed.config.bodies.size(); ++i) {
    const BodyDef& body = placed.config.bodies[i];
    // A fixed block that shows nothing is part of the scene's furniture, a wall for example.
    if (!placed.bodies[i].block || !body.fixed || placed.bodies[i].colour == Led::off) continue;
    out.push_back({body.X_WB, placed.bodies[i].colour});
  }
  return out;
}

/// Which blocks are the start bricks, of those that are free; none where one is missing.
std::vector<std::size_t> start_blocks(const RuleSet& rules, const BuildSite& site,
                                      const std::vector<FixedBlock>& blocks) {
  std::vector<std::size_t> out;
  for (const PlacedBrick& brick : rules.start) {
    const auto found = std::find_if(blocks.begin(), blocks.end(), [&](const FixedBlock& block) {
      return !block.taken && block.led == led_of(rules, brick.brick) &&
             length(block.X_WB.p - centre_of(site, brick.at)) < kStartTolerance;
    });
    if (found == blocks.end()) return {};
    out.push_back(static_cast<std::size_t>(found - blocks.begin()));
  }
  return out;
}

/// The site in which this block is the first start brick, the lattice turned by quarters from
/// the block's own axes.
BuildSite site_of(const PlacedBrick& first, const Pose& X_WB, double side, int quarters) {
  // A cube looks the same in 24 positions, so its axes are known up to those alone: yaw from what
  // is left, then the four quarters are tried.
  const Mat3 own = beyond_cube_turn(matrix(X_WB.q));
  const double yaw = std::atan2(own.x.y, own.x.x) + quarters * std::numbers::pi / 2;
  BuildSite site{{{}, rotation({0, 0, yaw})}, side};
  // The site's frame is that of cell (0, 0, 0), which need not be a cell of the start.
  site.X_WL.p = X_WB.p - rotate(site.X_WL.q, vector_of(first.at - Cell{}) * side);
  return site;
}

/// From a brick of one structure to the nearest of another, centre to centre, m; of structures
/// that are far apart at least so much.
double least_way(const Structure& whole, const BuildSite& a, const BuildSite& b) {
  // From the frames' origins no brick is farther off than this.
  double radius = 0;
  for (const PlacedBrick& brick : whole.bricks()) {
    radius = std::max(radius, length(centre_of(a, brick.at) - a.X_WL.p));
  }
  double least = length(a.X_WL.p - b.X_WL.p) - 2 * radius;
  if (least >= kInTheWay * a.pitch) return least;
  least = std::numeric_limits<double>::infinity();
  for (const PlacedBrick& one : whole.bricks()) {
    for (const PlacedBrick& other : whole.bricks()) {
      least = std::min(least, length(centre_of(a, one.at) - centre_of(b, other.at)));
    }
  }
  return least;
}

void report_no_start(const RuleSet& rules, const Scene& scene, std::optional<double> floats,
                     Diagnostics& diagnostics) {
  const SourceRange where{scene.source, 0, 0};
  if (floats) {
    diagnostics.add(Code::V801, where,
                    fmt::format("the start of '{}' is there, but its structure would stand {:.1f} "
                                "mm {} the floor",
                                rules.name, std::abs(*floats) * 1e3, *floats > 0 ? "over" : "in"));
    return;
  }
  diagnostics.add(
      Code::V801, where,
      fmt::format("the start of '{}' is not there: {} fixed {} wanted, which {} {}", rules.name,
                  rules.start.size(), rules.start.size() == 1 ? "block is" : "blocks are",
                  rules.start.size() == 1 ? "shows" : "show, the first,",
                  to_string(led_of(rules, rules.start.front().brick))));
}

/// Whole structures must not come so near each other that bricks of one are in the way of another.
bool report_too_near(const Structure& whole, const std::vector<BuildSite>& sites,
                     const Scene& scene, Diagnostics& diagnostics) {
  for (std::size_t b = 1; b < sites.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const double least = least_way(whole, sites[a], sites[b]);
      if (least >= kInTheWay * sites[a].pitch) continue;
      const Vec3 &at = sites[a].X_WL.p, &other = sites[b].X_WL.p;
      diagnostics
          .add(Code::V803, {scene.source, 0, 0},
               fmt::format("the structures at ({:.2f}, {:.2f}) and ({:.2f}, {:.2f}) m come too "
                           "near each other: {:.0f} mm from brick to brick",
                           at.x, at.y, other.x, other.y, least * 1e3))
          .note(fmt::format("{:.0f} mm from centre to centre are the least; robots need room "
                            "besides",
                            kInTheWay * sites[a].pitch * 1e3));
      return true;
    }
  }
  return false;
}

/// Of starts that were meant and are not there.
void report_left_over(const RuleSet& rules, const std::vector<FixedBlock>& blocks,
                      const Scene& scene, Diagnostics& diagnostics) {
  const FixedBlock* first = nullptr;
  std::size_t count = 0;
  for (const FixedBlock& block : blocks) {
    const bool looks = std::any_of(
        rules.start.begin(), rules.start.end(),
        [&](const PlacedBrick& brick) { return led_of(rules, brick.brick) == block.led; });
    if (block.taken || !looks) continue;
    if (first == nullptr) first = &block;
    ++count;
  }
  if (first == nullptr) return;
  diagnostics.add(
      Code::V804, {scene.source, 0, 0},
      fmt::format("{} in a start brick's colour, the first at ({:.2f}, {:.2f}) m: no whole start "
                  "of '{}' is there, and what is built there is not judged",
                  counted(count, "fixed block"), first->X_WB.p.x, first->X_WB.p.y, rules.name));
}

}  // namespace

std::string of_structure(const BuildTarget& target, std::size_t structure) {
  return target.sites.size() > 1 ? fmt::format(" of structure {}", structure + 1) : "";
}

Vec3 centre_of(const BuildSite& site, Cell cell) {
  assert(site.pitch > 0);
  return site.X_WL * (vector_of(cell - Cell{}) * site.pitch);
}

CellFit fit_of(const BuildSite& site, const Pose& X_WB) {
  assert(site.pitch > 0);
  const Pose X_LB = inverse(site.X_WL) * X_WB;
  // To the nearest cell centre, along each axis of the lattice.
  const auto number = [&](double v) {
    return static_cast<std::int32_t>(std::lround(v / site.pitch));
  };
  CellFit fit;
  fit.cell = {number(X_LB.p.x), number(X_LB.p.y), number(X_LB.p.z)};
  fit.off = X_LB.p - vector_of(fit.cell - Cell{}) * site.pitch;
  // The block's own marks do not matter: turned by quarters it is the same brick.
  const Mat3 left = beyond_cube_turn(matrix(X_LB.q));
  fit.yaw = std::atan2(left.x.y, left.x.x);
  fit.turn = angle_of(quaternion_of(left));
  return fit;
}

Led led_of(const RuleSet& rules, Colour colour) {
  return physics::led_of(rules.brick(colour).led).value_or(Led::off);
}

Colour colour_of(const RuleSet& rules, Led led) {
  // Two colours never share an LED (a check of rules sees to it), so the first is the only one.
  for (int colour = 1; colour <= rules.colours(); ++colour) {
    if (led != Led::off && led_of(rules, static_cast<Colour>(colour)) == led) {
      return static_cast<Colour>(colour);
    }
  }
  return 0;
}

std::vector<BuildSite> find_sites(const RuleSet& rules, const Structure& whole,
                                  std::int32_t floor_level, const Scene& scene,
                                  const PlacedScene& placed, Diagnostics& diagnostics) {
  assert(!rules.start.empty());
  std::optional<double> floats;
  std::vector<FixedBlock> blocks = fixed_blocks(placed);
  const PlacedBrick& first = rules.start.front();
  std::map<std::size_t, BuildSite> found;  // by the start's first block
  // Quarters outside, so that the lattice nearest to the world's axes wins where several fit.
  for (int quarters = 0; quarters < 4 && !scene.models.empty(); ++quarters) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (blocks[i].taken || blocks[i].led != led_of(rules, first.brick)) continue;
      const BuildSite site = site_of(first, blocks[i].X_WB, scene.models.front().side, quarters);
      const std::vector<std::size_t> start = start_blocks(rules, site, blocks);
      if (start.empty()) continue;
      // The floor is a rule's business: what the proof takes for the floor must be the floor.
      const double over = centre_of(site, {0, 0, floor_level}).z - site.pitch / 2;
      if (std::abs(over) >= kStartTolerance) {
        floats = over;
        continue;
      }
      found.emplace(i, site);
      // A fixed block in a cell of this structure is a brick of it, and begins no other.
      for (FixedBlock& block : blocks) {
        const CellFit fit = fit_of(site, block.X_WB);
        if (length(fit.off) < kStartTolerance && is_brick(whole.at(fit.cell))) block.taken = true;
      }
    }
  }
  if (found.empty()) {
    report_no_start(rules, scene, floats, diagnostics);
    return {};
  }
  std::vector<BuildSite> sites;
  for (const auto& [block, site] : found) sites.push_back(site);
  if (report_too_near(whole, sites, scene, diagnostics)) return {};
  report_left_over(rules, blocks, scene, diagnostics);
  return sites;
}

}  // namespace stig::validate
