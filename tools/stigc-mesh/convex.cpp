// SPDX-License-Identifier: MIT
// A cell is a box with the triangles that reach into it. What of the model lies in it has its
// corners among those of the triangles cut to the box, which include where edges of the box pass
// through the surface, and those corners of the box that are in the model. Its volume is a sum over
// the same polygons, by the divergence theorem along x.
#include "convex.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "inside.h"

namespace stig::meshes {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr int kTries = 9;  ///< planes that are tried along an axis, besides those through corners
constexpr std::size_t kFewPlaces = 40;  ///< of so many different corners all planes are tried
/// Directions along which far places are looked for when cuts are compared: the hull of these is
/// nearly that of all, and takes no longer however many triangles there are.
constexpr std::size_t kDirections = 96;

/// Faces that cuts are compared by; of more, every second, third and so on.
constexpr std::size_t kCompared = 5000;
/// What cuts have to save, as part of the hull, to be preferred to others: one at the end of a cell
/// to one through its middle, one across a cell to one along it, times how much shorter it is
/// there, and one that is through no corner. The first cut of a ring saves nothing, whatever it is,
/// and only halves of it, cut across, are worth cutting again.
constexpr double kBeside = 0.05, kAcross = 0.05, kNoCorner = 0.02;

using Polygon = std::vector<Point>;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Of a polygon the part where sign · coordinate <= sign · level (Sutherland and Hodgman).
void cut(Polygon& polygon, std::size_t axis, double level, double sign, Polygon& scratch) {
  scratch.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    const Point& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double at = sign * (p[axis] - level), next = sign * (q[axis] - level);
    if (at <= 0) scratch.push_back(p);
    if ((at < 0 && next > 0) || (at > 0 && next < 0)) {
      Point on{};
      for (std::size_t k = 0; k < 3; ++k) on[k] = p[k] + (q[k] - p[k]) * (at / (at - next));
      on[axis] = level;
      scratch.push_back(on);
    }
  }
  polygon.swap(scratch);
}

/// Twice the polygon's area as seen against an axis: positive where it faces along it.
double facing(const Polygon& p, std::size_t axis) {
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  double out = 0;
  for (std::size_t i = 2; i < p.size(); ++i) {
    out += (p[i - 1][a] - p[0][a]) * (p[i][b] - p[0][b]) -
           (p[i][a] - p[0][a]) * (p[i - 1][b] - p[0][b]);
  }
  return out;
}

/// Whether the solid behind a polygon is on the side where sign · coordinate <= sign · level. Only
/// asked of what is cut to that side: a polygon in the plane may bound what is on the other.
bool bounds_side(const Polygon& polygon, std::size_t axis, double level, double sign) {
  const bool in_plane =
      std::all_of(polygon.begin(), polygon.end(), [&](const Point& p) { return p[axis] == level; });
  return !in_plane || sign * facing(polygon, axis) > 0;
}

struct Hull {
  Surface surface;
  double volume = 0;
};

Hull hull_of(const std::vector<Point>& places) {
  std::vector<Kernel::Point_3> points;
  for (const Point& p : places) points.emplace_back(p[0], p[1], p[2]);
  Hull out;
  if (points.size() < 4) return out;
  CGAL::convex_hull_3(points.begin(), points.end(), out.surface);
  if (out.surface.number_of_faces() < 4) return out;
  const auto from = out.surface.point(*out.surface.vertices().begin());
  for (const auto face : out.surface.faces()) {
    std::array<Kernel::Vector_3, 3> v;
    std::size_t i = 0;
    for (const auto vertex : out.surface.vertices_around_face(out.surface.halfedge(face))) {
      v[i++] = out.surface.point(vertex) - from;
    }
    out.volume += v[0] * CGAL::cross_product(v[1], v[2]) / 6;
  }
  return out;
}

/// Evenly over the sphere, along a spiral (Saff and Kuijlaars 1997).
const std::vector<Point>& directions() {
  static const std::vector<Point> kAll = [] {
    std::vector<Point> out;
    for (std::size_t i = 0; i < kDirections; ++i) {
      const double z = 1 - (2 * static_cast<double>(i) + 1) / kDirections;
      const double r = std::sqrt(1 - z * z), a = static_cast<double>(i) * 2.399963229728653;
      out.push_back({r * std::cos(a), r * std::sin(a), z});
    }
    return out;
  }();
  return kAll;
}

/// Of many places those that are farthest along some direction.
std::vector<Point> far_places(const std::vector<Point>& places) {
  if (places.size() <= 4 * kDirections) return places;
  std::vector<Point> out;
  for (const Point& way : directions()) {
    out.push_back(*std::max_element(
        places.begin(), places.end(),
        [&way](const Point& a, const Point& b) { return dot(a, way) < dot(b, way); }));
  }
  return out;
}

struct Cell {
  Point low{}, high{};
  std::vector<Polygon> faces;  ///< cut to the box
  /// Faces beyond its end along x, pressed onto that end: with the faces they close the volume.
  std::vector<Polygon> beyond;
  std::vector<Point> places;  ///< whose hull is the piece
  double volume = 0;          ///< of the model in it
  double hull = 0;            ///< volume of that hull

