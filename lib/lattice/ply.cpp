// SPDX-License-Identifier: MIT
// Binary PLY with a vertex for each corner of each polygon: normals and colours belong to
// faces, so corners cannot be shared. A hexagon is cut into two quadrilaterals.
#include <fmt/format.h>

#include <cassert>
#include <limits>

#include "base/bytes.h"
#include "lattice/mesh_files.h"
#include "lattice/rgb.h"

namespace stig::lattice {

namespace {

/// PLY's header is text whatever the body is; it names each property and its order.
constexpr std::string_view kHeader =
    "ply\n"
    "format binary_little_endian 1.0\n"
    "comment made by stigc, {} units a cell, z up\n"
    "element vertex {}\n"
    "property float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty float ny\nproperty float nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face {}\n"
    "property list uchar int vertex_indices\n"
    "end_header\n";

void put_vertex(std::string& out, Point p, Point normal, Rgb rgb) {
  for (const double value : {p.x, p.y, p.z, normal.x, normal.y, normal.z}) {
    put(out, static_cast<float>(value));
  }
  for (const std::uint8_t value : {rgb.r, rgb.g, rgb.b}) put(out, value);
}

}  // namespace

std::string print_ply(const Mesh& mesh, const std::vector<Brick>& bricks, double scale) {
  assert(scale > 0);
  std::size_t vertices = 0, quads = 0;
  for (const Polygon& polygon : mesh.polygons) {
    vertices += polygon.corners;
    quads += polygon.corners / 2U - 1;
  }
  assert(vertices <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()));
  std::string out = fmt::format(fmt::runtime(kHeader), scale, vertices, quads);
  for (const Polygon& polygon : mesh.polygons) {
    const Point normal = cell_faces(mesh.lattice)[polygon.face].normal;
    const Rgb rgb = rgb_of(bricks, polygon.colour);
    for (std::size_t i = 0; i < polygon.corners; ++i) {
      const Point p = position(mesh.lattice, polygon.corner[i]);
      put_vertex(out, {p.x * scale, p.y * scale, p.z * scale}, normal, rgb);
    }
  }
  std::int32_t first = 0;
  for (const Polygon& polygon : mesh.polygons) {
    // A fan of quadrilaterals: corners 0, 1, 2, 3 and then 0, 3, 4, 5.
    for (int i = 3; i < polygon.corners; i += 2) {
      put(out, std::uint8_t{4});
      for (const int corner : {0, i - 2, i - 1, i}) put(out, first + corner);
    }
    first += polygon.corners;
  }
  return out;
}

}  // namespace stig::lattice
