// SPDX-License-Identifier: MIT
// Frames hold differences of quantised poses to the frame before: a body at rest costs nothing, one
// that moves a few bytes, and zstd finds the rest. Every so many frames a chunk ends, so that a
// reader can begin in the middle. Quantised values are what is compared and summed up, so errors do
// not add up over a chunk.
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/bytes.h"
#include "base/packed.h"
#include "physical/trace/pose_trace.h"
#include "physical/trace/pose_trace_format.h"

namespace stig::physics {

namespace {

using Json = nlohmann::ordered_json;

Json body_json(const TraceBody& body) {
  const Vec3& half = body.shape.half;
  // Numbers as JSON writes them, which are read back exactly.
  Json out{{"name", body.name},
           {"shape", kShapeNames[static_cast<std::size_t>(body.shape.kind)]},
           {"half", {half.x, half.y, half.z}},
           {"block", body.block},
           {"led", to_string(body.led)},
           {"color", to_color(body.rgb)},
           {"fixed", body.fixed}};
  if (body.shape.kind == ShapeKind::hull) {
    for (const Vec3& p : body.shape.convex->points) out["points"].push_back({p.x, p.y, p.z});
  }
  if (body.visual) {
    Json& surface =
        out["surface"] = {{"points", Json::array()}, {"triangles", body.visual->triangles}};
    for (const Vec3& p : body.visual->points) surface["points"].push_back({p.x, p.y, p.z});
  }
  return out;
}

// Files and JSON: readers need both to run the scene again.
std::string header_bytes(const PoseTraceHeader& header) {
  Json json;
  json["title"] = header.title;
  json["seed"] = header.seed;
  json["step"] = header.step;
  json["frame_every"] = header.frame_every;
  json["hash_every"] = header.hash_every;
  json["channels"] = header.channels;
  json["bodies"] = Json::array();
  for (const TraceBody& body : header.bodies) json["bodies"].push_back(body_json(body));
  std::string out;
  // Names may be any bytes; what is not UTF-8 is replaced, since JSON must be.
  put_block(out, json.dump(-1, ' ', false, Json::error_handler_t::replace));
  put_varint(out, header.files.size());
  for (const SceneFile& file : header.files) {
    put_block(out, file.name);
    put_block(out, file.text);
  }
  return out;
}

/// The one of q and -q, which are the same rotation, that is nearer to the one before: it makes
/// small differences.
void choose_sign(TraceState& state, const TraceState& last) {
  double product = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    product += static_cast<double>(state.turn[i]) * static_cast<double>(last.turn[i]);
  }
  if (product >= 0) return;
  for (std::int64_t& part : state.turn) part = -part;
}

void put_state(std::string& out, const TraceState& state, const TraceState& last) {
  const bool moved = state.place != last.place, turned = state.turn != last.turn;
  // The awake and left flags are said of every body that changed.
  out.push_back(static_cast<char>((moved ? kMoved : 0) | (turned ? kTurned : 0) |
                                  (state.awake ? kAwake : 0) | (state.left ? kLeft : 0)));
  for (std::size_t i = 0; moved && i < 3; ++i) put_zigzag(out, state.place[i] - last.place[i]);
  for (std::size_t i = 0; turned && i < 4; ++i) put_zigzag(out, state.turn[i] - last.turn[i]);
}

}  // namespace

std::string_view to_string(RunEnd end) {
  constexpr std::string_view kNames[] = {"duration", "asleep", "interrupted",
                                         "diverged", "failed", "script"};
  return kNames[static_cast<std::size_t>(end)];
}

Pose TraceState::pose() const {
  const auto part = [&](std::size_t i) { return static_cast<double>(turn[i]) * kTurnQuantum; };
  const auto at = [&](std::size_t i) { return static_cast<double>(place[i]) * kPlaceQuantum; };
  return {{at(0), at(1), at(2)}, normalised(Quat{part(0), part(1), part(2), part(3)})};
}

TraceState trace_state(const BodyState& state) {
  const Vec3& p = state.X_WB.p;
  const Quat& q = state.X_WB.q;
  // Half a quantum off at most, whatever came before: rounding is of poses, not of differences.
  const auto whole = [](double x, double quantum) {
    return std::int64_t{std::llround(x / quantum)};
  };
  return {{whole(p.x, kPlaceQuantum), whole(p.y, kPlaceQuantum), whole(p.z, kPlaceQuantum)},
          {whole(q.w, kTurnQuantum), whole(q.x, kTurnQuantum), whole(q.y, kTurnQuantum),
           whole(q.z, kTurnQuantum)},
          state.awake,
          state.left};
}

// The magic comes first, before anything can fail.
PoseTraceWriter::PoseTraceWriter(const PoseTraceHeader& header, Sink sink)
    : sink_(std::move(sink)), channels_(header.channels) {
  sink_(kPoseTraceMagic);
  written_ = kPoseTraceMagic.size();
  put_section(kHeaderTag, packed(header_bytes(header)));
  log_ = channel("log");
}

std::optional<std::uint32_t> PoseTraceWriter::channel(std::string_view name) const {
  const auto found = std::find(channels_.begin(), channels_.end(), name);
  if (found == channels_.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - channels_.begin());
}

