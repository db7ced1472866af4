// SPDX-License-Identifier: MIT
// The same world on DART's own step (native collision detector, Dantzig's solver): slow and
// dense, but written by others, so that tests can hold World to it. Magnets are this
// project's in both. DART knows no pairs of materials: a pair slides with the smaller of
// its two coefficients, each taken against the same kind. Nobody sleeps, nothing leaves.
//
// Only there where the library was built with DART (CMake's STIG_PHYSICS). Worlds are made
// and destroyed under one lock, since DART is not safe to do so in several threads.
#pragma once

#include <memory>

#include "physical/world.h"

namespace stig {

class StockWorld {
 public:
  /// Asserts that problems_of(config) is empty.
  explicit StockWorld(const WorldConfig& config);
  ~StockWorld();

  StepResult step();
  BodyState state(BodyId id) const;
  /// Acts during the next step alone, at the centre of mass.
  void push(BodyId id, const Vec3& force, const Vec3& torque);

 private:
  struct Dart;
  std::unique_ptr<Dart> dart_;
};

}  // namespace stig
