// SPDX-License-Identifier: MIT
#include "physical/dynamics/stock_step.h"

#include <algorithm>

#include "physical/dynamics/world_config.h"

namespace stig::physics {

std::string problem_of_stock(const WorldConfig& config) {
  if (!config.joints.empty()) return "solver 'stock' knows no joints";
  const bool known = std::all_of(config.bodies.begin(), config.bodies.end(), [](const auto& def) {
    return def.shape.kind == ShapeKind::box || def.shape.kind == ShapeKind::sphere;
  });
  return known ? "" : "solver 'stock' knows boxes and spheres alone";
}

}  // namespace stig::physics
