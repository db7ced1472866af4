// SPDX-License-Identifier: MIT
// Sums over the tetrahedra between a place and the triangles. The place is a corner of the box
// about the model, so that numbers are small; sums are moved to the centre by the parallel-axis
// theorem.
#include <algorithm>

#include "convex.h"

namespace stig::meshes {

MassSums mass_of(const Model& model) {
  MassSums out;
  Point from = model.points.front();
  for (const Point& p : model.points) {
    for (std::size_t k = 0; k < 3; ++k) from[k] = std::min(from[k], p[k]);
  }
  Point first{}, second{}, mixed{};
  for (const auto& t : model.triangles) {
    std::array<Point, 3> v{};
    Point sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        v[i][k] = model.points[t[i]][k] - from[k];
        sum[k] += v[i][k];
      }
    }
    const double volume = (v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                           v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                           v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0])) /
                          6;
    out.volume += volume;
    // The integral of xy over a tetrahedron with a corner at 0 is its volume over 20 times the sum
    // over the corners, and the product of the sums besides.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      double square = sum[k] * sum[k], product = sum[a] * sum[b];
      for (const Point& p : v) {
        square += p[k] * p[k];
        product += p[a] * p[b];
      }
      first[k] += volume / 4 * sum[k];
      second[k] += volume / 20 * square;
      mixed[k] += volume / 20 * product;
    }
  }
  if (!(out.volume > 0)) return out;
  for (std::size_t k = 0; k < 3; ++k) out.centre[k] = first[k] / out.volume;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = out.centre[(k + 1) % 3], b = out.centre[(k + 2) % 3];
    out.squares[k] = second[k] - out.volume * out.centre[k] * out.centre[k];
    out.products[k] = mixed[k] - out.volume * a * b;
  }
  for (std::size_t k = 0; k < 3; ++k) out.centre[k] += from[k];
  return out;
}

}  // namespace stig::meshes
