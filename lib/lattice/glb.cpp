// SPDX-License-Identifier: MIT
// Groups the polygons of a mesh by colour into the primitives of one glTF node. Polygons
// are convex, so a fan from the first corner triangulates them. glTF wants y up and
// right-handed axes: (x, y, z) becomes (x, z, -y), a rotation and no mirror.
#include <cassert>
#include <map>

#include "lattice/glb_surface.h"
#include "lattice/mesh_files.h"
#include "lattice/rgb.h"

namespace stig::lattice {

namespace {

std::array<float, 3> y_up(Point p, double scale) {
  return {static_cast<float>(p.x * scale), static_cast<float>(p.z * scale),
          static_cast<float>(-p.y * scale)};
}

std::map<Colour, GlbPrimitive> primitives_of(const Mesh& mesh, double scale) {
  std::map<Colour, GlbPrimitive> primitives;
  for (const Polygon& polygon : mesh.polygons) {
    GlbPrimitive& to = primitives[polygon.colour];
    const std::uint32_t first = to.vertices;
    const auto normal = y_up(cell_faces(mesh.lattice)[polygon.face].normal, 1);
    for (std::size_t i = 0; i < polygon.corners; ++i) {
      to.add_vertex(y_up(position(mesh.lattice, polygon.corner[i]), scale), normal);
    }
    for (std::uint32_t i = 2; i < polygon.corners; ++i) {
      to.add_triangle(first, first + i - 1, first + i);
    }
  }
  return primitives;
}

}  // namespace

std::vector<GlbPrimitive> glb_surface(const Mesh& mesh, const std::vector<Brick>& bricks,
                                      double scale) {
  std::vector<GlbPrimitive> out;
  for (auto& [colour, primitive] : primitives_of(mesh, scale)) {
    const bool named = colour <= bricks.size() && !bricks[colour - 1U].name.empty();
    primitive.material = named ? bricks[colour - 1U].name : symbol_of(bricks, colour);
    primitive.rgb = rgb_of(bricks, colour);
    out.push_back(std::move(primitive));
  }
  return out;
}

std::string print_glb(const Mesh& mesh, const std::vector<Brick>& bricks, double scale) {
  assert(scale > 0);
  GlbNode node;
  node.name = "structure";
  node.primitives = glb_surface(mesh, bricks, scale);
  // An empty structure is a file without nodes: glTF forbids a mesh without primitives.
  if (node.primitives.empty()) return glb_file({});
  return glb_file({node});
}

}  // namespace stig::lattice
