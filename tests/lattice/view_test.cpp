// SPDX-License-Identifier: MIT
#include "lattice/view.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <array>
#include <optional>

#include "lattice/structure_text.h"
#include "support/any_structure.h"
#include "support/uses.h"

namespace stig {
namespace {

// Oracle: walks from the viewer to a point in small steps until a brick is met.
// Cells by nearest centre: exact for both lattices, whose cells are Voronoi cells.
std::optional<Cell> brick_at(const Structure& s, Point p) {
  for (const PlacedBrick& brick : s.bricks()) {
    const Point c = embed(s.lattice(), brick.at);
    bool inside = p.z >= c.z && p.z < c.z + 1;
    for (const CellFace& face : cell_faces(s.lattice())) {
      const double out = (p.x - c.x) * face.normal.x + (p.y - c.y) * face.normal.y;
      if (face.normal.z == 0) inside = inside && out < 0.5;
    }
    if (inside) return brick.at;
  }
  return std::nullopt;
}

// Direction to the viewer: square to both axes of the page, unit length.
Point to_viewer(Lattice lattice) {
  const auto axis = [&](Point p) { return project(lattice, p); };
  const PagePoint x = axis({1, 0, 0}), y = axis({0, 1, 0}), z = axis({0, 0, 1});
  return {-(y.x * z.y - y.y * z.x), -(z.x * x.y - z.y * x.x), -(x.x * y.y - x.y * y.x)};
}

bool inside(const std::vector<PagePoint>& outline, PagePoint p) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PagePoint a = outline[i], b = outline[(i + 1) % outline.size()];
    const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    ++(side >= 0 ? left : right);
  }
  return left == 0 || right == 0;
}

// The brick whose face is painted last over a place of the page.
std::optional<Cell> painted(const Structure& s, const LatticeCamera& camera, PagePoint p) {
  std::optional<Cell> last;
  for (const ShownFace& shown : shown_faces(s, camera)) {
    const CellFace& face = cell_faces(s.lattice())[shown.face];
    std::vector<PagePoint> outline;
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corners); ++i) {
      const Corner corner = foot_of(s.lattice(), shown.at) + face.corner[i];
      outline.push_back(project(camera, position(s.lattice(), corner)));
    }
    if (inside(outline, p)) last = shown.at;
  }
  return last;
}

std::optional<Cell> seen(const Structure& s, Point v, Point through) {
  for (double t = 12; t > -12; t -= 0.01) {
    const auto brick = brick_at(s, {through.x + t * v.x, through.y + t * v.y, through.z + t * v.z});
    if (brick) return brick;
  }
  return std::nullopt;
}

TEST_CASE("the viewer stands above, in front and to the right of x") {
  for (const Lattice lattice : {Lattice::cubic, Lattice::hexagonal}) {
    const Point v = to_viewer(lattice);
    CHECK(v.x > 0);
    CHECK(v.y < 0);
    CHECK(v.z == doctest::Approx(0.5));
    CHECK(v.x * v.x + v.y * v.y + v.z * v.z == doctest::Approx(1));
    CHECK(project(lattice, {1, 0, 0}).x > 0);
    CHECK(project(lattice, {1, 0, 0}).y > 0);
    CHECK(project(lattice, {0, 0, 1}).x == doctest::Approx(0));
    CHECK(project(lattice, {0, 0, 1}).y < 0);
  }
}

void check_painting(const Structure& s, const LatticeCamera& camera, Point v) {
  const auto coordinate = [] { return *rc::gen::inRange(-1500, 1500) / 1000.0 + 0.00037; };
  const Point through{coordinate(), coordinate(), coordinate()};
  const auto by_walk = seen(s, v, through);
  const auto by_paint = painted(s, camera, project(camera, through));
  // The walk may step over a corner that it cuts by less than a step.
  if (by_walk) RC_ASSERT(by_paint.has_value());
  if (by_walk && by_paint && *by_walk != *by_paint) {
    RC_ASSERT(seen(s, v, {through.x + 0.02, through.y, through.z}) == by_paint ||
              seen(s, v, {through.x, through.y + 0.02, through.z}) == by_paint ||
              seen(s, v, {through.x - 0.02, through.y, through.z}) == by_paint ||
              seen(s, v, {through.x, through.y - 0.02, through.z}) == by_paint);
  }
}

TEST_CASE("law: what is painted last is what the viewer sees") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice(), 2, 1);
    check_painting(s, usual_camera(s.lattice()), to_viewer(s.lattice()));
  }));
}

TEST_CASE("law: so it is from everywhere else") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice(), 2, 1);
    const double azimuth = *rc::gen::inRange(0, 6283) / 1000.0;
    const double elevation = *rc::gen::inRange(100, 1500) / 1000.0;
    const LatticeCamera camera = camera_at(s.lattice(), azimuth, elevation);
    check_painting(s, camera, camera.towards);
  }));
}

TEST_CASE("the usual cameras are those at 52 and 30 degrees") {
  constexpr double kDegree = 0.017453292519943295;
  for (const Lattice lattice : {Lattice::cubic, Lattice::hexagonal}) {
    const LatticeCamera usual = usual_camera(lattice);
    const LatticeCamera same =
        camera_at(lattice, (lattice == Lattice::cubic ? -52 : -30) * kDegree, 30 * kDegree);
    const Point p{0.3, -1.7, 2.1};
    CHECK(project(usual, p).x == doctest::Approx(project(same, p).x));
    CHECK(project(usual, p).y == doctest::Approx(project(same, p).y));
    CHECK(shown_faces(structure_literal("1", lattice), same).size() == 3);
  }
}

TEST_CASE("a ghost shows faces towards nothing alone, and hides none") {
  const Structure whole = structure_literal("1 2 2");
  const Structure now = structure_literal("1");
  std::size_t ghosts = 0, real = 0;
  for (const ShownFace& face : shown_faces(now, usual_camera(Lattice::cubic), &whole)) {
    ++(face.ghost ? ghosts : real);
  }
  CHECK(real == 3);    // the side towards the ghosts is seen through them
  CHECK(ghosts == 5);  // of two bricks in a row
}

TEST_CASE("faces between bricks are not shown") {
  CHECK(shown_faces(structure_literal("1")).size() == 3);
  CHECK(shown_faces(structure_literal("1 1")).size() == 5);
  CHECK(shown_faces(structure_literal("1", Lattice::hexagonal)).size() == 3);
  CHECK(shown_faces(Structure()).empty());
}

TEST_CASE("turning brings the named corner to the viewer") {
  const std::array<std::pair<const char*, Cell>, 4> corners = {
      {{"+x-y", {1, -1, 0}}, {"+x+y", {1, 1, 0}}, {"-x+y", {-1, 1, 0}}, {"-x-y", {-1, -1, 0}}}};
  for (const auto& [name, cell] : corners) {
    Structure s;
    s.place(cell, 1);
    CHECK(turned(s, *turns_for_view(name, Lattice::cubic)).at({1, -1, 0}) == 1);
  }
  CHECK_FALSE(turns_for_view("+x", Lattice::cubic).has_value());
  CHECK(turns_for_view("+x+y", Lattice::hexagonal) == 5);
}

TEST_CASE("turns are counted modulo a whole turn") {
  const Structure s = structure_literal("1 2 .\n. . 3");
  CHECK(turned(s, 4) == s);
  CHECK(turned(s, -1) == turned(s, 3));
}

}  // namespace
}  // namespace stig
