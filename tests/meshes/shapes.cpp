// SPDX-License-Identifier: MIT
#include "meshes/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stig::meshes {

Soup box(const Point& low, const Point& high) {
  Soup out;
  for (const double z : {low[2], high[2]}) {
    for (const double y : {low[1], high[1]}) {
      for (const double x : {low[0], high[0]}) out.points.push_back({x, y, z});
    }
  }
  out.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return out;
}

Soup ball(std::size_t rings, double radius, const Point& middle) {
  Soup out;
  const std::size_t around = 2 * rings;
  const auto add = [&](double polar, double azimuth) {
    out.points.push_back({middle[0] + radius * std::sin(polar) * std::cos(azimuth),
                          middle[1] + radius * std::sin(polar) * std::sin(azimuth),
                          middle[2] + radius * std::cos(polar)});
  };
  for (std::size_t i = 1; i < rings; ++i) {
    for (std::size_t j = 0; j < around; ++j) {
      add(std::numbers::pi * static_cast<double>(i) / static_cast<double>(rings),
          std::numbers::pi * static_cast<double>(j) / static_cast<double>(rings));
    }
  }
  const std::size_t north = out.points.size(), south = north + 1;
  out.points.push_back({middle[0], middle[1], middle[2] + radius});
  out.points.push_back({middle[0], middle[1], middle[2] - radius});
  const auto at = [&](std::size_t ring, std::size_t j) { return ring * around + j % around; };
  for (std::size_t j = 0; j < around; ++j) {
    out.faces.push_back({north, at(0, j), at(0, j + 1)});
    out.faces.push_back({south, at(rings - 2, j + 1), at(rings - 2, j)});
    for (std::size_t i = 0; i + 2 < rings; ++i) {
      out.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      out.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return out;
}

Soup torus(std::size_t segments, double ring, double tube) {
  Soup out;
  const auto angle = [&](std::size_t i) {
    return 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(segments);
  };
  for (std::size_t i = 0; i < segments; ++i) {
    for (std::size_t j = 0; j < segments; ++j) {
      const double far = ring + tube * std::cos(angle(j));
      out.points.push_back(
          {far * std::cos(angle(i)), far * std::sin(angle(i)), tube * std::sin(angle(j))});
    }
  }
  const auto at = [&](std::size_t i, std::size_t j) {
    return i % segments * segments + j % segments;
  };
  for (std::size_t i = 0; i < segments; ++i) {
    for (std::size_t j = 0; j < segments; ++j) {
      out.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return out;
}

Soup together(std::initializer_list<Soup> parts) {
  Soup out;
  for (const Soup& part : parts) {
    const std::size_t offset = out.points.size();
    out.points.insert(out.points.end(), part.points.begin(), part.points.end());
    for (std::vector<std::size_t> face : part.faces) {
      for (std::size_t& corner : face) corner += offset;
      out.faces.push_back(std::move(face));
    }
  }
  return out;
}

void turn_face(Soup& soup, std::size_t face) {
  std::reverse(soup.faces[face].begin(), soup.faces[face].end());
}

}  // namespace stig::meshes
