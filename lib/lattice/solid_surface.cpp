// SPDX-License-Identifier: MIT
// Sides of polygons are mated: two by two where two polygons meet, and brick by brick where four
// do. Corners of polygons that mated sides bring together are one point, so that a place where two
// groups of bricks touch has a point for each. An edge with four faces gets a point in its middle
// for each brick as well: its ends may be one point each when the bricks are joined further on.
#include "lattice/solid_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace stig::lattice {

namespace {

constexpr std::uint32_t kMostCorners = 6;
constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// One side of one polygon; the slot kMostCorners · polygon + k names its k-th corner and side.
struct Side {
  Corner low, high;
  std::uint32_t slot = 0;
};

struct Builder {
  const Mesh& mesh;
  SolidSurface out;
  std::vector<std::uint32_t> parent;  ///< of each slot: a forest whose trees are points
  std::vector<std::uint32_t> middle;  ///< of each slot's side: a point, or kNone
  std::vector<std::uint32_t> point;   ///< of each slot's corner

  explicit Builder(const Mesh& m)
      : mesh(m),
        parent(kMostCorners * m.polygons.size()),
        middle(parent.size(), kNone),
        point(parent.size(), kNone) {
    std::iota(parent.begin(), parent.end(), 0U);
  }

  const Polygon& polygon(std::uint32_t slot) const { return mesh.polygons[slot / kMostCorners]; }
  Corner corner(std::uint32_t slot) const { return polygon(slot).corner[slot % kMostCorners]; }
  std::uint32_t next(std::uint32_t slot) const {
    const std::uint32_t first = slot - slot % kMostCorners;
    return first + (slot - first + 1) % polygon(slot).corners;
  }
  /// Which brick a polygon belongs to, by its foot.
  Corner foot(std::uint32_t slot) const {
    const Polygon& p = polygon(slot);
    const Corner from = cell_faces(mesh.lattice)[p.face].corner[0];
    return p.corner[0] + Corner{-from.x, -from.y, -from.z};
  }

  std::uint32_t root(std::uint32_t slot) {
    for (; parent[slot] != slot; slot = parent[slot]) parent[slot] = parent[parent[slot]];
    return slot;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    // The first names the point, whatever the order of joining.
    parent[std::max(a, b)] = std::min(a, b);
  }

