// SPDX-License-Identifier: MIT
// The stigmergic block as physics sees it: a cube of one mass with free magnets in its
// corners. Blocks are data files (blocks/*.yaml), not code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/vec.h"

namespace stig {

/// As the file says it. Lengths in m, masses in kg.
struct BlockModel {
  std::string name, title, source;
  double side = 0;           ///< of the cube
  double body_mass = 0;      ///< without magnets
  double friction = 0;       ///< Coulomb's coefficient against its own kind
  double magnet_offset = 0;  ///< magnets at (±offset, ±offset, ±offset); 0: no magnets
  double magnet_radius = 0;
  double magnet_mass = 0;    ///< of one of the eight
  double magnet_field = 0;   ///< in the paper's unit, see kMomentPerField
  double magnet_cutoff = 0;  ///< distance beyond which magnets ignore each other

  bool has_magnets() const { return magnet_offset > 0; }
  double mass() const { return body_mass + (has_magnets() ? 8 * magnet_mass : 0); }
  /// Moment of inertia about any axis through the centre, kg·m²: a solid cube, and the
  /// magnets as points, since they turn freely in their places.
  double inertia() const;
  /// Dipole moment of a magnet, A·m².
  double magnet_moment() const;
  /// Of a solid sphere about its centre, kg m².
  double magnet_inertia() const { return 0.4 * magnet_mass * magnet_radius * magnet_radius; }
  /// The eight places, in binary order: x changes first.
  std::vector<Vec3> magnet_places() const;
};

/// The block, or nothing when an error was reported. Unknown keys are errors.
std::optional<BlockModel> read_block(SourceRef source, Diagnostics& diagnostics);
/// Reads the file first; a file that cannot be read is a diagnostic too.
std::optional<BlockModel> read_block_file(const std::string& path, Diagnostics& diagnostics);

}  // namespace stig
