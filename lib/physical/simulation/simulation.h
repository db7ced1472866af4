// SPDX-License-Identifier: MIT
// A scene that runs: a world, the robots and blocks with programs in it, the parts that are at
// work besides (run_part.h), and the loop.
//
//     Simulation run(scene, placed);
//     run.record(writer);
//     const RunEnd end = run.until(10, hooks);
//
// Interrupted and taken up again from a checkpoint, a run ends with the same state and has
// written the same trace as if it had never stopped.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "physical/simulation/run_state.h"
#include "physical/simulation/uses.h"
#include "physical/trace/hand_action.h"

namespace stig::physics {

class Simulation {
 public:
  /// The scene must outlive the run. One that is not resumable keeps no account of what its
  /// programs read, which saves memory.
  Simulation(const Scene& scene, const PlacedScene& placed, bool resumable = true,
             const ControllerFactory& controllers = lua_controllers())
      : run_(scene, placed, resumable, controllers) {}

  /// From now on; the writer is given the state as it is, unless the run was resumed and the
  /// writer has the records up to here already. It must outlive the run.
  void record(PoseTraceWriter& writer) { run_.recorder.begin(run_, writer); }
  /// Steps until the world's time is `duration` s, or the scene's stop condition or the
  /// hooks end it.
  RunEnd until(double duration, const RunHooks& hooks);
  /// Does something by hand, now, and notes it in the trace. What is in the way, as a sentence;
  /// empty: it is done. Not once the run has ended by its script, its programs or divergence.
  std::string intervene(const HandAction& action);
  /// Ends the trace, if there is one.
  void finish(RunEnd end) { run_.recorder.finish(run_, end); }
  /// The script's last words: on_end. Once, before finish.
  void end_script(const RunHooks& hooks) { run_.script.end(run_, hooks); }

  const Scene& scene() const { return *run_.scene; }
  const PlacedScene& placed() const { return run_.placed; }
  const World& world() const { return run_.world; }
  /// Null in a scene without controllers and script.
  const Crew* crew() const { return run_.agents.crew(); }
  /// What a block's LEDs show now; most of them.
  Led led(std::size_t body) const { return led_of(run_, body); }
  /// Likewise of each face, in the order of its radios.
  std::array<int, 6> faces(std::size_t body) const { return faces_of(run_, body); }
  const RunTally& tally() const { return run_.tally.tally(); }
  /// Way that a robot has come since the start, m; seen every 0.2 s.
  double driven(std::size_t robot) const { return run_.odometer.driven(robot); }
  /// What the scene's script has measured, the newest value of each name.
  const std::map<std::string, double>& measures() const { return run_.script.measures(); }
  /// Has the script failed? message() says how.
  bool script_failed() const { return run_.script.failed(); }
  /// When it diverged, and at which body; or why its script ended it.
  const std::string& message() const { return run_.message; }

  /// A hash of the world's state, and of robots and blocks with programs.
  std::uint64_t hash() const { return hash_of(run_); }
  /// World, programs and tally; holds for this scene and seed alone. Asserts that the run is
  /// resumable.
  std::string state() const;
  /// False, and nothing changed, when the bytes are no state of this scene. What scripts and
  /// programs said is not said again.
  bool resume(std::string_view state);

 private:
  RunState run_;
};

}  // namespace stig::physics