  /// `place`, moved by kGap towards the middle of the bricks.
  std::uint32_t add_point(Corner place, const std::vector<Corner>& feet);
  std::uint32_t add_middle(const Side& side);
  void mate(const Side& a, const Side& b);
  void mate_sides();
  void place_points();
  void put_triangles(std::uint32_t first);
};

std::uint32_t Builder::add_point(Corner place, const std::vector<Corner>& feet) {
  const Point from = position(mesh.lattice, place);
  Point towards;
  for (const Corner brick : feet) {
    const Point centre = position(mesh.lattice, brick + Corner{0, 0, 1});
    towards.x += centre.x - from.x;
    towards.y += centre.y - from.y;
    towards.z += centre.z - from.z;
  }
  const double length = std::hypot(towards.x, towards.y, towards.z);
  const double part = length > 0 ? kGap / length : 0;
  out.points.push_back(
      {from.x + part * towards.x, from.y + part * towards.y, from.z + part * towards.z});
  return static_cast<std::uint32_t>(out.points.size() - 1);
}

/// In the middle of an edge, which is no whole corner, drawn towards the side's brick.
std::uint32_t Builder::add_middle(const Side& side) {
  const std::uint32_t low = add_point(side.low, {foot(side.slot)});
  const Point a = out.points[low];
  out.points.pop_back();
  const std::uint32_t high = add_point(side.high, {foot(side.slot)});
  Point& b = out.points[high];
  b = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  return high;
}

/// Neighbours run through their common side in opposite directions.
void Builder::mate(const Side& a, const Side& b) {
  assert(corner(a.slot) == corner(next(b.slot)) && corner(b.slot) == corner(next(a.slot)));
  join(a.slot, next(b.slot));
  join(next(a.slot), b.slot);
}

void Builder::mate_sides() {
  std::vector<Side> sides;
  for (std::uint32_t p = 0; p < mesh.polygons.size(); ++p) {
    for (std::uint32_t k = 0; k < mesh.polygons[p].corners; ++k) {
      const std::uint32_t slot = kMostCorners * p + k;
      const auto [low, high] = std::minmax({corner(slot), corner(next(slot))});
      sides.push_back({low, high, slot});
    }
  }
  std::sort(sides.begin(), sides.end(), [this](const Side& a, const Side& b) {
    return std::tuple(a.low, a.high, foot(a.slot), a.slot) <
           std::tuple(b.low, b.high, foot(b.slot), b.slot);
  });
  const auto same_edge = [&](std::size_t i, std::size_t j) {
    return j < sides.size() && sides[i].low == sides[j].low && sides[i].high == sides[j].high;
  };
  for (std::size_t i = 0; i < sides.size();) {
    // Sorted by brick too, so that of four sides the first two are one brick's.
    const bool four = same_edge(i, i + 3);
    for (const std::size_t end = i + (four ? 4 : 2); i < end; i += 2) {
      assert(same_edge(i, i + 1));
      mate(sides[i], sides[i + 1]);
      if (four) middle[sides[i].slot] = middle[sides[i + 1].slot] = add_middle(sides[i]);
    }
  }
}

void Builder::place_points() {
  struct Use {
    Corner place;
    std::uint32_t root, slot;
  };
  std::vector<Use> uses;
  for (std::uint32_t p = 0; p < mesh.polygons.size(); ++p) {
    for (std::uint32_t k = 0; k < mesh.polygons[p].corners; ++k) {
      const std::uint32_t slot = kMostCorners * p + k;
      uses.push_back({corner(slot), root(slot), slot});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return std::tie(a.place, a.root, a.slot) < std::tie(b.place, b.root, b.slot);
  });
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    std::vector<Corner> feet;
    const auto one_point = [&](const Use& use) { return use.root == uses[first].root; };
    for (; last < uses.size() && one_point(uses[last]); ++last)
      feet.push_back(foot(uses[last].slot));
    std::sort(feet.begin(), feet.end());
    feet.erase(std::unique(feet.begin(), feet.end()), feet.end());
    const bool alone = (first == 0 || uses[first - 1].place != uses[first].place) &&
                       (last == uses.size() || uses[last].place != uses[first].place);
    const std::uint32_t added = add_point(uses[first].place, alone ? std::vector<Corner>{} : feet);
    for (std::size_t i = first; i < last; ++i) point[uses[i].slot] = added;
  }
}

/// A fan from the first corner; from the polygon's middle where a side has a point of its own.
void Builder::put_triangles(std::uint32_t first) {
  const Polygon& shape = polygon(first);
  std::vector<std::uint32_t> round;
  Point centre;
  for (std::uint32_t k = 0; k < shape.corners; ++k) {
    round.push_back(point[first + k]);
    if (middle[first + k] != kNone) round.push_back(middle[first + k]);
    const Point at = position(mesh.lattice, shape.corner[k]);
    centre = {centre.x + at.x / shape.corners, centre.y + at.y / shape.corners,
              centre.z + at.z / shape.corners};
  }
  if (round.size() == shape.corners) {
    for (std::size_t i = 2; i < round.size(); ++i) {
      out.triangles.push_back({{round[0], round[i - 1], round[i]}});
    }
    return;
  }
  const auto hub = static_cast<std::uint32_t>(out.points.size());
  out.points.push_back(centre);
  for (std::size_t i = 0; i < round.size(); ++i) {
    out.triangles.push_back({{hub, round[i], round[(i + 1) % round.size()]}});
  }
}

}  // namespace

SolidSurface solid_surface(const Mesh& mesh) {
  assert(mesh.polygons.size() < kNone / kMostCorners);
  Builder builder(mesh);
  builder.mate_sides();
  builder.place_points();
  for (std::uint32_t p = 0; p < mesh.polygons.size(); ++p) {
    builder.put_triangles(kMostCorners * p);
  }
  return std::move(builder.out);
}

}  // namespace stig::lattice
