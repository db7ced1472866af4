// SPDX-License-Identifier: MIT
// Cells held to shapes in closed form, and to what a grid of cells must be.
#include "voxelise.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "inside.h"
#include "meshes/shapes.h"

namespace stig::meshes {
namespace {

Model model_of(Soup soup) {
  Model model;
  Repairs repairs;
  std::string problem;
  const bool good = repair(std::move(soup), model, repairs, problem);
  REQUIRE_MESSAGE(good, problem);
  return model;
}
Cells cells_of(const Model& model, const Grid& grid) {
  Cells cells;
  std::string problem;
  const bool good = voxelise(model, grid, cells, problem);
  REQUIRE_MESSAGE(good, problem);
  return cells;
}
Cells cells_of(Soup soup, double side, Fill fill = Fill::solid) {
  return cells_of(model_of(std::move(soup)), {2, false, side, fill});
}

/// Places about a shape are inside as `depth` says, which is below 0 within; those closer to the
/// surface than the mesh is to the shape are left out.
void holds(const Soup& soup, double reach, double error,
           const std::function<double(const Point&)>& depth) {
  const Model model = model_of(soup);
  const Inside inside(model);
  int checked = 0;
  for (double x = -reach; x <= reach; x += reach / 9.3) {
    for (double y = -reach; y <= reach; y += reach / 8.7) {
      for (double z = -reach; z <= reach; z += reach / 9.9) {
        const double away = depth({x, y, z});
        if (std::abs(away) < error) continue;
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(z);
        CHECK((inside.winding({x, y, z}) > 0) == (away < 0));
        ++checked;
      }
    }
  }
  CHECK(checked > 3000);
}

TEST_CASE("places are in a ball, a torus and a box exactly where they are") {
  holds(ball(40, 1), 1.3, 0.02, [](const Point& p) { return std::hypot(p[0], p[1], p[2]) - 1; });
  holds(torus(60, 1, 0.4), 1.6, 0.02,
        [](const Point& p) { return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.4; });
  holds(box({-1, -0.5, -0.25}, {1, 0.5, 0.25}), 1.2, 1e-9, [](const Point& p) {
    return std::max({std::abs(p[0]) - 1, std::abs(p[1]) - 0.5, std::abs(p[2]) - 0.25});
  });
}

TEST_CASE("a place right on a face, an edge or a corner is in the solid") {
  const Model model = model_of(box({0, 0, 0}, {2, 2, 2}));
  const Inside inside(model);
  for (const Point& p : {Point{1, 1, 0}, Point{0, 0, 1}, Point{2, 2, 2}, Point{0.5, 2, 1.5}}) {
    CHECK(inside.winding(p) > 0);
  }
  CHECK(inside.winding({1, 1, std::nextafter(2.0, 3.0)}) == 0);
  CHECK(inside.winding({1, 1, std::nextafter(2.0, 1.0)}) == 1);
}

TEST_CASE("a box of whole cells gives just those") {
  const Cells cells = cells_of(box({10, -3, 7}, {14, 0, 9}), 1);
  CHECK(cells.cells.size() == 24);
  CHECK(cells.on_floor == 12);
  CHECK(cells.overhanging == 0);
  CHECK(cells.cells.front() == CellPlace{0, 0, 0});
  CHECK(cells.cells.back() == CellPlace{3, 2, 1});
}

TEST_CASE("up may be any axis, and nothing is mirrored") {
  // A flight of three steps with a mark on one side: no two of its turns are mirror images.
  const Model model = model_of(
      together({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 2}), box({0, 1, 0}, {1, 2, 1})}));
  const auto turned = [](const Cells& cells, int quarter) {
    std::set<CellPlace> out;
    for (CellPlace c : cells.cells) {
      for (int i = 0; i < quarter; ++i) c = {-c[1], c[0], c[2]};
      out.insert(c);
    }
    CellPlace low{99, 99, 99};
    for (const CellPlace& c : out) {
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], c[k]);
    }
    std::set<CellPlace> moved;
    for (const CellPlace& c : out) moved.insert({c[0] - low[0], c[1] - low[1], c[2] - low[2]});
    return moved;
  };
  for (const bool down : {false, true}) {
    for (int up = 0; up < 3; ++up) {
      // The model turned so that this axis points up, written out once more in that frame.
      Model stood = model;
      for (Point& p : stood.points) {
        const auto a = static_cast<std::size_t>((up + 1) % 3),
                   b = static_cast<std::size_t>((up + 2) % 3);
        const Point q = p;
        p = down ? Point{q[b], q[a], -q[static_cast<std::size_t>(up)]}
                 : Point{q[a], q[b], q[static_cast<std::size_t>(up)]};
      }
      const auto as_given = turned(cells_of(model, {up, down, 1, Fill::solid}), 0);
      const auto as_turned = cells_of(stood, {2, false, 1, Fill::solid});
      bool same = false;
      for (int quarter = 0; quarter < 4; ++quarter) {
        same = same || turned(as_turned, quarter) == as_given;
      }
      CAPTURE(up);
      CAPTURE(down);
      CHECK(same);
    }
  }
}

