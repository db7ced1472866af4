// SPDX-License-Identifier: MIT
// From polygons in any order to surfaces that bound something: corners in one place are made one,
// faces without area are dropped, neighbours are turned alike, holes are closed. Each connected
// surface is then told by its volume's sign and by what lies around it: the outermost bound a
// solid, those within them a hollow, and so on. Surfaces that pass through each other both bound
// solids, whose union is meant: models are often put together of parts that overlap.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "inside.h"
#include "model.h"

namespace stig::meshes {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Border = boost::graph_traits<Surface>::halfedge_descriptor;

/// Corners made one, faces turned alike, no face without area.
bool make_surface(Soup& soup, Surface& surface, Repairs& repairs, std::string& problem) {
  std::vector<Kernel::Point_3> points;
  for (const Point& p : soup.points) points.emplace_back(p[0], p[1], p[2]);
  const std::size_t corners = points.size(), faces = soup.faces.size();
  pmp::repair_polygon_soup(points, soup.faces);
  repairs.duplicate_points = corners - points.size();
  repairs.degenerate_faces = faces - soup.faces.size();
  const std::size_t merged = points.size();
  pmp::orient_polygon_soup(points, soup.faces);
  repairs.split_points = points.size() - merged;
  if (soup.faces.empty() || !pmp::is_polygon_soup_a_polygon_mesh(soup.faces)) {
    problem = "has no faces that make a surface";
    return false;
  }
  pmp::polygon_soup_to_polygon_mesh(points, soup.faces, surface);
  pmp::stitch_borders(surface);
  // By way of filling holes, which ends for faces that are bent or cross themselves too: CGAL's
  // triangulation in their plane need not.
  if (!pmp::triangulate_faces(surface, CGAL::parameters::use_delaunay_triangulation(false))) {
    problem = "has a face that cannot be cut into triangles";
    return false;
  }
  const std::size_t whole = surface.number_of_faces();
  pmp::remove_degenerate_faces(surface);
  surface.collect_garbage();
  repairs.degenerate_faces += whole - std::min<std::size_t>(whole, surface.number_of_faces());
  return true;
}

bool close_holes(Surface& surface, Repairs& repairs, std::string& problem) {
  std::vector<Border> borders;
  pmp::extract_boundary_cycles(surface, std::back_inserter(borders));
  for (const Border border : borders) {
    std::vector<Surface::Face_index> patch;
    pmp::triangulate_hole(surface, border, std::back_inserter(patch));
    if (patch.empty()) {
      problem = "has a hole that cannot be closed";
      return false;
    }
    ++repairs.holes;
  }
  return true;
}

/// One of a model's connected surfaces.
struct Part {
  Model model;
  double volume = 0;
  Point low{}, high{};
  bool hollow = false;
};

/// Six times the volume under a triangle, from a place near it, so that far models lose no digits.
double volume_under(const Model& model, const std::array<std::uint32_t, 3>& triangle,
                    const Point& from) {
  std::array<Point, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) v[i][k] = model.points[triangle[i]][k] - from[k];
  }
  return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
         v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
         v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}

void turn_over(Model& model) {
  for (auto& triangle : model.triangles) std::swap(triangle[1], triangle[2]);
}

std::vector<Part> parts_of(const Surface& surface) {
  using FaceIndex = Surface::Face_index;
  std::vector<std::size_t> number(surface.number_of_faces());
  const auto map =
      boost::make_iterator_property_map(number.begin(), get(boost::face_index, surface));
  std::vector<Part> parts(pmp::connected_components(surface, map));
  std::vector<std::vector<std::int64_t>> places(parts.size());
  std::vector<std::pair<std::size_t, std::uint32_t>> at(surface.number_of_vertices(),
                                                        {SIZE_MAX, 0});
  for (const FaceIndex face : surface.faces()) {
    const std::size_t part = number[face];
    Model& model = parts[part].model;
    std::array<std::uint32_t, 3> triangle{};
    std::size_t corner = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face))) {
      // A corner belongs to one part alone: parts share none.
      auto& [owner, place] = at[vertex];
      if (owner != part) {
        owner = part;
        place = static_cast<std::uint32_t>(model.points.size());
        const auto& p = surface.point(vertex);
        model.points.push_back({p.x(), p.y(), p.z()});
      }
      triangle[corner++] = place;
    }
    model.triangles.push_back(triangle);
  }
  for (Part& part : parts) {
    part.low = part.high = part.model.points.front();
    for (const Point& p : part.model.points) {
      for (std::size_t k = 0; k < 3; ++k) {
        part.low[k] = std::min(part.low[k], p[k]);
        part.high[k] = std::max(part.high[k], p[k]);
      }
    }
    for (const auto& t : part.model.triangles) part.volume += volume_under(part.model, t, part.low);
    part.volume /= 6;
  }
  return parts;
}

/// Less than a billionth of its box is no volume.
bool is_flat(const Part& part) {
  double box = 1;
  for (std::size_t k = 0; k < 3; ++k) box *= part.high[k] - part.low[k];
  return !(std::abs(part.volume) > 1e-9 * box) || !(box > 0);
}

/// Whether all of `inner` lies within `outer`; both are turned outwards.
bool contains(const Part& outer, const Inside& inside_outer, const Part& inner) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (inner.low[k] < outer.low[k] || inner.high[k] > outer.high[k]) return false;
  }
  return std::all_of(inner.model.points.begin(), inner.model.points.end(),
                     [&](const Point& p) { return inside_outer.winding(p) > 0; });
}

void orient_parts(std::vector<Part>& parts, Repairs& repairs) {
  for (Part& part : parts) {
    if (part.volume > 0) continue;
    turn_over(part.model);
    part.volume = -part.volume;
    ++repairs.turned_surfaces;
  }
  std::vector<std::size_t> around(parts.size(), 0);
  for (std::size_t outer = 0; outer < parts.size() && parts.size() > 1; ++outer) {
    const Inside inside(parts[outer].model);
    for (std::size_t inner = 0; inner < parts.size(); ++inner) {
      if (inner == outer || parts[inner].volume > parts[outer].volume) continue;
      around[inner] += contains(parts[outer], inside, parts[inner]) ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].hollow = around[i] % 2 == 1;
    if (!parts[i].hollow) continue;
    turn_over(parts[i].model);
    // Files rightly have the walls of a hollow turned inwards.
    if (repairs.turned_surfaces > 0) --repairs.turned_surfaces;
  }
}

}  // namespace

bool repair(Soup soup, Model& model, Repairs& repairs, std::string& problem) {
  Surface surface;
  if (!make_surface(soup, surface, repairs, problem)) return false;
  if (!close_holes(surface, repairs, problem)) return false;
  surface.collect_garbage();
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> crossing;
  pmp::self_intersections(surface, std::back_inserter(crossing));
  repairs.crossing_faces = crossing.size();
  std::vector<Part> parts = parts_of(surface);
  repairs.flat_surfaces = std::erase_if(parts, is_flat);
  if (parts.empty()) {
    problem = "bounds no volume";
    return false;
  }
  orient_parts(parts, repairs);
  for (const Part& part : parts) {
    ++(part.hollow ? repairs.hollows : repairs.solids);
    repairs.volume += part.hollow ? -part.volume : part.volume;
    const auto offset = static_cast<std::uint32_t>(model.points.size());
    model.points.insert(model.points.end(), part.model.points.begin(), part.model.points.end());
    for (const auto& t : part.model.triangles) {
      model.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
  }
  return true;
}

}  // namespace stig::meshes
