// SPDX-License-Identifier: MIT
// One run of a set-up: a simulation with an observer, to the end of the work or of its time.
//
// It ends when every structure is over: 10 s after the whole of it stands, so that what falls over
// has time to, or when a brick too much, or one of a wrong colour, has been part of it for five
// minutes, in which no robot has put it right. It ends too when no robot can go on (its program
// failed, it left the arena or lies on its side), or none has moved for ten minutes; or when time
// is out.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physical/simulation/simulation.h"
#include "validate/block_count.h"
#include "validate/judge.h"
#include "validate/uses.h"

namespace stig::validate {

enum class TrialEnd : std::uint8_t {
  built,
  time,
  spoilt,
  stuck,
  script,
  diverged,
  interrupted,
  script_failed,  ///< the scene's script, of which robots know nothing
};
std::string_view to_string(TrialEnd end);
/// Whether the run was cut short by something that is none of the robots' doing: it proves nothing,
/// whatever stood at that moment.
bool broke_off(TrialEnd end);

/// Where a robot's energy went, J: work of its motors, forward and braking alike. Electromagnets
/// have no resistance in the model; for how long current flowed, in s.
struct EnergyUse {
  double wheels = 0, lift = 0, current_time = 0;
};

/// From one time to another, s.
struct TimeSpan {
  double from = 0, to = 0;
  friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

/// A robot is *idle* while wheels and lift stand still and no current flows in its electromagnets,
/// once that has lasted for so long, s: then from its beginning. That is seen from outside,
/// whatever the program calls what it does; looks at blocks and pulses of the magnets are shorter.
inline constexpr double kIdleAfter = 4;

struct RobotRecord {
  std::string name;
  Pose X_WR;                              ///< at the end
  double driven = 0;                      ///< m
  std::map<std::string, double> spent;    ///< s in each state that it showed
  std::string state;                      ///< the last
  double since = 0;                       ///< s
  std::map<std::string, double> shown;    ///< numbers, the newest of each name
  double ideal = 0;                       ///< s, of its bricks: ideal_time.h
  double still = 0;                       ///< s with neither wheels nor lift in motion
  std::vector<TimeSpan> idle;             ///< when it did nothing, for more than kIdleAfter
  std::map<std::string, double> idle_in;  ///< s of that, by the state that it showed
  std::vector<double> busy;               ///< s: when it aborted since another robot was in the way
  EnergyUse energy;
  /// Halted: by the scene's script. It has failed then, too.
  bool failed = false, halted = false, left = false, fallen = false, holding = false;

  double idle_time() const;  ///< s
};

/// A moment of a run, drawn.
struct TrialPicture {
  double time = 0;
  std::string png;
};

struct TrialLine {
  double time = 0;
  std::string who, text;
  bool failure = false;
};

struct Trial {
  std::uint64_t seed = 1, hash = 0;
  TrialEnd end = TrialEnd::time;
  std::string message;                ///< of a run that its script ended, or that diverged
  double time = 0;                    ///< s, simulated
  std::vector<Judgement> judgements;  ///< of each structure
  std::vector<BrickEvent> events;     ///< of all
  std::vector<Haul> hauls;
  std::vector<RobotRecord> robots;
  std::vector<WatchedBlock> loose;  ///< blocks that are no bricks, not fixed, and that nobody holds
  BlockCount blocks;                ///< where each is at the end
  std::vector<std::string> broken;  ///< devices and parts that the scene's script broke: sentences
  std::vector<std::string> caches;  ///< what keeps them from dropping blocks: sentences
  /// Why robots cannot complete a structure any more, likewise. No run says so, and no journal
  /// keeps it: out_of_reach.h does, before a report.
  std::vector<std::string> cannot;
  std::vector<TrialLine> lines;  ///< the last of what programs said
  std::vector<TrialPicture> pictures;
  std::map<std::string, double> measures;  ///< of the scene's script

  BuildVerdict verdict() const;  ///< the gravest of all structures'
};

/// Of all structures of a run.
struct TrialTotals {
  std::size_t wanted = 0, there = 0;        ///< bricks
  std::size_t placements = 0, allowed = 0;  ///< as each judgement has them
  double worst_way = 0, worst_turn = 0;     ///< m, rad
};
TrialTotals totals_of(const Trial& trial);

/// When the last brick of a structure was placed, s; none where there is none.
std::optional<double> last_placement(const Trial& trial, std::size_t structure);

struct TrialHooks {
  const std::atomic<bool>* stop = nullptr;
  /// Five times a second of simulated time; bricks that stand, those of the start too.
  std::function<void(double time, std::size_t bricks)> progress;
};

struct TrialSettings {
  double duration = 2400;  ///< s
  int pictures = 0;        ///< on the way, besides that of the end; -1: not that either
  PoseTraceWriter* trace = nullptr;
};

/// Scene and target must outlive the call.
Trial run_trial(const BuildTarget& target, const Scene& scene, const PlacedScene& placed,
                const TrialSettings& settings, const TrialHooks& hooks);

}  // namespace stig::validate
