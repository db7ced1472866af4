// SPDX-License-Identifier: MIT
// Each kind of broken mesh is mended to what was meant, and counted.
#include <doctest/doctest.h>

#include <cmath>

#include "meshes/shapes.h"

namespace stig::meshes {
namespace {

struct Mended {
  bool good = false;
  Model model;
  Repairs repairs;
  std::string problem;
};
Mended mend(Soup soup) {
  Mended out;
  out.good = repair(std::move(soup), out.model, out.repairs, out.problem);
  return out;
}

TEST_CASE("a sound box is left as it is") {
  const Mended box_ = mend(box({0, 0, 0}, {4, 3, 2}));
  REQUIRE(box_.good);
  CHECK(box_.model.triangles.size() == 12);
  CHECK(box_.repairs.volume == doctest::Approx(24));
  CHECK(box_.repairs.solids == 1);
  CHECK(box_.repairs.holes + box_.repairs.duplicate_points + box_.repairs.degenerate_faces +
            box_.repairs.turned_surfaces + box_.repairs.crossing_faces ==
        0);
}

TEST_CASE("holes are closed") {
  Soup soup = ball(12, 1);
  const double whole = mend(soup).repairs.volume;
  soup.faces.erase(soup.faces.begin() + 5);
  soup.faces.erase(soup.faces.begin() + 100, soup.faces.begin() + 103);
  const Mended mended = mend(soup);
  REQUIRE(mended.good);
  CHECK(mended.repairs.holes >= 2);
  CHECK(mended.repairs.volume == doctest::Approx(whole).epsilon(0.02));
}

TEST_CASE("faces turned the wrong way are turned alike, and a whole inside out too") {
  Soup some = box({0, 0, 0}, {1, 1, 1}), all = some;
  turn_face(some, 2);
  turn_face(some, 5);
  for (std::size_t i = 0; i < 6; ++i) turn_face(all, i);
  CHECK(mend(some).repairs.volume == doctest::Approx(1));
  CHECK(mend(all).repairs.volume == doctest::Approx(1));
  CHECK(mend(all).repairs.turned_surfaces == 1);
}

TEST_CASE("corners given anew for each face, as .stl has them, are merged") {
  const Soup sound = box({0, 0, 0}, {1, 1, 1});
  Soup loose;
  for (const auto& face : sound.faces) {
    std::vector<std::size_t> corners;
    for (const std::size_t corner : face) {
      corners.push_back(loose.points.size());
      loose.points.push_back(sound.points[corner]);
    }
    loose.faces.push_back(corners);
  }
  const Mended mended = mend(loose);
  REQUIRE(mended.good);
  CHECK(mended.repairs.duplicate_points == 16);
  CHECK(mended.repairs.volume == doctest::Approx(1));
}

TEST_CASE("faces without area, or twice there, do no harm") {
  Soup soup = box({0, 0, 0}, {1, 1, 1});
  soup.faces.push_back({0, 0, 1});
  soup.faces.push_back(soup.faces[3]);
  const Mended mended = mend(soup);
  REQUIRE(mended.good);
  CHECK(mended.repairs.degenerate_faces >= 2);
  CHECK(mended.repairs.volume == doctest::Approx(1));
}

TEST_CASE("a surface within another bounds a hollow, one within that a solid again") {
  const Mended mended = mend(
      together({box({0, 0, 0}, {6, 6, 6}), box({1, 1, 1}, {5, 5, 5}), box({2, 2, 2}, {4, 4, 4})}));
  REQUIRE(mended.good);
  CHECK(mended.repairs.solids == 2);
  CHECK(mended.repairs.hollows == 1);
  CHECK(mended.repairs.volume == doctest::Approx(216 - 64 + 8));
}

TEST_CASE("parts that overlap are both solid, and it is said that they cross") {
  const Mended mended = mend(together({box({0, 0, 0}, {4, 4, 2}), box({2, 2, 0}, {6, 6, 2})}));
  REQUIRE(mended.good);
  CHECK(mended.repairs.solids == 2);
  CHECK(mended.repairs.hollows == 0);
  CHECK(mended.repairs.crossing_faces > 0);
}

TEST_CASE("boxes that share an edge, where four faces meet, are told apart") {
  const Mended mended = mend(together({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}));
  REQUIRE(mended.good);
  CHECK(mended.repairs.volume == doctest::Approx(2));
}

TEST_CASE("faces that are bent, or cross themselves, are cut into triangles") {
  // A box with one corner pulled out of three of its faces.
  Soup bent = box({0, 0, 0}, {2, 2, 2});
  for (Point& p : bent.points) {
    if (p == Point{2, 2, 2}) p = {3, 2.5, 2.25};
  }
  const Mended mended = mend(bent);
  REQUIRE(mended.good);
  CHECK(mended.repairs.volume > 8);
  // A closed solid whose only large face runs through itself.
  const std::size_t corners = 9;
  Soup star{{}, {{}}};
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * static_cast<double>(4 * i % corners) / corners;
    star.points.push_back({std::cos(angle), std::sin(angle), 0.1 * static_cast<double>(i % 2)});
    star.faces[0].push_back(i);
  }
  star.points.push_back({0, 0, 1});
  for (std::size_t i = 0; i < corners; ++i) star.faces.push_back({(i + 1) % corners, i, corners});
  const Mended through = mend(star);
  CHECK(through.good == through.problem.empty());
}

TEST_CASE("what bounds nothing is refused") {
  Soup flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  CHECK(mend(flat).problem == "bounds no volume");
  CHECK(mend({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}}}).problem == "has no faces that make a surface");
}

}  // namespace
}  // namespace stig::meshes
