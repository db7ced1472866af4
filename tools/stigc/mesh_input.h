// SPDX-License-Identifier: MIT
// Meshes (.stl .obj .off .ply) as structures and as solids. A program of its own turns them into
// cells and convex pieces, stigc-mesh, which stands beside stigc where it was built: what reads
// other people's meshes is under another licence, and must not be able to take this process along.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app.h"
#include "lattice/loaded_structure.h"
#include "options.h"
#include "robots/solid.h"
#include "uses.h"

namespace stig::cli {

/// By the ending of its name.
bool is_mesh(const std::string& path);

/// What is wrong with --bricks, in words: it was given, and no file is a mesh. Empty: nothing.
std::string bricks_problem(const MeshOptions& options, const std::vector<std::string>& files);

/// Where stigc-mesh is; nothing when it was not built.
std::optional<std::string> find_mesh_program();

/// What was made of a mesh.
struct Voxels {
  LoadedStructure loaded;         ///< of one kind of brick; its lowest corner is (0, 0, 0)
  nlohmann::ordered_json report;  ///< the other keys of what stigc-mesh prints, lengths in mm
};

/// Problems are complained of.
std::optional<Voxels> voxelise(const std::string& path, const MeshOptions& options, const App& app);

/// A mesh as a solid in metres.
struct Solid {
  SolidModel model;
  nlohmann::ordered_json report;  ///< the other keys of what stigc-mesh prints, lengths in mm
};

/// Problems are complained of.
std::optional<Solid> read_mesh_solid(const ConvexOptions& options, const App& app);

/// What was found in the mesh and what of it was mended, a line each.
std::string repair_lines(const nlohmann::ordered_json& report);
/// What had to be done to the mesh, and what became of it, a line each.
std::string mesh_lines(const Voxels& voxels);

}  // namespace stig::cli
