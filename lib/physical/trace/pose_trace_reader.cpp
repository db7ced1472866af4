// SPDX-License-Identifier: MIT
// Traces are files that others may have made, so nothing is taken on trust: sizes are bounded
// before memory is taken, every number is checked before it is an index, and all chunks are decoded
// once when a trace is opened, so that whoever asks for frames later cannot fail. docs/simulate.md
// describes the format.
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "base/bytes.h"
#include "base/packed.h"
#include "physical/trace/pose_frames.h"
#include "physical/trace/pose_trace.h"
#include "physical/trace/pose_trace_format.h"
#include "physical/trace/pose_trace_header.h"

namespace stig::physics {

namespace {

constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 27;
constexpr std::size_t kMostChunkBytes = std::size_t{1} << 28;
// Bounds for a file that unpacks to far more than its size.
constexpr std::size_t kMostUnpacked = std::size_t{1} << 31;  ///< of all chunks together
constexpr std::size_t kMostRecords = std::size_t{1} << 24;   ///< kept: events, hashes, values
// 2^40 quanta, beyond any arena; far from overflow when summed.
constexpr std::int64_t kFarthest = std::int64_t{1} << 40;
constexpr std::size_t kTrailerSize = 16;

/// What a record is handed to while a chunk is decoded; those left out are passed over.
struct RecordSinks {
  std::function<void(const TraceFrame&)> frame;
  std::function<void(TraceEvent)> event;
  std::function<void(TraceHash)> hash;
  std::function<void(TraceValue)> value;
  std::function<void(TraceHand)> hand;
};

template <class Record>
void hand_over(const std::function<void(Record)>& sink, std::decay_t<Record> record) {
  if (sink) sink(std::move(record));
}

// Poses are kept as differences to the frame before, from zero at the chunk's start.
class ChunkDecoder {
 public:
  ChunkDecoder(std::string_view payload, const PoseTraceHeader& header, const RecordSinks& sinks)
      : in_(payload), channels_(header.channels.size()), sinks_(sinks) {
    frame_.bodies.resize(header.bodies.size());
    frame_.tick = in_.varint();
    tick_ = frame_.tick;
  }

  std::uint64_t first_tick() const { return tick_; }

  /// False when the chunk is malformed, or has no frame.
  bool decode() {
    bool good = in_.good();
    while (good && in_.left() > 0) good = record() && in_.good();
    return good && begun_;
  }

 private:
  bool record() {
    const std::uint8_t tag = in_.u8();
    const std::uint64_t ticks = in_.varint();
    // Limits keep the sum of ticks from wrapping round.
    if (ticks > (std::uint64_t{1} << 48) || tick_ > (std::uint64_t{1} << 60)) return false;
    tick_ += ticks;
    // Each chunk can be decoded alone: it begins with a whole frame.
    if (!begun_ && tag != kFrameRecord) return false;
    switch (tag) {
      case kFrameRecord:
        return frame();
      case kEventRecord:
        return event();
      case kHashRecord:
        hand_over(sinks_.hash, {tick_, in_.u64()});
        return true;
      case kValueRecord:
        return value();
      case kHandRecord:
        return hand();
      default:
        return false;
    }
  }

  bool frame() {
    const std::uint64_t changed = in_.varint();
    // The first frame of a chunk has all bodies.
    if (changed > frame_.bodies.size() || (!begun_ && changed != frame_.bodies.size()))
      return false;
    begun_ = true;
    std::uint64_t next = 0;
    for (std::uint64_t i = 0; i < changed; ++i) {
      const std::uint64_t gap = in_.varint();
      // Gaps are between the numbers of bodies that changed, and no number may reach the count of
      // bodies.
      if (gap >= frame_.bodies.size() - std::min<std::uint64_t>(next, frame_.bodies.size())) {
        return false;
      }
      next += gap;
      if (!state(frame_.bodies[next++])) return false;
    }
    frame_.tick = tick_;
    if (sinks_.frame) sinks_.frame(frame_);
    return true;
  }