  double excess() const { return hull - volume; }
};

/// The volume between the polygons and the plane x = low.
double volume_over(const std::vector<Polygon>& faces, double low) {
  double out = 0;
  for (const Polygon& p : faces) {
    for (std::size_t i = 2; i < p.size(); ++i) {
      // Area as seen along x, times the mean distance from the plane: exact, as it is linear.
      out += facing({p[0], p[i - 1], p[i]}, 0) / 2 * ((p[0][0] + p[i - 1][0] + p[i][0]) / 3 - low);
    }
  }
  return out;
}

class Decomposition {
 public:
  explicit Decomposition(const Model& model) : inside_(model) {
    Cell whole;
    whole.low = whole.high = model.points.front();
    for (const Point& p : model.points) {
      for (std::size_t k = 0; k < 3; ++k) {
        whole.low[k] = std::min(whole.low[k], p[k]);
        whole.high[k] = std::max(whole.high[k], p[k]);
      }
    }
    for (const auto& t : model.triangles) {
      whole.faces.push_back({model.points[t[0]], model.points[t[1]], model.points[t[2]]});
    }
    whole.places = model.points;
    whole.hull = hull_of(far_places(whole.places)).volume;
    whole.volume = std::min(volume_over(whole.faces, whole.low[0]), whole.hull);
    volume_ = whole.volume;
    cells_.push_back(std::move(whole));
  }

  const std::vector<Cell>& run(std::size_t most) {
    while (cells_.size() < most) {
      double excess = 0;
      for (const Cell& cell : cells_) excess += cell.excess();
      if (excess <= kMostExcess * volume_) break;
      if (!split_worst()) break;
    }
    return cells_;
  }

 private:
  struct Cut {
    std::size_t axis = 0;
    double level = 0;
    double cost = std::numeric_limits<double>::infinity();
  };

  bool split_worst() {
    auto worst = std::max_element(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) {
      return a.excess() < b.excess();
    });
    const Cut best = best_cut(*worst);
    if (!std::isfinite(best.cost)) return false;
    std::pair<Cell, Cell> halves;
    fill(*worst, best, 1, 1, halves.first);
    fill(*worst, best, -1, 1, halves.second);
    measure(*worst, best, 1, halves.first);
    measure(*worst, best, -1, halves.second);
    *worst = std::move(halves.first);
    cells_.push_back(std::move(halves.second));
    std::erase_if(cells_, [](const Cell& cell) { return !(cell.hull > 0); });
    return true;
  }

  Cut best_cut(const Cell& cell) const {
    Cut best;
    const std::size_t step = cell.faces.size() / kCompared + 1;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, cell.high[k] - cell.low[k]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const auto& [level, through_corner] : levels(cell, axis)) {
        Cut cut{axis, level, 0};
        Cell below, above;
        fill(cell, cut, 1, step, below);
        fill(cell, cut, -1, step, above);
        if (!(below.hull > 0 && above.hull > 0)) continue;
        const double size = cell.high[axis] - cell.low[axis];
        const double beside = std::abs(level - (cell.low[axis] + cell.high[axis]) / 2) / size;
        const double extra =
            kBeside * beside + kAcross * (longest / size - 1) + (through_corner ? 0 : kNoCorner);
        cut.cost = below.hull + above.hull + extra * cell.hull;
        if (cut.cost < best.cost) best = cut;
      }
    }
    return best;
  }

  /// Where a plane is tried: through corners, of which a drawing has few, and evenly spread. With
  /// each, whether it is through one.
  static std::vector<std::pair<double, bool>> levels(const Cell& cell, std::size_t axis) {
    const double low = cell.low[axis], length = cell.high[axis] - low, margin = 1e-6 * length;
    std::vector<double> corners;
    for (const Point& p : cell.places) corners.push_back(p[axis]);
    std::sort(corners.begin(), corners.end());
    const auto near = [margin](double a, double b) { return b - a <= margin; };
    corners.erase(std::unique(corners.begin(), corners.end(), near), corners.end());
    std::vector<std::pair<double, bool>> out;
    const auto add = [&](double level, bool through_corner) {
      if (level <= low + margin || level >= low + length - margin) return;
      out.emplace_back(level, through_corner);
    };
    if (corners.size() <= kFewPlaces) {
      for (const double level : corners) add(level, true);
    }
    for (int i = 1; i <= kTries; ++i) add(low + length * i / (kTries + 1), false);
    return out;
  }

  /// The half where sign · coordinate <= sign · level, but for its volume; of every `step`th face.
  void fill(const Cell& cell, const Cut& at, double sign, std::size_t step, Cell& out) const {
    out.low = cell.low;
    out.high = cell.high;
    (sign > 0 ? out.high : out.low)[at.axis] = at.level;
    Polygon polygon, scratch;
    for (std::size_t i = 0; i < cell.faces.size(); i += step) {
      polygon = cell.faces[i];
      cut(polygon, at.axis, at.level, sign, scratch);
      if (polygon.size() < 3 || !bounds_side(polygon, at.axis, at.level, sign)) continue;
      out.places.insert(out.places.end(), polygon.begin(), polygon.end());
      out.faces.push_back(polygon);
    }
    for (unsigned i = 0; i < 8; ++i) {
      // Asked a little within the cell: the corner itself may be on what is solid beside it.
      Point corner{}, within{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [here, there] = (i >> k & 1U) != 0 ? std::pair(out.high[k], out.low[k])
                                                      : std::pair(out.low[k], out.high[k]);
        corner[k] = here;
        within[k] = here + (there - here) * 1e-6;
      }
      if (inside_.winding(within) > 0) out.places.push_back(corner);
    }
    out.hull = hull_of(far_places(out.places)).volume;
  }

  void measure(const Cell& cell, const Cut& at, double sign, Cell& out) const {
    Polygon polygon, scratch;
    const auto press = [&out](Polygon flat) {
      for (Point& p : flat) p[0] = out.high[0];
      if (flat.size() >= 3) out.beyond.push_back(std::move(flat));
    };
    for (const Polygon& one : cell.beyond) {
      polygon = one;
      if (at.axis != 0) cut(polygon, at.axis, at.level, sign, scratch);
      press(polygon);
    }
    for (const Polygon& face : cell.faces) {
      if (at.axis != 0 || sign < 0) break;
      polygon = face;
      cut(polygon, at.axis, at.level, -1, scratch);
      if (bounds_side(polygon, at.axis, at.level, -1)) press(polygon);
    }
    const double volume = volume_over(out.faces, out.low[0]) + volume_over(out.beyond, out.low[0]);
    // What surfaces enclose twice counts twice: a hull has all of it.
    out.volume = std::clamp(volume, 0.0, out.hull);
  }

  Inside inside_;
  double volume_ = 0;
  std::vector<Cell> cells_;
};

