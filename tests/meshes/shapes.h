// SPDX-License-Identifier: MIT
// Meshes of shapes that are known in closed form, and what can be wrong with one.
#pragma once

#include <functional>

#include "model.h"

namespace stig::meshes {

/// Six rectangles, turned outwards.
Soup box(const Point& low, const Point& high);
/// Rings of triangles between two poles.
Soup ball(std::size_t rings, double radius, const Point& middle = {0, 0, 0});
/// About the z axis.
Soup torus(std::size_t segments, double ring, double tube);
/// All of them in one file.
Soup together(std::initializer_list<Soup> parts);

void turn_face(Soup& soup, std::size_t face);

}  // namespace stig::meshes
