// SPDX-License-Identifier: MIT
// What goes from a run into its trace.
#pragma once

#include "physical/simulation/run_part.h"
#include "physical/simulation/uses.h"
#include "physical/trace/pose_trace.h"

namespace stig::physics {

struct PlacedScene;
struct Scene;

/// What the header of a scene's trace says. A detailed trace has, besides, what robots sense, hear
/// and send, and the directions of blocks' magnets (detail_json.h): channels of their own, which a
/// run is recorded into because they are there.
PoseTraceHeader trace_header(const Scene& scene, const PlacedScene& placed, bool detailed = false);

class TraceRecorder final : public RunPart {
 public:
  /// From now on; see Simulation::record. The writer must outlive the recorder, or `finish`.
  void begin(const RunState& run, PoseTraceWriter& writer);
  /// Goes on in the trace of another run.
  void take_over(const TraceRecorder& other) { writer_ = other.writer_; }
  /// Something that a program said.
  void note(const RunState& run, const CrewLine& line);
  /// Something that was done by hand in the tick that is to come.
  void hand(const RunState& run, const HandAction& action);
  /// Ends the trace, if there is one.
  void finish(const RunState& run, RunEnd end);

  /// What programs have changed in this tick.
  void before_step(RunState& run, const RunHooks& hooks) override;
  void after_step(RunState& run) override;

 private:
  void write_frame(const RunState& run);
  void write_details(const RunState& run);
  void write_magnets(const RunState& run, std::uint32_t channel);
  void write_contacts(const RunState& run, std::uint32_t channel);
  void write_pulls(const RunState& run, std::uint32_t channel);

  PoseTraceWriter* writer_ = nullptr;
  std::uint64_t framed_ = UINT64_MAX;  ///< tick of the last frame written
};

}  // namespace stig::physics
