// SPDX-License-Identifier: MIT
// Binary STL has no colours and no shared corners: each triangle carries its normal and
// three corners. Slicers want closed surfaces edge to edge with an inside everywhere, so the mesh
// must not have T-junctions (Merging::none), and bricks that merely touch are parted
// (solid_surface.h).
#include <cassert>
#include <cmath>
#include <limits>

#include "base/bytes.h"
#include "lattice/mesh_files.h"
#include "lattice/solid_surface.h"

namespace stig::lattice {

namespace {

void put_point(std::string& out, Point p, double scale) {
  put(out, static_cast<float>(p.x * scale));
  put(out, static_cast<float>(p.y * scale));
  put(out, static_cast<float>(p.z * scale));
}

/// Not that of the cell's face: where corners were drawn in, triangles tilt.
Point normal_of(const SolidSurface& surface, const SolidSurface::Triangle& triangle) {
  const Point a = surface.points[triangle.corner[0]], b = surface.points[triangle.corner[1]],
              c = surface.points[triangle.corner[2]];
  const Point u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(n.x, n.y, n.z);
  return {n.x / length, n.y / length, n.z / length};
}

}  // namespace

std::string print_stl(const Mesh& mesh, double scale) {
  assert(scale > 0);
  constexpr std::size_t kHeader = 80, kTriangle = 50;
  const SolidSurface surface = solid_surface(mesh);
  assert(surface.triangles.size() <= std::numeric_limits<std::uint32_t>::max());
  std::string out = "stigc binary STL";  // must not start with "solid": that says text
  out.resize(kHeader, ' ');
  out.reserve(kHeader + 4 + kTriangle * surface.triangles.size());
  put(out, static_cast<std::uint32_t>(surface.triangles.size()));
  for (const SolidSurface::Triangle& triangle : surface.triangles) {
    put_point(out, normal_of(surface, triangle), 1);
    for (const std::uint32_t corner : triangle.corner) {
      put_point(out, surface.points[corner], scale);
    }
    put(out, std::uint16_t{0});
  }
  return out;
}

}  // namespace stig::lattice