/// How far places are outside of a hull: the one that is farthest, by its number.
std::pair<std::size_t, double> farthest(const std::vector<Point>& places, const Hull& hull) {
  std::vector<std::pair<Point, double>> planes;
  for (const auto face : hull.surface.faces()) {
    std::array<Point, 3> v{};
    std::size_t i = 0;
    for (const auto vertex : hull.surface.vertices_around_face(hull.surface.halfedge(face))) {
      const auto& p = hull.surface.point(vertex);
      v[i++] = {p.x(), p.y(), p.z()};
    }
    Point n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
    const double size = std::sqrt(dot(n, n));
    if (!(size > 0)) continue;
    for (double& x : n) x /= size;
    planes.emplace_back(n, dot(n, v[0]));
  }
  std::pair<std::size_t, double> out{0, 0};
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const auto& [n, level] : planes) {
      const double above = dot(n, places[i]) - level;
      if (above > out.second) out = {i, above};
    }
  }
  return out;
}

/// Few of a hull's corners, such that none of the others is far outside of their hull: each time
/// the farthest is taken as well.
std::vector<Point> few_corners(const std::vector<Point>& places, double& off) {
  const Hull whole = hull_of(places);
  std::vector<Point> all;
  for (const auto vertex : whole.surface.vertices()) {
    const auto& p = whole.surface.point(vertex);
    all.push_back({p.x(), p.y(), p.z()});
  }
  // In an order that is the numbers' own.
  std::sort(all.begin(), all.end());
  if (all.size() < 4) return {};
  Point low = all.front(), high = low;
  std::vector<Point> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto by = [k](const Point& a, const Point& b) { return a[k] < b[k]; };
    for (const Point& p : {*std::min_element(all.begin(), all.end(), by),
                           *std::max_element(all.begin(), all.end(), by)}) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
      if (std::find(out.begin(), out.end(), p) == out.end()) out.push_back(p);
    }
  }
  const Point diagonal = minus(high, low);
  const double rounding = 1e-7 * std::sqrt(dot(diagonal, diagonal));
  for (const Point& p : all) {
    if (hull_of(out).volume > 0) break;
    if (std::find(out.begin(), out.end(), p) == out.end()) out.push_back(p);
  }
  while (out.size() < kMostCorners) {
    const auto [next, distance] = farthest(all, hull_of(out));
    if (distance <= rounding) return out;
    out.push_back(all[next]);
  }
  off = std::max(off, farthest(all, hull_of(out)).second);
  return out;
}

}  // namespace

bool decompose(const Model& model, std::size_t most, Pieces& pieces, std::string& problem) {
  pieces = {};
  Decomposition decomposition(model);
  for (const Cell& cell : decomposition.run(most)) {
    std::vector<Point> corners = few_corners(cell.places, pieces.off);
    const double volume = hull_of(corners).volume;
    if (!(volume > 0)) continue;
    pieces.volume += volume;
    pieces.corners.push_back(std::move(corners));
  }
  if (pieces.corners.empty()) problem = "encloses no volume";
  return problem.empty();
}

}  // namespace stig::meshes