TEST_CASE("a hollow stays empty, and what overhangs is counted") {
  const Cells cells = cells_of(together({box({0, 0, 0}, {6, 6, 6}), box({1, 1, 1}, {5, 5, 5})}), 1);
  CHECK(cells.cells.size() == 216 - 64);
  CHECK(cells.overhanging == 16);
}

TEST_CASE("parts that overlap are one, parts apart are left out, parts at a corner are joined") {
  CHECK(
      cells_of(together({box({0, 0, 0}, {4, 4, 2}), box({2, 2, 0}, {6, 6, 2})}), 1).cells.size() ==
      56);
  const Cells apart =
      cells_of(together({box({0, 0, 0}, {4, 4, 2}), box({10, 2, 0}, {12, 6, 2})}), 1);
  CHECK(apart.cells.size() == 32);
  CHECK(apart.parts_left_out == 1);
  CHECK(apart.cells_left_out == 16);
  const Cells corner =
      cells_of(together({box({0, 0, 0}, {2, 2, 2}), box({2, 2, 2}, {4, 4, 4})}), 1);
  CHECK(corner.joined == 2);
  CHECK(corner.cells.size() == 18);
}

TEST_CASE("a shell is every cell that a surface passes through") {
  const Cells shell = cells_of(ball(30, 5), 1, Fill::shell), solid = cells_of(ball(30, 5), 1);
  const std::set<CellPlace> of_shell(shell.cells.begin(), shell.cells.end());
  CHECK(of_shell.count({5, 5, 5}) == 0);
  CHECK(shell.cells.size() > 100);
  CHECK(shell.cells.size() < solid.cells.size());
}

TEST_CASE("about so many bricks are about so many") {
  const Model model = model_of(ball(30, 7));
  for (const std::size_t wanted : {20U, 100U, 1000U, 5000U}) {
    Cells cells;
    std::string problem;
    const bool good = voxelise_to(model, {}, wanted, 1436, cells, problem);
    REQUIRE_MESSAGE(good, problem);
    CHECK(static_cast<double>(cells.cells.size()) ==
          doctest::Approx(static_cast<double>(wanted)).epsilon(0.15));
  }
}

TEST_CASE("sides without end or without sense are refused") {
  const Model model = model_of(box({0, 0, 0}, {1, 1, 1}));
  Cells cells;
  for (const double side : {1e-9, 1e-3}) {
    std::string problem;
    CHECK_FALSE(voxelise(model, {2, false, side, Fill::solid}, cells, problem));
    CHECK(problem.find("more than 2e7 cells") != problem.npos);
  }
  std::string problem;
  const Model thin = model_of(box({0, 0, 0}, {10, 10, 0.2}));
  CHECK(voxelise(thin, {2, false, 1, Fill::shell}, cells, problem));
}

}  // namespace
}  // namespace stig::meshes
