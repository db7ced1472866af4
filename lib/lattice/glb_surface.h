// SPDX-License-Identifier: MIT
// A mesh as the primitives of a glTF node.
#pragma once

#include <vector>

#include "base/glb.h"
#include "lattice/mesh.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// One for each colour, named as the brick is; one cell is `scale` units wide, y is up.
std::vector<GlbPrimitive> glb_surface(const Mesh& mesh, const std::vector<Brick>& bricks,
                                      double scale);

}  // namespace stig::lattice
