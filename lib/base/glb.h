// SPDX-License-Identifier: MIT
// Binary glTF 2.0 (Khronos): named things with surfaces or lines, placed in a scene.
//
// glTF has y up and metres; what is handed over has that already, or stands under a node that
// is turned so.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"

namespace stig {

/// Triangles, or lines, of one material.
struct GlbPrimitive {
  std::string material;
  Rgb rgb;
  bool lines = false;
  std::string positions, normals, indices;  ///< bytes; lines have no normals
  std::uint32_t vertices = 0, corners = 0;
  std::array<float, 3> low{}, high{};

  /// Returns its number.
  std::uint32_t add_vertex(const std::array<float, 3>& at, const std::array<float, 3>& normal);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void add_line(std::uint32_t a, std::uint32_t b);
};

struct GlbNode {
  std::string name;
  std::vector<GlbPrimitive> primitives;
  Pose X_PN;        ///< in the parent's frame
  int parent = -1;  ///< an earlier node, or none
};

/// How a node moves, as values at moments in between which is interpolated. A list is as long as
/// `times`, or empty: then the node keeps what it has.
struct GlbMotion {
  std::size_t node = 0;
  bool stepped = false;      ///< each value lasts until the next one
  std::vector<float> times;  ///< s, rising
  std::vector<std::array<float, 3>> translations, scales;
  std::vector<std::array<float, 4>> rotations;  ///< unit quaternions x, y, z, w
};

/// With motions: one animation of that name.
std::string glb_file(const std::vector<GlbNode>& nodes, const std::vector<GlbMotion>& motions = {},
                     const std::string& name = "run");

}  // namespace stig