  bool state(TraceState& state) {
    const std::uint8_t flags = in_.u8();
    // Flags that are not known are a newer format or damage.
    bool good = flags < 16;
    const auto add = [&](std::int64_t& part) {
      const std::int64_t delta = in_.zigzag();
      good = good && delta >= -kFarthest && delta <= kFarthest;
      if (good) part += delta;
      good = good && part >= -kFarthest && part <= kFarthest;
    };
    // Differences in place and turn are there only where something changed.
    if ((flags & kMoved) != 0) std::for_each(state.place.begin(), state.place.end(), add);
    if ((flags & kTurned) != 0) std::for_each(state.turn.begin(), state.turn.end(), add);
    state.awake = (flags & kAwake) != 0;
    state.left = (flags & kLeft) != 0;
    return good && turn_is_unit(state);
  }

  // Quantised quaternions are off by far less than 1 %.
  static bool turn_is_unit(const TraceState& state) {
    double sum = 0;
    for (const std::int64_t part : state.turn) {
      const double x = static_cast<double>(part) * kTurnQuantum;
      sum += x * x;
    }
    return std::abs(sum - 1) < 0.01;
  }

  bool event() {
    const std::uint8_t kind = in_.u8();
    const std::uint64_t body = in_.varint(), other = in_.varint();
    const std::size_t bodies = frame_.bodies.size();
    // Partners are written plus one, since 0 is the floor.
    if (kind > static_cast<std::uint8_t>(EventKind::let_go) || body >= bodies || other > bodies) {
      return false;
    }
    const BodyId partner = other == 0 ? kFloorId : BodyId{static_cast<std::uint32_t>(other - 1)};
    hand_over(
        sinks_.event,
        {tick_, {static_cast<EventKind>(kind), BodyId{static_cast<std::uint32_t>(body)}, partner}});
    return true;
  }

  bool value() {
    const std::uint64_t channel = in_.varint(), body = in_.varint();
    const std::string_view bytes = in_.block();
    if (channel >= channels_ || body >= frame_.bodies.size()) return false;
    hand_over(sinks_.value, {tick_, static_cast<std::uint32_t>(channel),
                             static_cast<std::uint32_t>(body), std::string(bytes)});
    return true;
  }

  bool hand() {
    const std::uint8_t version = in_.u8(), kind = in_.u8(), robot = in_.u8();
    const std::uint64_t number = in_.varint();
    const std::uint8_t turned = in_.u8();
    const bool known = version == kHandVersion && kind <= static_cast<std::uint8_t>(HandKind::mend);
    if (!known || robot > 1 || turned > 1 || number >= frame_.bodies.size()) return false;
    const auto real = [this] { return std::bit_cast<double>(in_.u64()); };
    HandAction action;
    action.kind = static_cast<HandKind>(kind);
    action.robot = robot == 1;
    action.number = static_cast<std::uint32_t>(number);
    action.at = Vec3{real(), real(), real()};
    if (turned == 1) action.turn = Quat{real(), real(), real(), real()};
    const Quat turn = action.turn.value_or(Quat{});
    const double size = turn.w * turn.w + turn.x * turn.x + turn.y * turn.y + turn.z * turn.z;
    if (!is_finite(action.at) || !(std::abs(size - 1) < 1e-6)) return false;
    hand_over(sinks_.hand, {tick_, action});
    return true;
  }

  ByteReader in_;
  std::size_t channels_ = 0;
  const RecordSinks& sinks_;
  std::uint64_t tick_ = 0;
  bool begun_ = false;
  TraceFrame frame_;
};

class Reader {
 public:
  explicit Reader(std::string bytes) { trace_.bytes = std::move(bytes); }

