// SPDX-License-Identifier: MIT
// A solid of any form as physics takes it: convex pieces to touch with, the mass properties of the
// true solid, and a surface to look at. Files of solids (stigc_solid: 1) are written by `stigc
// convex` from a mesh.
//
// Meshes themselves are not read here. What they are turned into depends on a library under another
// licence and on its version; a file of numbers gives the same run everywhere, and is small.
//
// Lengths in m, in the frame of the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/file_io.h"
#include "base/vec.h"
#include "robots/uses.h"

namespace stig::robots {

/// Triangles that are looked at and touch nothing; without any, nothing is drawn.
struct VisualMesh {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct SolidModel {
  std::string name, source;
  double volume = 0;       ///< m³
  Vec3 centre;             ///< of mass
  Vec3 squares, products;  ///< about it, of 1 kg: means of x², y², z²; of yz, zx, xy
  std::vector<std::vector<Vec3>> pieces;  ///< corners of each; their hulls touch
  VisualMesh surface;
};

inline constexpr std::size_t kMaxSolidFileBytes = std::size_t{1} << 21;

/// Finds the text of a file that another one names.
using FileLoader = std::function<std::optional<std::string>(const std::string& name,
                                                            std::size_t most, FileError& error)>;
/// Looks beside a file.
FileLoader loader_beside(const std::string& path);

/// The solid, or nothing when an error was reported.
std::optional<SolidModel> read_solid(SourceRef source, Diagnostics& diagnostics);

/// As a file, with what made it in a comment of one line; reading gives the same numbers.
std::string print_solid(const SolidModel& solid, const std::string& comment);

/// JSON Schema of files of solids.
std::string solid_schema();

/// The endings of files that are meshes and no solids yet: .stl, .obj, .off, .ply.
bool is_mesh_name(const std::string& name);

}  // namespace stig::robots
