// SPDX-License-Identifier: MIT
// A face between two bricks is seen until the second of them is there, and so belongs to the first
// one alone: the file has each face once.
#include "lattice/growth_glb.h"

#include <fmt/format.h>

#include <cassert>

#include "lattice/glb_surface.h"

namespace stig::lattice {

namespace {

/// The faces that the bricks of a step show when they and all that came before are there.
Mesh new_faces(const Structure& after, const std::vector<PlacedBrick>& bricks) {
  Mesh mesh{after.lattice(), {}};
  const auto& faces = cell_faces(after.lattice());
  for (const PlacedBrick& brick : bricks) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (after.at(brick.at + faces[i].towards) != kEmpty) continue;
      mesh.polygons.push_back(face_polygon(after.lattice(), i, brick));
    }
  }
  return mesh;
}

GlbMotion appearance(std::size_t node, double seconds) {
  GlbMotion motion;
  motion.node = node;
  motion.stepped = true;
  motion.times = {0, static_cast<float>(seconds)};
  motion.scales = {{0, 0, 0}, {1, 1, 1}};
  return motion;
}

}  // namespace

std::string print_growth_glb(Lattice lattice, const std::vector<GrowthStep>& steps,
                             const std::vector<Brick>& bricks, double scale) {
  assert(scale > 0);
  Structure structure(lattice);
  std::vector<GlbNode> nodes;
  std::vector<GlbMotion> motions;
  std::size_t number = 0;
  for (const GrowthStep& step : steps) {
    if (step.bricks.empty()) continue;
    for (const PlacedBrick& brick : step.bricks) structure.place(brick.at, brick.brick);
    GlbNode node;
    node.name = step.bricks.size() == 1
                    ? fmt::format("brick {}", number + 1)
                    : fmt::format("bricks {}-{}", number + 1, number + step.bricks.size());
    number += step.bricks.size();
    node.primitives = glb_surface(new_faces(structure, step.bricks), bricks, scale);
    // Bricks that are walled in when they come show nothing.
    if (node.primitives.empty()) continue;
    if (step.seconds > 0) motions.push_back(appearance(nodes.size(), step.seconds));
    nodes.push_back(std::move(node));
  }
  return glb_file(nodes, motions, "growth");
}

}  // namespace stig::lattice
