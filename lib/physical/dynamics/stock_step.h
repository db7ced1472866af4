// SPDX-License-Identifier: MIT
// DART's own step (native collision detector, Dantzig's solver) in place of this library's
// contact solver and integration, WorldConfig::solver = stock: slow and dense, but written by
// others, so that tests can hold the fast one to it. Magnets, forces, events and checkpoints
// are those of World.
//
// DART is told where everything is before each step and keeps nothing, so that a checkpoint
// of the world is whole; but it orders contacts by their addresses, so that runs agree only as
// far as its sums round alike. It knows no pairs of materials: a pair slides with the smaller of
// its two coefficients, each taken against the same kind. Nobody sleeps; wheels grip alike in all
// directions. Joints, cylinders and hulls are refused.
//
// DART's objects are made and destroyed under one lock, since it is not safe to do so in several
// threads.
#pragma once

#include <memory>
#include <string>

#include "physical/dynamics/uses.h"

namespace stig::physics {

struct WorldConfig;
struct WorldState;

/// DART's own.
std::string dart_version();
/// Why DART's step cannot be had for this configuration; empty: it can.
std::string problem_of_stock(const WorldConfig& config);

class StockStep {
 public:
  /// DART's world with the bodies that have not left.
  explicit StockStep(const WorldState& world);
  ~StockStep();

  /// Velocities after a step under the bodies' forces, which are finite.
  void solve(WorldState& world);
  /// The poses that belong to them.
  void move(WorldState& world) const;

 private:
  struct Dart;
  std::unique_ptr<Dart> dart_;
};

}  // namespace stig::physics
