// SPDX-License-Identifier: MIT
// Mass properties against closed forms, and convex pieces against shapes of which it is known how
// many they take.
#include "convex.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "meshes/shapes.h"

namespace stig::meshes {
namespace {

Model mended_model(Soup soup) {
  Model model;
  Repairs repairs;
  std::string problem;
  REQUIRE_MESSAGE(repair(std::move(soup), model, repairs, problem), problem);
  return model;
}

Pieces pieces_of(const Model& model, std::size_t most = 16) {
  Pieces out;
  std::string problem;
  REQUIRE_MESSAGE(decompose(model, most, out, problem), problem);
  return out;
}

void check_near(const Point& a, const Point& b, double epsilon) {
  for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(a[k] - b[k]) <= epsilon);
}

const double kPi = std::acos(-1.0);

}  // namespace

TEST_CASE("the mass of a box") {
  // 4 x 3 x 2 from (5, 6, 7), by m a²/12.
  const MassSums mass = mass_of(mended_model(box({5, 6, 7}, {9, 9, 9})));
  CHECK(mass.volume == doctest::Approx(24).epsilon(1e-13));
  check_near(mass.centre, {7, 7.5, 8}, 1e-12);
  check_near(mass.squares, {24 * 16 / 12.0, 24 * 9 / 12.0, 24 * 4 / 12.0}, 1e-11);
  check_near(mass.products, {0, 0, 0}, 1e-11);
}

TEST_CASE("the mass of a tetrahedron") {
  // Corners at 0 and a along each axis: a³/6, the middle at a/4; about it the mean of x² is 3
  // a²/80, and that of yz -a²/80.
  const double a = 2;
  const MassSums mass = mass_of(mended_model({{{0, 0, 0}, {a, 0, 0}, {0, a, 0}, {0, 0, a}},
                                              {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}));
  const double v = a * a * a / 6, s = v * 3 * a * a / 80, o = -v * a * a / 80;
  CHECK(mass.volume == doctest::Approx(v).epsilon(1e-13));
  check_near(mass.centre, {a / 4, a / 4, a / 4}, 1e-12);
  check_near(mass.squares, {s, s, s}, 1e-12);
  check_near(mass.products, {o, o, o}, 1e-12);
}

TEST_CASE("the mass of a torus, and of a ball with a hollow") {
  // Of a fine mesh, whose facets lie within by the square of their width.
  const double r = 3, t = 1, volume = 2 * kPi * kPi * r * t * t;
  const MassSums ring = mass_of(mended_model(torus(200, r, t)));
  CHECK(ring.volume == doctest::Approx(volume).epsilon(0.01));
  const double across = r * r / 2 + 3 * t * t / 8;  // half of the moment about z, for each square
  CHECK(ring.squares[0] / ring.volume == doctest::Approx(across).epsilon(0.005));
  CHECK(ring.squares[1] / ring.volume == doctest::Approx(across).epsilon(0.005));
  CHECK(ring.squares[2] / ring.volume == doctest::Approx(t * t / 4).epsilon(0.005));
  const MassSums hollow = mass_of(mended_model(together({ball(80, 2), ball(80, 1)})));
  CHECK(hollow.volume == doctest::Approx(4 * kPi / 3 * 7).epsilon(0.005));
  CHECK(hollow.squares[0] == doctest::Approx(4 * kPi / 15 * 31).epsilon(0.005));
}

TEST_CASE("a convex model is one piece, with its own corners") {
  const Pieces pieces = pieces_of(mended_model(box({5, 6, 7}, {9, 9, 9})));
  REQUIRE(pieces.corners.size() == 1);
  CHECK(pieces.corners[0].size() == 8);
  CHECK(pieces.volume == doctest::Approx(24));
  CHECK(pieces.off == 0);
}

TEST_CASE("boxes side by side are cut where they meet") {
  // An angle, a U and a cross: 2, 3 and 3 pieces, without anything too much. The boxes touch.
  const Soup foot = box({0, 0, 0}, {3, 1, 1});
  const Pieces corner = pieces_of(mended_model(together({foot, box({0, 0, 1}, {1, 1, 2})})));
  CHECK(corner.corners.size() == 2);
  CHECK(corner.volume == doctest::Approx(4));
  const Pieces u = pieces_of(
      mended_model(together({foot, box({0, 0, 1}, {1, 1, 4}), box({2, 0, 1}, {3, 1, 4})})));
  CHECK(u.corners.size() == 3);
  CHECK(u.volume == doctest::Approx(9));
  const Pieces cross = pieces_of(
      mended_model(together({foot, box({1, -1, 0}, {2, 0, 1}), box({1, 1, 0}, {2, 2, 1})})));
  CHECK(cross.corners.size() == 3);
  CHECK(cross.volume == doctest::Approx(5));
}

TEST_CASE("a ring is cut until its pieces have little too much, and its hull is one") {
  const Model ring = mended_model(torus(32, 3, 1));
  const double volume = mass_of(ring).volume;
  CHECK(pieces_of(ring, 1).corners.size() == 1);
  const Pieces few = pieces_of(ring, 4), more = pieces_of(ring, 24);
  CHECK(few.corners.size() == 4);
  CHECK(few.volume < 1.6 * volume);
  CHECK(more.volume < 1.25 * volume);
  CHECK(more.volume > 0.9 * volume);
  for (const auto& corners : more.corners) CHECK(corners.size() <= kMostCorners);
  // The hole stays open.
  for (const auto& corners : more.corners) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& p : corners) nearest = std::min(nearest, std::hypot(p[0], p[1]));
    CHECK(nearest > 1.5);
  }
}

TEST_CASE("a ball has few corners, and it is said by how much that falls short") {
  const Pieces pieces = pieces_of(mended_model(ball(24, 10)));
  REQUIRE(pieces.corners.size() == 1);
  CHECK(pieces.corners[0].size() == kMostCorners);
  CHECK(pieces.off > 0);
  CHECK(pieces.off < 1.5);
}

TEST_CASE("what is looked at has few triangles and about the same volume") {
  const Model fine = mended_model(torus(100, 3, 1));
  const Model coarse = simplified(fine, 500);
  CHECK(coarse.triangles.size() <= 500);
  CHECK(mass_of(coarse).volume == doctest::Approx(mass_of(fine).volume).epsilon(0.05));
  CHECK(simplified(fine, 1'000'000).triangles.size() == fine.triangles.size());
}

}  // namespace stig::meshes
