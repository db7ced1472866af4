// SPDX-License-Identifier: MIT
// Surfaces in the forms that other programs read, as the bytes of whole files. One
// cell is `scale` units wide; 1 by default, 0.055 for a block of 55 mm in metres.
#pragma once

#include <string>
#include <vector>

#include "lattice/mesh.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// Binary STL: triangles and normals, without colour. For slicers the mesh must be
/// unmerged.
std::string print_stl(const Mesh& mesh, double scale = 1);

/// Binary little-endian PLY: quadrilaterals, into which hexagons are cut since not all
/// readers take them; every vertex has the normal and the colour of its face.
std::string print_ply(const Mesh& mesh, const std::vector<Brick>& bricks, double scale = 1);

/// Binary glTF 2.0 (Khronos Group, 2017): one mesh with a primitive and a material,
/// named like the brick, for each colour. glTF has y up, so (x, y, z) is written as
/// (x, z, -y).
std::string print_glb(const Mesh& mesh, const std::vector<Brick>& bricks, double scale = 1);

}  // namespace stig::lattice
