// SPDX-License-Identifier: MIT
// Where the lattice of the rules lies in the physical world: once for each structure.
//
// The start bricks are fixed blocks that show their colours. They say where cell (0, 0, 0) is and
// how the lattice is turned; whatever is built is measured against them. A single start brick
// leaves four turns open: then the lattice's axes are the ones nearest to the world's. A scene may
// have several starts, each with a lattice of its own.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"
#include "lattice/structure.h"
#include "physical/robots/led.h"
#include "physical/scene/scene.h"
#include "rules/rule_set.h"
#include "validate/uses.h"

namespace stig::validate {

struct BuildSite {
  Pose X_WL;             ///< centre of cell (0, 0, 0), and the axes of the rules
  double pitch = 0.055;  ///< m, a block's side
};

/// What is to be built at each of the sites. The rules must outlive it.
struct BuildTarget {
  const RuleSet* rules = nullptr;
  Structure whole;               ///< proved, the start included
  std::vector<BuildSite> sites;  ///< of the structures, at least one
};

/// " of structure 2" in reports of several; of one alone nothing.
std::string of_structure(const BuildTarget& target, std::size_t structure);

/// Sides of a block from a brick: what lies so near counts as against the brick's structure.
inline constexpr double kInTheWay = 1.3;

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

/// Finds the starts among the scene's fixed blocks, cells of `floor_level` on the floor, in the
/// order in which the scene has their first bricks. None, and an error, where there is no start
/// (V801) or structures would come too near each other (V803). Fixed blocks that look like a start
/// brick and belong to no structure are warned of (V804).
std::vector<BuildSite> find_sites(const RuleSet& rules, const Structure& whole,
                                  std::int32_t floor_level, const Scene& scene,
                                  const PlacedScene& placed, Diagnostics& diagnostics);

}  // namespace stig::validate
