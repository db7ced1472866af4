// SPDX-License-Identifier: MIT
// What robots do while a trial runs: their states, the work of their motors, where their hands
// are.
#pragma once

#include <vector>

#include "validate/trial.h"
#include "validate/uses.h"

namespace stig::validate {

class RobotWatch {
 public:
  /// The run must outlive it and have a crew.
  explicit RobotWatch(const Simulation& run);

  /// After each step.
  void after_step();
  /// Where they hold blocks now.
  std::vector<WatchedHand> hands() const;
  /// Can none go on?
  bool all_out() const;
  /// When a robot moved last by more than a hair, s.
  double last_motion() const { return last_motion_; }
  std::vector<RobotRecord> finish(const Watch& watch);

 private:
  struct Follow {
    RobotRecord record;
    std::uint64_t tick = UINT64_MAX;  ///< of its controller, seen last
    Vec3 place;                       ///< where it stood when it last moved
    WatchedHand began;                ///< where its hand was at first
    /// Since it did something last: s in each state that it showed.
    std::vector<std::pair<std::string, double>> rest;
  };
  void note_shown(std::size_t robot);
  void note_motors(std::size_t robot);
  void note_rest(Follow& follow, bool rests) const;
  void end_rest(Follow& follow) const;
  const RobotModel& model(std::size_t robot) const;
  bool out(std::size_t robot) const;

  const Simulation& run_;
  double step_ = 0;
  std::vector<Follow> robots_;
  double last_motion_ = 0;
};

}  // namespace stig::validate
