// SPDX-License-Identifier: MIT
#include "physical/dynamics/stock_step.h"

#include <algorithm>

#include "physical/dynamics/world_config.h"
#if !STIG_WITH_DART
#include "physical/dynamics/world_state.h"
#endif

namespace stig {

bool stock_available() { return STIG_WITH_DART; }

std::string problem_of_stock(const WorldConfig& config) {
  if (!stock_available()) return "solver 'stock' needs DART, which this program was built without";
  if (!config.joints.empty()) return "solver 'stock' knows no joints";
  const bool known = std::all_of(config.bodies.begin(), config.bodies.end(), [](const auto& def) {
    return def.shape.kind == ShapeKind::box || def.shape.kind == ShapeKind::sphere;
  });
  return known ? "" : "solver 'stock' knows boxes and spheres alone";
}

#if !STIG_WITH_DART
std::string dart_version() { return {}; }

// Never made: problem_of_stock says why.
struct StockStep::Dart {};
StockStep::StockStep(const WorldState&) {}
StockStep::~StockStep() = default;
void StockStep::solve(WorldState&) {}
void StockStep::move(WorldState&) const {}
#endif

}  // namespace stig
