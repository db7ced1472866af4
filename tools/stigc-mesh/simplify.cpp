// SPDX-License-Identifier: MIT
// Edges are taken away where that changes a surface least (Lindstrom and Turk 1998), as CGAL has
// it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "convex.h"

namespace stig::meshes {

Model simplified(const Model& model, std::size_t triangles) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  namespace sms = CGAL::Surface_mesh_simplification;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  if (model.triangles.size() <= triangles) return model;
  std::vector<Kernel::Point_3> points;
  for (const Point& p : model.points) points.emplace_back(p[0], p[1], p[2]);
  Surface surface;
  pmp::polygon_soup_to_polygon_mesh(points, model.triangles, surface);
  // A closed surface of triangles has three edges for two of them.
  sms::Count_stop_predicate<Surface> stop(triangles * 3 / 2);
  sms::edge_collapse(surface, stop);
  surface.collect_garbage();
  Model out;
  for (const auto vertex : surface.vertices()) {
    const auto& p = surface.point(vertex);
    out.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto face : surface.faces()) {
    std::array<std::uint32_t, 3> triangle{};
    std::size_t i = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face))) {
      triangle[i++] = static_cast<std::uint32_t>(vertex.idx());
    }
    out.triangles.push_back(triangle);
  }
  return out;
}

}  // namespace stig::meshes
