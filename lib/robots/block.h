// SPDX-License-Identifier: MIT
// The stigmergic block as its file says it: a cube of one mass with free magnets in its
// corners; on each face a tag, four LEDs about it and a radio behind it. Blocks are data files
// (blocks/*.yaml), not code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/vec.h"
#include "robots/uses.h"

namespace stig::robots {

/// Moment in A·m² of the paper's field 1: sqrt(7.0500949e-13 / 1e-7).
inline constexpr double kMomentPerField = 2.65520148011408e-3;

/// What the six faces bear. Lengths in m, angles in rad.
struct BlockTags {
  double side = 0;    ///< 0: there are none
  double proud = 0;   ///< of the face
  double widest = 0;  ///< between its normal and the line to a camera that reads it
};
struct BlockLights {
  double offset = 0;  ///< from the face's middle, four ways; 0: there are none
  double widest = 0;
};
struct BlockRadioModel {
  double depth = 0;  ///< below the face's middle
  double range = 0;  ///< 0: there are none
  /// The program sends back an 'a' and each message that came in.
  bool answers = false;
};

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

  BlockTags tags;
  BlockLights leds;
  BlockRadioModel radios;
  std::string program;  ///< path of its Lua program as the file says it, or empty

  bool has_magnets() const { return magnet_offset > 0; }
  double mass() const { return body_mass + (has_magnets() ? 8 * magnet_mass : 0); }
  /// Moment of inertia about any axis through the centre, kg·m²: a solid cube, and the
  /// magnets as points, since they turn freely in their places.
  double inertia() const;
  /// Dipole moment of a magnet, A·m².
  double magnet_moment() const;
  /// The moment of inertia of a solid sphere about its centre, kg m².
  double magnet_inertia() const { return 0.4 * magnet_mass * magnet_radius * magnet_radius; }
  /// The eight places, in binary order: x changes first.
  std::vector<Vec3> magnet_places() const;
};

/// The block, or nothing when an error was reported. Unknown keys are errors.
std::optional<BlockModel> read_block(SourceRef source, Diagnostics& diagnostics);
/// JSON Schema draft 7 of block files, with a newline at the end.
std::string block_schema();
/// Reads the file first; a file that cannot be read is a diagnostic too.
std::optional<BlockModel> read_block_file(const std::string& path, Diagnostics& diagnostics);

}  // namespace stig::robots
