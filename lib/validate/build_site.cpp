// SPDX-License-Identifier: MIT
#include "validate/build_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

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

/// Is every start brick there?
bool holds_start(const RuleSet& rules, const BuildSite& site,
                 const std::vector<FixedBlock>& blocks) {
  return std::all_of(rules.start.begin(), rules.start.end(), [&](const PlacedBrick& brick) {
    return std::any_of(blocks.begin(), blocks.end(), [&](const FixedBlock& block) {
      return block.led == led_of(rules, brick.brick) &&
             length(block.X_WB.p - centre_of(site, brick.at)) < kStartTolerance;
    });
  });
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

}  // namespace

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

std::optional<BuildSite> find_site(const RuleSet& rules, std::int32_t floor_level,
                                   const Scene& scene, const PlacedScene& placed,
                                   Diagnostics& diagnostics) {
  assert(!rules.start.empty());
  std::optional<double> floats;
  const std::vector<FixedBlock> blocks = fixed_blocks(placed);
  const PlacedBrick& first = rules.start.front();
  // Quarters outside, so that the lattice nearest to the world's axes wins where several fit.
  for (int quarters = 0; quarters < 4 && !scene.models.empty(); ++quarters) {
    for (const FixedBlock& block : blocks) {
      if (block.led != led_of(rules, first.brick)) continue;
      const BuildSite site = site_of(first, block.X_WB, scene.models.front().side, quarters);
      if (!holds_start(rules, site, blocks)) continue;
      // The floor is a rule's business: what the proof takes for the floor must be the floor.
      const double over = centre_of(site, {0, 0, floor_level}).z - site.pitch / 2;
      if (std::abs(over) < kStartTolerance) return site;
      floats = over;
    }
  }
  if (floats) {
    diagnostics.add(Code::V801, {scene.source, 0, 0},
                    fmt::format("the start of '{}' is there, but its structure would stand {:.1f} "
                                "mm {} the floor",
                                rules.name, std::abs(*floats) * 1e3, *floats > 0 ? "over" : "in"));
    return std::nullopt;
  }
  diagnostics.add(
      Code::V801, {scene.source, 0, 0},
      fmt::format("the start of '{}' is not there: {} fixed {} wanted, which {} {}", rules.name,
                  rules.start.size(), rules.start.size() == 1 ? "block is" : "blocks are",
                  rules.start.size() == 1 ? "shows" : "show, the first,",
                  to_string(led_of(rules, first.brick))));
  return std::nullopt;
}

}  // namespace stig::validate
