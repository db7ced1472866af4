// SPDX-License-Identifier: MIT
// Where the lattice of the rules lies in the physical world.
//
// The start bricks are fixed blocks that show their colours. They say where cell (0, 0, 0) is and
// how the lattice is turned; whatever is built is measured against them. A single start brick
// leaves four turns open: then the lattice's axes are the ones nearest to the world's.
#pragma once

#include <cstdint>
#include <optional>

#include "base/vec.h"
#include "physical/robots/led.h"
#include "physical/scene/scene.h"
#include "rules/rule_set.h"
#include "validate/uses.h"

namespace stig::validate {

struct BuildSite {
  Pose X_WL;             ///< centre of cell (0, 0, 0), and the axes of the rules
  double pitch = 0.055;  ///< m, a block's side
};

/// Centre of a cell, world frame.
Vec3 centre_of(const BuildSite& site, Cell cell);

/// A block against the lattice.
struct CellFit {
  Cell cell;        ///< the nearest
  Vec3 off;         ///< m, of its centre from the cell's, along the lattice's axes
  double yaw = 0;   ///< rad, of its axes from the lattice's, within ±π/4
  double turn = 0;  ///< rad, the whole angle, tilt and all
};
CellFit fit_of(const BuildSite& site, const Pose& X_WB);

/// What a brick's block shows, as its entry says.
Led led_of(const RuleSet& rules, Colour colour);
/// The brick that a block of this colour is; 0: none.
Colour colour_of(const RuleSet& rules, Led led);

/// Finds the start among the scene's fixed blocks, cells of `floor_level` on the floor; otherwise a
/// diagnostic, code V801.
std::optional<BuildSite> find_site(const RuleSet& rules, std::int32_t floor_level,
                                   const Scene& scene, const PlacedScene& placed,
                                   Diagnostics& diagnostics);

}  // namespace stig::validate
