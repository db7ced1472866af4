// SPDX-License-Identifier: MIT
// A scene that runs: a world, what has happened in it so far, and the trace that records it.
//
//     Simulation run(scene, placed);
//     run.record(writer);
//     const RunEnd end = run.until(10, hooks);
//
// Interrupted and taken up again from a checkpoint, a run ends with the same state and has
// written the same trace as if it had never stopped.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lua/lua_script.h"
#include "physical/dynamics/world.h"
#include "physical/robots/crew.h"
#include "physical/robots/reading_history.h"
#include "physical/scene/scene.h"
#include "physical/trace/pose_trace.h"

namespace stig {

/// Events of a run, counted.
struct RunTally {
  std::uint64_t contacts = 0, slept = 0, woke = 0, snapped = 0, let_go = 0;
  std::vector<std::uint32_t> left;  ///< bodies, in order

  friend bool operator==(const RunTally&, const RunTally&) = default;
};

struct RunHooks {
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const CrewLine&)> on_line;  ///< what robots and blocks say
  std::function<void(const World&)> after_step;
};

/// A force that a script wants to act for a while.
struct ScriptPush {
  std::uint32_t body = 0;
  Vec3 force;               ///< N, at the centre of mass
  std::uint64_t until = 0;  ///< the first tick without it
};

class Simulation {
 public:
  /// The scene must outlive the run. One that is not resumable keeps no account of what its
  /// programs read, which saves memory.
  Simulation(const Scene& scene, const PlacedScene& placed, bool resumable = true);

  /// From now on; the writer is given the state as it is, unless the run was resumed and the
  /// writer has the records up to here already. It must outlive the run.
  void record(PoseTraceWriter& writer);
  /// Steps until the world's time is `duration` s, or the scene's stop condition or the
  /// hooks end it.
  RunEnd until(double duration, const RunHooks& hooks);
  /// Ends the trace, if there is one.
  void finish(RunEnd end);
  /// The script's last words: on_end. Once, before finish.
  void end_script(const RunHooks& hooks) {
    if (script_ && !script_failed_) run_script(ScriptCall::end, hooks);
  }

  const World& world() const { return world_; }
  /// Null in a scene without programs and script.
  const Crew* crew() const { return crew_ ? &*crew_ : nullptr; }
  /// What a block's LEDs show now; most of them.
  Led led(std::size_t body) const;
  /// Likewise of each face, in the order of its radios.
  std::array<int, 6> faces(std::size_t body) const;
  const RunTally& tally() const { return tally_; }
  /// Way that a robot has come since the start, m; seen every 0.2 s.
  double driven(std::size_t robot) const { return driven_[robot]; }
  /// What the scene's script has measured, the newest value of each name.
  const std::map<std::string, double>& measures() const { return measures_; }
  /// Has the script failed? message() says how.
  bool script_failed() const { return script_failed_; }
  /// Of one that diverged: when, and which body; of one that its script ended: why.
  const std::string& message() const { return message_; }
  const Scene& scene() const { return *scene_; }
  const PlacedScene& placed() const { return placed_; }

  /// Of the world's state, and of robots and blocks with programs.
  std::uint64_t hash() const;
  /// World, programs and tally; holds for this scene and seed alone. Asserts that the run is
  /// resumable.
  std::string state() const;
  /// False, and nothing changed, when the bytes are no state of this scene. What scripts and
  /// programs said is not said again.
  bool resume(std::string_view state);

 private:
  void before_step(const RunHooks& hooks);
  friend class SceneScript;

  void refill_caches();
  AddResult add_block(const Pose& X_WB);
  void apply_pushes();
  void measure_ways();
  void run_script(ScriptCall which, const RunHooks& hooks);
  void script_ended(ControllerStatus status);
  bool bring_back_script();
  bool take_state(ByteReader& in);
  bool take_pushes(ByteReader& in);
  bool blocks_near(const CacheSpawn& cache) const;
  void note_crew(const RunHooks& hooks);
  void count(const WorldEvent& event);
  void after_step();
  void write_frame();

  const Scene* scene_;
  PlacedScene placed_;
  bool stop_asleep_;
  std::uint64_t frame_every_, hash_every_;
  World world_;
  std::optional<Crew> crew_;
  std::vector<std::size_t> dropped_;  ///< by each cache, and by the script
  std::vector<Vec3> last_places_;     ///< of robots
  std::vector<double> driven_;
  std::optional<LuaScript> script_;
  bool script_failed_ = false, stop_ = false;
  bool resumable_;
  ReadingHistory script_history_;
  std::vector<ScriptPush> pushes_;
  std::map<std::string, double> measures_;
  RunTally tally_;
  std::string message_;
  PoseTraceWriter* writer_ = nullptr;
  std::uint64_t framed_ = UINT64_MAX;  ///< tick of the last frame written
};

/// What the header of a scene's trace says.
PoseTraceHeader trace_header(const Scene& scene, const PlacedScene& placed);

/// A run that stopped, as a file: the scene's texts, the seed and the state.
struct Checkpoint {
  std::vector<SceneFile> files;
  std::uint64_t seed = 1;
  std::string state;
};
std::string checkpoint_bytes(const Checkpoint& checkpoint);
/// Nothing when the bytes are damaged or something else; `problem` says what.
std::optional<Checkpoint> read_checkpoint_file(std::string_view bytes, std::string& problem);

/// Reads and places a scene from texts kept in a trace or a checkpoint.
struct LoadedScene {
  Scene scene;
  PlacedScene placed;
};
std::optional<LoadedScene> load_scene(const std::vector<SceneFile>& files, std::uint64_t seed,
                                      Diagnostics& diagnostics);

/// Runs a trace's scene again and compares.
struct VerifyReport {
  bool identical = false;
  std::uint64_t compared = 0;  ///< hashes
  std::string difference;      ///< in words; empty when identical
};
VerifyReport verify_trace(const PoseTrace& trace, const LoadedScene& loaded, const RunHooks& hooks);

}  // namespace stig
