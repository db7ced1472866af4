// SPDX-License-Identifier: MIT
#include "lattice/mesh.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>

#include "lattice/structure_text.h"
#include "support/any_structure.h"
#include "support/uses.h"

namespace stig {
namespace {

Point minus(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Area times the outward normal of a polygon.
Point vector_area(const Mesh& mesh, const Polygon& polygon) {
  const Point first = position(mesh.lattice, polygon.corner[0]);
  Point sum;
  for (std::size_t i = 2; i < polygon.corners; ++i) {
    const Point n = cross(minus(position(mesh.lattice, polygon.corner[i - 1]), first),
                          minus(position(mesh.lattice, polygon.corner[i]), first));
    sum = {sum.x + n.x / 2, sum.y + n.y / 2, sum.z + n.z / 2};
  }
  return sum;
}

double cell_volume(Lattice lattice) { return lattice == Lattice::cubic ? 1 : std::sqrt(0.75); }

double face_area(Lattice lattice, const CellFace& face) {
  if (lattice == Lattice::cubic) return 1;
  return face.corners == 6 ? cell_volume(lattice) : 1 / std::sqrt(3.0);
}

struct Totals {
  double area = 0, volume = 0;
  Point closure;
};

// By the divergence theorem: the volume is a third of the sum of place · area.
Totals totals(const Mesh& mesh) {
  Totals t;
  for (const Polygon& polygon : mesh.polygons) {
    const Point area = vector_area(mesh, polygon);
    t.area += dot(area, cell_faces(mesh.lattice)[polygon.face].normal);
    t.volume += dot(position(mesh.lattice, polygon.corner[0]), area) / 3;
    t.closure = {t.closure.x + area.x, t.closure.y + area.y, t.closure.z + area.z};
  }
  return t;
}

bool near(double a, double b) { return std::abs(a - b) < 1e-9 * (1 + std::abs(a)); }

TEST_CASE("faces look outward, at the cell they border on") {
  for (const Lattice lattice : {Lattice::cubic, Lattice::hexagonal}) {
    for (const CellFace& face : cell_faces(lattice)) {
      Polygon polygon{1, 0, static_cast<std::uint8_t>(face.corners), face.corner};
      const Point area = vector_area({lattice, {}}, polygon);
      const Point across = embed(lattice, Cell{} + face.towards);
      CHECK(near(dot(area, face.normal), face_area(lattice, face)));
      CHECK(near(dot(across, face.normal), 1));
      CHECK(near(dot(across, across), 1));
    }
  }
}

TEST_CASE("a face is its neighbour's face on the other side, corner for corner") {
  for (const Lattice lattice : {Lattice::cubic, Lattice::hexagonal}) {
    const auto& faces = cell_faces(lattice);
    for (const CellFace& face : faces) {
      const auto other = std::find_if(faces.begin(), faces.end(), [&](const CellFace& f) {
        return f.towards == -face.towards;
      });
      REQUIRE(other != faces.end());
      std::vector<Corner> here, there;
      for (std::size_t i = 0; i < static_cast<std::size_t>(face.corners); ++i) {
        here.push_back(face.corner[i]);
        there.push_back(foot_of(lattice, Cell{} + face.towards) + other->corner[i]);
      }
      std::sort(here.begin(), here.end());
      std::sort(there.begin(), there.end());
      CHECK(here == there);
    }
  }
}

TEST_CASE("a cell stands around its embedded centre, with its foot at its height") {
  for (const Lattice lattice : {Lattice::cubic, Lattice::hexagonal}) {
    const Cell cell{3, -2, 5};
    const Point foot = position(lattice, foot_of(lattice, cell));
    const Point centre = embed(lattice, cell);
    CHECK(near(foot.x, centre.x));
    CHECK(near(foot.y, centre.y));
    CHECK(near(foot.z, centre.z));
  }
}

TEST_CASE("law: the surface has the area of the exposed faces, is closed, and holds the bricks") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice(), 2);
    double area = 0;
    for (const PlacedBrick& brick : s.bricks()) {
      for (const CellFace& face : cell_faces(s.lattice())) {
        if (s.at(brick.at + face.towards) == kEmpty) area += face_area(s.lattice(), face);
      }
    }
    for (const Merging merging : {Merging::none, Merging::faces}) {
      const Totals t = totals(surface(s, merging));
      RC_ASSERT(near(t.area, area));
      RC_ASSERT(near(t.volume, static_cast<double>(s.size()) * cell_volume(s.lattice())));
      RC_ASSERT(near(dot(t.closure, t.closure), 0));
    }
  }));
}

TEST_CASE("law: every edge of an unmerged surface is run through as often both ways") {
  CHECK(rc::check([] {
    const Mesh mesh = surface(any_structure(any_lattice()), Merging::none);
    std::map<std::pair<Corner, Corner>, int> balance;
    for (const Polygon& polygon : mesh.polygons) {
      for (std::size_t i = 0; i < polygon.corners; ++i) {
        const Corner a = polygon.corner[i];
        const Corner b = polygon.corner[(i + 1) % polygon.corners];
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    for (const auto& [edge, sum] : balance) RC_ASSERT(sum == 0);
  }));
}

TEST_CASE("law: colours keep their area when faces are merged") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice(), 3);
    std::map<Colour, double> balance;
    for (const Polygon& p : surface(s, Merging::none).polygons)
      balance[p.colour] += 1 - (p.corners == 6);
    std::map<Colour, double> merged;
    const Mesh mesh = surface(s, Merging::faces);
    for (const Polygon& p : mesh.polygons) {
      if (p.corners == 6) continue;
      const Point area = vector_area(mesh, p);
      merged[p.colour] +=
          std::sqrt(dot(area, area)) * (s.lattice() == Lattice::cubic ? 1 : std::sqrt(3.0));
    }
    for (const auto& [colour, area] : balance) {
      if (area > 0) RC_ASSERT(near(merged[colour], area));
    }
  }));
}

TEST_CASE("rectangles of one colour become one polygon") {
  CHECK(surface(structure_literal("1 1 1\n1 1 1\n---\n1 1 1\n1 1 1"), Merging::faces)
            .polygons.size() == 6);
  CHECK(surface(structure_literal("1 1 2\n1 1 2"), Merging::faces).polygons.size() == 10);
  CHECK(surface(structure_literal("1 1\n1 ."), Merging::faces).polygons.size() == 2 * 2 + 6);
  CHECK(surface(structure_literal("1"), Merging::none).triangles() == 12);
}

TEST_CASE("sides of a column of prisms merge along the vertical") {
  const Structure s = structure_literal("1\n---\n1\n---\n1", Lattice::hexagonal);
  CHECK(surface(s, Merging::none).polygons.size() == 20);
  CHECK(surface(s, Merging::faces).polygons.size() == 8);
  CHECK(surface(s, Merging::faces).triangles() == 6 * 2 + 2 * 4);
}

TEST_CASE("an empty structure has no surface") {
  CHECK(surface(Structure(), Merging::faces).polygons.empty());
}

}  // namespace
}  // namespace stig
