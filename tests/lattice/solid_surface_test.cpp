// SPDX-License-Identifier: MIT
#include "lattice/solid_surface.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>
#include <set>

#include "lattice/structure_text.h"
#include "support/any_structure.h"
#include "support/uses.h"

namespace stig {
namespace {

/// As a reader of .stl sees it, which knows places alone.
using Place = std::array<float, 3>;
Place place_of(const Point& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// What keeps a surface from being a closed manifold; empty when it is one.
std::string flaw(const SolidSurface& surface) {
  std::map<std::pair<Place, Place>, int> runs;
  std::map<Place, std::map<Place, Place>> fans;  // about each place: from one neighbour to the next
  for (const auto& triangle : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Place a = place_of(surface.points[triangle.corner[i]]);
      const Place b = place_of(surface.points[triangle.corner[(i + 1) % 3]]);
      const Place c = place_of(surface.points[triangle.corner[(i + 2) % 3]]);
      if (a == b) return "a triangle without area";
      if (++runs[{a, b}] > 1) return "an edge with more than two triangles";
      fans[a][b] = c;
    }
  }
  for (const auto& [run, count] : runs) {
    if (runs.count({run.second, run.first}) == 0) return "an edge with one triangle";
  }
  for (const auto& [place, fan] : fans) {
    std::size_t length = 0;
    Place at = fan.begin()->first;
    do {
      at = fan.at(at);
      ++length;
    } while (at != fan.begin()->first && length <= fan.size());
    if (length != fan.size()) return "a corner with more than one fan";
  }
  return "";
}

/// By the divergence theorem.
double volume(const SolidSurface& surface) {
  double sum = 0;
  for (const auto& triangle : surface.triangles) {
    const Point a = surface.points[triangle.corner[0]], b = surface.points[triangle.corner[1]],
                c = surface.points[triangle.corner[2]];
    sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
  }
  return sum / 6;
}

SolidSurface solid(const Structure& structure) {
  return solid_surface(surface(structure, Merging::none));
}

TEST_CASE("law: the surface is a closed manifold, whatever touches") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice(), 3);
    const SolidSurface made = solid(s);
    RC_ASSERT(flaw(made) == "");
    const double whole =
        static_cast<double>(s.size()) * (s.lattice() == Lattice::cubic ? 1 : std::sqrt(0.75));
    // Eight corners of a brick and twelve edges at most are drawn in.
    RC_ASSERT(std::abs(volume(made) - whole) <= 20 * kGap * whole + 1e-9);
  }));
}

TEST_CASE("every way to fill the eight cells about a corner gives a closed manifold") {
  for (int filled = 1; filled < 256; ++filled) {
    Structure s;
    for (int i = 0; i < 8; ++i) {
      if ((filled >> i & 1) != 0) s.place({i & 1, i >> 1 & 1, i >> 2}, 1);
    }
    CAPTURE(filled);
    CHECK(flaw(solid(s)) == "");
  }
}

TEST_CASE("every way to fill the six prisms about a corner gives a closed manifold") {
  constexpr Cell kAbout[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  for (unsigned filled = 1; filled < 64; ++filled) {
    Structure s(Lattice::hexagonal);
    for (unsigned i = 0; i < 6; ++i) {
      if ((filled >> i & 1U) != 0) s.place(kAbout[i], 1);
    }
    CAPTURE(filled);
    CHECK(flaw(solid(s)) == "");
  }
}

TEST_CASE("the check of surfaces sees bricks that touch") {
  SolidSurface made = solid(structure_literal("1 .\n. 1"));
  CHECK(flaw(made) == "");
  for (Point& p : made.points)
    p = {std::round(p.x * 2) / 2, std::round(p.y * 2) / 2, std::round(p.z * 2) / 2};
  CHECK(flaw(made) == "an edge with more than two triangles");
}

TEST_CASE("nothing moves where bricks meet by their faces") {
  const Mesh mesh = surface(structure_literal("1 1\n1 .\n---\n1 .\n. ."), Merging::none);
  const SolidSurface made = solid_surface(mesh);
  CHECK(made.triangles.size() == mesh.triangles());
  for (const Point& p : made.points) {
    CHECK(p.x * 2 == std::round(p.x * 2));
    CHECK(p.y * 2 == std::round(p.y * 2));
    CHECK(p.z * 2 == std::round(p.z * 2));
  }
  CHECK(solid_surface(surface(Structure(), Merging::none)).triangles.empty());
}

}  // namespace
}  // namespace stig
