// SPDX-License-Identifier: MIT
// Binary STL has no colours and no shared corners: each triangle carries its normal and
// three corners. Slicers want closed surfaces edge to edge, so the mesh must not have
// T-junctions (Merging::none).
#include <cassert>
#include <limits>

#include "base/bytes.h"
#include "lattice/mesh_files.h"

namespace stig::lattice {

namespace {

void put_point(std::string& out, Point p, double scale) {
  put(out, static_cast<float>(p.x * scale));
  put(out, static_cast<float>(p.y * scale));
  put(out, static_cast<float>(p.z * scale));
}

}  // namespace

std::string print_stl(const Mesh& mesh, double scale) {
  assert(scale > 0);
  constexpr std::size_t kHeader = 80, kTriangle = 50;
  const std::size_t triangles = mesh.triangles();
  assert(triangles <= std::numeric_limits<std::uint32_t>::max());
  std::string out = "stigc binary STL";  // must not start with "solid": that says text
  out.resize(kHeader, ' ');
  out.reserve(kHeader + 4 + kTriangle * triangles);
  put(out, static_cast<std::uint32_t>(triangles));
  for (const Polygon& polygon : mesh.polygons) {
    for (std::size_t i = 2; i < polygon.corners; ++i) {
      put_point(out, cell_faces(mesh.lattice)[polygon.face].normal, 1);
      for (const std::size_t corner : {std::size_t{0}, i - 1, i}) {
        put_point(out, position(mesh.lattice, polygon.corner[corner]), scale);
      }
      put(out, std::uint16_t{0});
    }
  }
  return out;
}

}  // namespace stig::lattice