  /// What is wrong; empty: nothing.
  std::string read() {
    const std::string_view all = trace_.bytes;
    if (!all.starts_with(kPoseTraceMagic)) return "it does not begin with \"stigpos1\"";
    if (all.size() < kPoseTraceMagic.size() + kTrailerSize || !all.ends_with(kTrailerMagic)) {
      return "its end is missing";
    }
    // The trailer says where the end section is; sections in between are read in order.
    ByteReader trailer(all.substr(all.size() - kTrailerSize));
    const std::uint64_t end_place = trailer.u64();
    ByteReader in(all.substr(0, all.size() - kTrailerSize));
    in.take(kPoseTraceMagic.size());
    std::string problem = read_header(in);
    while (problem.empty()) {
      const std::size_t place = all.size() - kTrailerSize - in.left();
      // Only at the place that the trailer names may the end begin.
      if (place == end_place) return read_end(in);
      problem = read_chunk(in, place);
    }
    return problem;
  }
  PoseTrace take() { return std::move(trace_); }

 private:
  /// The frame of the next section, or nothing when it has another tag or is cut short.
  static std::optional<std::string_view> section(ByteReader& in, char tag) {
    if (static_cast<char>(in.u8()) != tag) return std::nullopt;
    const std::uint32_t size = in.u32();
    const std::string_view frame = in.take(size);
    return in.good() ? std::optional(frame) : std::nullopt;
  }

  std::string read_header(ByteReader& in) {
    const auto frame = section(in, kHeaderTag);
    const auto payload = frame ? unpacked(*frame, kMostHeaderBytes) : std::nullopt;
    if (!payload) return "its header is damaged";
    ByteReader header(*payload);
    const std::string_view json = header.block();
    const std::uint64_t files = header.varint();
    for (std::uint64_t i = 0; i < files && header.good(); ++i) {
      const std::string name(header.block());
      trace_.header.files.push_back({name, std::string(header.block())});
    }
    if (!header.good() || header.left() > 0) return "its header is cut short";
    return read_header_json(json, trace_.header) ? "" : "its header is malformed";
  }

  std::string read_chunk(ByteReader& in, std::size_t place) {
    const auto frame = section(in, kChunkTag);
    const auto payload = frame ? unpacked(*frame, kMostChunkBytes) : std::nullopt;
    const std::string name = "chunk " + std::to_string(trace_.chunks.size() + 1);
    if (!payload) return name + " is damaged";
    // Sums over chunks: each may be small and all together too much.
    unpacked_bytes_ += payload->size();
    if (unpacked_bytes_ > kMostUnpacked) return "it holds more than can be read";
    RecordSinks sinks;
    sinks.frame = [this](const TraceFrame&) { ++trace_.frames; };
    sinks.event = [this](TraceEvent event) { trace_.events.push_back(event); };
    sinks.hash = [this](TraceHash hash) { trace_.hashes.push_back(hash); };
    sinks.value = [this](TraceValue value) { trace_.values.push_back(std::move(value)); };
    sinks.hand = [this](TraceHand hand) { trace_.hands.push_back(hand); };
    ChunkDecoder decoder(*payload, trace_.header, sinks);
    const std::uint64_t first = decoder.first_tick();
    // Ticks rise from chunk to chunk, as frame_at's search needs.
    const bool ordered = trace_.chunks.empty() || first > trace_.chunks.back().first_tick;
    if (!ordered || !decoder.decode()) return name + " is malformed";
    if (trace_.events.size() + trace_.hashes.size() + trace_.values.size() + trace_.hands.size() >
        kMostRecords) {
      return "it has more events than can be held";
    }
    const std::size_t begin = place + 5;  // behind tag and size
    trace_.chunks.push_back({first, begin, begin + frame->size()});
    return {};
  }