// A section is a tag, the length of what follows, and a zstd frame: readers can pass over it.
void PoseTraceWriter::put_section(char tag, const std::string& frame) {
  std::string out(1, tag);
  put(out, static_cast<std::uint32_t>(frame.size()));
  out += frame;
  sink_(out);
  written_ += out.size();
}

// Ticks as differences: mostly a byte.
void PoseTraceWriter::put_record(std::uint8_t tag, std::uint64_t tick) {
  assert(tick >= tick_);
  chunk_.push_back(static_cast<char>(tag));
  put_varint(chunk_, tick - tick_);
  tick_ = tick;
}

/// Chunks are written one after the other, so the bytes do not depend on the threads.
void PoseTraceWriter::put_packed_chunk() {
  if (!packing_.valid()) return;
  const std::string frame = packing_.get();
  // Places of chunks, in bytes of the file, so that a reader finds a moment by bisection.
  put_varint(index_, packing_from_);
  put_varint(index_, written_);
  ++chunks_;
  put_section(kChunkTag, frame);
}

void PoseTraceWriter::flush() {
  assert(chunk_.empty() == (frames_ == 0));
  if (chunk_.empty()) return;
  put_packed_chunk();
  packing_ =
      std::async(std::launch::async, [payload = std::move(chunk_)] { return packed(payload); });
  packing_from_ = first_tick_;
  chunk_.clear();
  frames_ = 0;
}

void PoseTraceWriter::frame(const TraceFrame& frame) {
  if (frames_ == kFramesPerChunk) flush();
  const bool first = chunk_.empty();
  // A chunk begins anew from zero poses, so that it stands alone.
  if (first) {
    first_tick_ = tick_ = frame.tick;
    put_varint(chunk_, first_tick_);
    last_.assign(frame.bodies.size(), {});
  }
  put_record(kFrameRecord, frame.tick);
  std::string changes;
  std::uint64_t changed = 0, next = 0;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    TraceState state = frame.bodies[i];
    choose_sign(state, last_[i]);
    if (!first && state == last_[i]) continue;
    // Numbers of bodies as gaps: of neighbours that move together each costs a byte.
    put_varint(changes, i - next);
    put_state(changes, state, last_[i]);
    last_[i] = state;
    next = i + 1;
    ++changed;
  }
  put_varint(chunk_, changed);
  chunk_ += changes;
  ++frames_;
  if (!first) return;
  // Values that hold are said again at the start of each chunk.
  for (const auto& [place, bytes] : values_) {
    put_value({frame.tick, place.first, place.second, bytes});
  }
}

void PoseTraceWriter::event(const TraceEvent& event) {
  put_record(kEventRecord, event.tick);
  chunk_.push_back(static_cast<char>(event.event.kind));
  put_varint(chunk_, static_cast<std::uint32_t>(event.event.body));
  // The floor is 0xffffffff, which plus one is 0.
  put_varint(chunk_, static_cast<std::uint32_t>(static_cast<std::uint32_t>(event.event.other) + 1));
}

void PoseTraceWriter::hash(const TraceHash& hash) {
  put_record(kHashRecord, hash.tick);
  put(chunk_, hash.hash);
}

void PoseTraceWriter::value(const TraceValue& value) {
  // Log lines are events and never repeated; other values hold until they change.
  if (value.channel == log_) return put_value(value);
  const auto [known, fresh] = values_.try_emplace({value.channel, value.body}, value.bytes);
  if (!fresh && known->second == value.bytes) return;
  known->second = value.bytes;
  put_value(value);
}

void PoseTraceWriter::put_value(const TraceValue& value) {
  put_record(kValueRecord, value.tick);
  put_varint(chunk_, value.channel);
  put_varint(chunk_, value.body);
  put_block(chunk_, value.bytes);
}

// Places as they were given, to the last bit: the run is to be done again.
void PoseTraceWriter::hand(const TraceHand& hand) {
  const HandAction& action = hand.action;
  put_record(kHandRecord, hand.tick);
  chunk_.push_back(static_cast<char>(kHandVersion));
  chunk_.push_back(static_cast<char>(action.kind));
  chunk_.push_back(action.robot ? 1 : 0);
  put_varint(chunk_, action.number);
  chunk_.push_back(action.turn ? 1 : 0);
  const auto put_double = [this](double x) { put(chunk_, std::bit_cast<std::uint64_t>(x)); };
  for (const double x : {action.at.x, action.at.y, action.at.z}) put_double(x);
  if (!action.turn) return;
  for (const double x : {action.turn->w, action.turn->x, action.turn->y, action.turn->z}) {
    put_double(x);
  }
}

void PoseTraceWriter::finish(const TraceEnd& end) {
  flush();
  put_packed_chunk();
  std::string payload;
  put_varint(payload, end.ticks);
  payload.push_back(static_cast<char>(end.why));
  put(payload, end.hash);
  put_block(payload, end.message);
  put_varint(payload, chunks_);
  payload += index_;
  // The file's last bytes say where this section, with the index of chunks, begins.
  const std::uint64_t place = written_;
  put_section(kEndTag, packed(payload));
  std::string trailer;
  put(trailer, place);
  sink_(trailer + std::string(kTrailerMagic));
}

}  // namespace stig::physics
