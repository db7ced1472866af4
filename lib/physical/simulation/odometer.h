// SPDX-License-Identifier: MIT
// The ways that robots have come since the start, seen every 0.2 s.
#pragma once

#include <vector>

#include "physical/simulation/run_part.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct Scene;

class Odometer final : public SavedPart<Odometer> {
 public:
  explicit Odometer(const Scene& scene);

  double driven(std::size_t robot) const { return robots_[robot].driven; }
  /// A hand has put the robot there: that is no way that it has come.
  void put_down(std::size_t robot, const Vec3& at) { robots_[robot].last = {at.x, at.y, 0}; }

  void before_step(RunState& run, const RunHooks& hooks) override;
  static void members(auto& each, auto& odometer) {
    for (auto& robot : odometer.robots_) {
      each(robot.driven), each(robot.last.x), each(robot.last.y);
    }
  }
  bool accept(const RunState& /*run*/) const { return true; }

 private:
  struct Way {
    double driven = 0;  ///< m
    Vec3 last;          ///< where it was seen last, on the floor
  };

  std::vector<Way> robots_;
};

}  // namespace stig::physics