  std::string read_end(ByteReader& in) {
    const auto frame = section(in, kEndTag);
    const auto payload = frame ? unpacked(*frame, kMostHeaderBytes) : std::nullopt;
    if (!payload || in.left() > 0) return "its end is damaged";
    ByteReader end(*payload);
    trace_.end.ticks = end.varint();
    const std::uint8_t why = end.u8();
    trace_.end.hash = end.u64();
    trace_.end.message = std::string(end.block());
    bool good = why <= static_cast<std::uint8_t>(RunEnd::script);
    trace_.end.why = good ? static_cast<RunEnd>(why) : RunEnd::duration;
    // The index repeats what reading has found, for readers that seek; it must agree.
    good = good && end.varint() == trace_.chunks.size();
    for (const TraceChunk& chunk : trace_.chunks) {
      good = good && end.varint() == chunk.first_tick && end.varint() == chunk.begin - 5;
    }
    if (!good || !end.good() || end.left() > 0 || trace_.chunks.empty()) {
      return "its end is malformed";
    }
    return {};
  }

  PoseTrace trace_;
  std::size_t unpacked_bytes_ = 0;
};

// The payload was good when the trace was opened.
void decode(const PoseTrace& trace, const TraceChunk& chunk, const RecordSinks& sinks) {
  const auto payload = unpacked(
      std::string_view(trace.bytes).substr(chunk.begin, chunk.end - chunk.begin), kMostChunkBytes);
  if (payload) ChunkDecoder(*payload, trace.header, sinks).decode();
}

}  // namespace

std::optional<PoseTrace> read_pose_trace(const std::string& path, std::string bytes,
                                         Diagnostics& diagnostics) {
  Reader reader(std::move(bytes));
  const std::string problem = reader.read();
  if (problem.empty()) return reader.take();
  // Bytes have no lines to point at.
  diagnostics.add(Code::F480, {std::make_shared<SourceFile>(path, ""), 0, 0},
                  "not a readable trace of poses: " + problem);
  return std::nullopt;
}

TraceFrame frame_at(const PoseTrace& trace, std::uint64_t tick) {
  assert(!trace.chunks.empty());
  const auto later =
      std::upper_bound(trace.chunks.begin(), trace.chunks.end(), tick,
                       [](std::uint64_t t, const TraceChunk& c) { return t < c.first_tick; });
  const TraceChunk& chunk = later == trace.chunks.begin() ? *later : *(later - 1);
  std::optional<TraceFrame> found;
  RecordSinks sinks;
  // Frames are differences, so the chunk is decoded from its beginning; the last frame up to the
  // tick is kept, or the first one when all are later.
  sinks.frame = [&](const TraceFrame& frame) {
    if (!found || frame.tick <= tick) found = frame;
  };
  decode(trace, chunk, sinks);
  return std::move(found).value_or(TraceFrame{});
}

void for_each_frame(const PoseTrace& trace, const std::function<void(const TraceFrame&)>& visit) {
  RecordSinks sinks;
  sinks.frame = visit;
  for (const TraceChunk& chunk : trace.chunks) decode(trace, chunk, sinks);
}

// A resumed run goes on in the same trace: what it had written up to its checkpoint is copied, so
// that the bytes are those of a run that never stopped.
void copy_records(const PoseTrace& trace, std::uint64_t up_to, PoseTraceWriter& writer,
                  std::optional<std::size_t> hands) {
  assert(trace.header.frame_every > 0);
  RecordSinks sinks;
  bool begun = false;  // a chunk begins with a frame: what comes before the first one is left out
  sinks.frame = [&](const TraceFrame& frame) {
    if (frame.tick > up_to || frame.tick % trace.header.frame_every != 0) return;
    begun = true;
    writer.frame(frame);
  };
  sinks.event = [&](const TraceEvent& event) {
    if (begun && event.tick <= up_to) writer.event(event);
  };
  sinks.hash = [&](const TraceHash& hash) {
    if (begun && hash.tick <= up_to) writer.hash(hash);
  };
  sinks.value = [&](const TraceValue& value) {
    // Values of the tick itself are written again by the run that goes on.
    if (begun && value.tick < up_to) writer.value(value);
  };
  std::size_t done = 0;
  sinks.hand = [&](const TraceHand& hand) {
    if (begun && (hands ? done < *hands : hand.tick < up_to)) writer.hand(hand);
    ++done;
  };
  for (const TraceChunk& chunk : trace.chunks) decode(trace, chunk, sinks);
}

}  // namespace stig::physics
