// SPDX-License-Identifier: MIT
// Traces of poses (.stigp): a physical run as data, to be looked at, compared and run
// again.
//
// Layout, version 1: the 8 bytes "stigpos1", then sections of a tag byte, the size as
// u32, and one zstd frame with a checksum each:
//   H  header, once: JSON with title, seed, step, frame_every, hash_every, channels and
//      bodies (name, shape, half extents, block, LEDs, colour, fixed, points of a hull, surface to
//      look at), then the files of the scene
//   C  a chunk of records, which can be decoded alone. A record is a tag byte and the ticks
//      since the record before as varint, then
//        1 frame   number of bodies that changed; of each: distance of its number from the
//                  one before, a byte of what changed and of its state, and the differences
//        2 event   kind, body, other body + 1
//        3 hash    of the world's state, u64
//        4 value   channel, body, bytes: LED colours, words of robots and the like
//        5 hand    what somebody did to the run by hand (hand_action.h): a byte for the version of
//                  the record, 1; kind; 1 for a robot; its number; whether it is turned; place
//                  and, when turned, quaternion, as doubles
//      A chunk begins with a frame of all bodies and holds kFramesPerChunk frames.
//   E  end, once: ticks, why it ended, hash of the state, a message, and for each chunk
//      its first tick and its place in the file
// and the place of E as u64, followed by "stigpend". Integers are little-endian.
//
// Places are whole multiples of 10 µm, rotations quaternions in multiples of 1/16384 (0.007°
// at most beside the truth). Velocities are not kept.
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "physical/dynamics/world.h"
#include "physical/scene/scene.h"
#include "physical/trace/hand_action.h"
#include "physical/trace/uses.h"

namespace stig::physics {

inline constexpr std::string_view kPoseTraceMagic = "stigpos1";
inline constexpr std::size_t kFramesPerChunk = 250;
inline constexpr double kPlaceQuantum = 1e-5;  ///< m
inline constexpr double kTurnQuantum = 1.0 / 16384;

struct TraceBody {
  std::string name;
  Shape shape;
  bool block = false;  ///< with tags, and LEDs that are lit so at the start
  Led led = Led::off;
  Rgb rgb{176, 180, 186};
  bool fixed = false;
  std::shared_ptr<const VisualMesh> visual = {};  ///< what is looked at, in place of the shape
};

struct PoseTraceHeader {
  std::string title;
  std::uint64_t seed = 1;
  double step = 0.005;             ///< s
  std::uint64_t frame_every = 4;   ///< ticks
  std::uint64_t hash_every = 200;  ///< ticks
  std::vector<std::string> channels;
  std::vector<TraceBody> bodies;
  std::vector<SceneFile> files;  ///< of the scene, which so can be run again
};

enum class RunEnd : std::uint8_t { duration, asleep, interrupted, diverged, failed, script };
std::string_view to_string(RunEnd end);

/// A body in a frame, in whole multiples of the quanta.
struct TraceState {
  std::array<std::int64_t, 3> place{};
  std::array<std::int64_t, 4> turn{};  ///< w, x, y, z; the sign nearest to the frame before
  bool awake = false, left = false;

  Pose pose() const;
  friend bool operator==(const TraceState&, const TraceState&) = default;
};
TraceState trace_state(const BodyState& state);

struct TraceEvent {
  std::uint64_t tick = 0;
  WorldEvent event;
};
struct TraceHash {
  std::uint64_t tick = 0, hash = 0;
};
struct TraceValue {
  std::uint64_t tick = 0;
  std::uint32_t channel = 0, body = 0;
  std::string bytes;
};
/// Done in a tick before anything else of that tick, those of one tick in their order.
struct TraceHand {
  std::uint64_t tick = 0;
  HandAction action;
};
struct TraceFrame {
  std::uint64_t tick = 0;
  std::vector<TraceState> bodies;
};

/// How a run ended.
struct TraceEnd {
  std::uint64_t ticks = 0;
  RunEnd why = RunEnd::duration;
  std::uint64_t hash = 0;
  std::string message;  ///< of one that diverged
};

/// Encodes records as they come, in the order of their ticks, and hands over bytes whenever
/// a chunk is full.
class PoseTraceWriter {
 public:
  using Sink = std::function<void(std::string_view)>;

  PoseTraceWriter(const PoseTraceHeader& header, Sink sink);
  /// The number of a channel of the header.
  std::optional<std::uint32_t> channel(std::string_view name) const;
  void frame(const TraceFrame& frame);
  void event(const TraceEvent& event);
  void hash(const TraceHash& hash);
  /// Nothing when it is what the channel said of the body last; in the channel "log" everything
  /// counts, but a chunk does not begin with the lines of those before.
  void value(const TraceValue& value);
  void hand(const TraceHand& hand);
  void finish(const TraceEnd& end);

 private:
  void put_section(char tag, const std::string& frame);
  void put_packed_chunk();
  void put_record(std::uint8_t tag, std::uint64_t tick);
  void put_value(const TraceValue& value);
  void flush();

  Sink sink_;
  std::vector<std::string> channels_;
  std::string chunk_;
  std::uint64_t written_ = 0, tick_ = 0, first_tick_ = 0;
  std::size_t frames_ = 0;
  std::vector<TraceState> last_;
  /// The newest of each channel and body.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> values_;
  std::optional<std::uint32_t> log_;  ///< the channel whose values are happenings, not states
  std::string index_;
  std::uint64_t chunks_ = 0;
  /// The chunk before, which a thread of its own packs while the run goes on, and its first tick.
  std::future<std::string> packing_;
  std::uint64_t packing_from_ = 0;
};

struct TraceChunk {
  std::uint64_t first_tick = 0;
  std::size_t begin = 0, end = 0;  ///< of its zstd frame in the file
};

/// A trace that was read and found whole: every record in it can be decoded.
struct PoseTrace {
  std::string bytes;  ///< of the file
  PoseTraceHeader header;
  std::vector<TraceChunk> chunks;
  std::vector<TraceEvent> events;
  std::vector<TraceHash> hashes;
  std::vector<TraceValue> values;
  std::vector<TraceHand> hands;
  std::uint64_t frames = 0;
  TraceEnd end;
};

/// Anything malformed is a diagnostic.
std::optional<PoseTrace> read_pose_trace(const std::string& path, std::string bytes,
                                         Diagnostics& diagnostics);

/// The last frame at or before a tick; the first when there is none.
TraceFrame frame_at(const PoseTrace& trace, std::uint64_t tick);

/// Writes the records of a trace up to a tick into another, those of an early end left out, and
/// values of the tick itself, which the tick's control writes anew: what follows continues the
/// run as if it had never stopped. What was done by hand is copied as far as `hands`, or up to the
/// tick where that is not said.
void copy_records(const PoseTrace& trace, std::uint64_t up_to, PoseTraceWriter& writer,
                  std::optional<std::size_t> hands = std::nullopt);

}  // namespace stig::physics
