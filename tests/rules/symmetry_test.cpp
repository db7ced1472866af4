// SPDX-License-Identifier: MIT
// The laws of the orientation groups, and that orientations turn what they say.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "rules/symmetry.h"
#include "support/uses.h"

namespace stig {
namespace {

struct Case {
  Lattice lattice;
  Symmetry symmetry;
  bool inversion;
  std::size_t size;
};

std::vector<Case> all_groups() {
  std::vector<Case> cases;
  for (const bool inversion : {false, true}) {
    const std::size_t doubled = inversion ? 2 : 1;
    cases.push_back({Lattice::cubic, Symmetry::none, inversion, doubled});
    cases.push_back({Lattice::cubic, Symmetry::rotations, inversion, 4 * doubled});
    cases.push_back({Lattice::cubic, Symmetry::rotations_mirrors, inversion, 8 * doubled});
    cases.push_back({Lattice::hexagonal, Symmetry::none, inversion, doubled});
    cases.push_back({Lattice::hexagonal, Symmetry::rotations, inversion, 6 * doubled});
    cases.push_back({Lattice::hexagonal, Symmetry::rotations_mirrors, inversion, 12 * doubled});
  }
  return cases;
}

using Map = std::tuple<int, int, int, int, int>;
Map map_of(const Orientation& g) { return {g.xx, g.xy, g.yx, g.yy, g.zz}; }
Map product(const Orientation& a, const Orientation& b) {
  return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx,
          a.yx * b.xy + a.yy * b.yy, a.zz * b.zz};
}

TEST_CASE("orientations: sizes, identity first, no element twice") {
  for (const Case& c : all_groups()) {
    const auto group = orientations(c.lattice, c.symmetry, c.inversion);
    CHECK(group.size() == c.size);
    CHECK(map_of(group.front()) == Map{1, 0, 0, 1, 1});
    std::set<Map> maps;
    std::set<std::string> names;
    for (const Orientation& g : group) {
      maps.insert(map_of(g));
      names.insert(g.name);
    }
    CHECK(maps.size() == c.size);
    CHECK(names.size() == c.size);
  }
}

TEST_CASE("orientations: closed under product, every element has its inverse") {
  for (const Case& c : all_groups()) {
    const auto group = orientations(c.lattice, c.symmetry, c.inversion);
    std::set<Map> maps;
    for (const Orientation& g : group) maps.insert(map_of(g));
    for (const Orientation& a : group) {
      bool has_inverse = false;
      for (const Orientation& b : group) {
        CHECK(maps.count(product(a, b)) == 1);
        has_inverse = has_inverse || product(a, b) == Map{1, 0, 0, 1, 1};
      }
      CHECK(has_inverse);
    }
  }
}

TEST_CASE("orientations: neighbour images are permutations that act as the group does") {
  for (const Case& c : all_groups()) {
    const Neighbourhood& n = neighbourhood(c.lattice);
    const auto size = static_cast<std::size_t>(n.size);
    const auto group = orientations(c.lattice, c.symmetry, c.inversion);
    for (const Orientation& a : group) {
      std::set<int> images;
      for (std::size_t i = 0; i < size; ++i) {
        images.insert(a.image[i]);
        CHECK(n.offsets[static_cast<std::size_t>(a.image[i])] == a.apply(n.offsets[i]));
      }
      CHECK(images.size() == size);
      for (const Orientation& b : group) {
        const auto ab = std::find_if(group.begin(), group.end(), [&](const Orientation& g) {
          return map_of(g) == product(a, b);
        });
        REQUIRE(ab != group.end());
        for (std::size_t i = 0; i < size; ++i) {
          CHECK(ab->image[i] == a.image[static_cast<std::size_t>(b.image[i])]);
        }
      }
    }
  }
}

TEST_CASE("orientations: keep faces and edges, and lengths in the drawn embedding") {
  for (const Case& c : all_groups()) {
    const Neighbourhood& n = neighbourhood(c.lattice);
    const auto length = [&](Offset o) {
      const Point p = embed(c.lattice, Cell{} + o);
      const Point q = embed(c.lattice, Cell{});
      return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    };
    for (const Orientation& g : orientations(c.lattice, c.symmetry, c.inversion)) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
        const auto image = static_cast<std::size_t>(g.image[i]);
        CHECK(n.is_face[i] == n.is_face[image]);
        CHECK(n.is_edge[i] == n.is_edge[image]);
        CHECK(length(n.offsets[i]) == doctest::Approx(length(n.offsets[image])));
      }
    }
  }
}

TEST_CASE("orientations: the generators turn against the clock, seen from above") {
  const auto cubic = orientations(Lattice::cubic, Symmetry::rotations, false);
  CHECK(cubic[1].apply({1, 0, 0}) == Offset{0, 1, 0});
  CHECK(cubic[1].apply({0, 1, 1}) == Offset{-1, 0, 1});
  const auto hexagonal = orientations(Lattice::hexagonal, Symmetry::rotations, false);
  CHECK(hexagonal[1].apply({1, 0, 0}) == Offset{0, 1, 0});
  CHECK(hexagonal[1].apply({0, 1, -1}) == Offset{-1, 1, -1});
  const auto flipped = orientations(Lattice::cubic, Symmetry::none, true);
  CHECK(flipped[1].apply({1, 2, 3}) == Offset{1, 2, -3});
}

}  // namespace
}  // namespace stig
