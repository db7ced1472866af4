// SPDX-License-Identifier: MIT
// Digits are those that the trace has: places to 10 µm, turns to 1/16384.
#include "view/pose_mcap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "base/hash.h"
#include "base/text.h"
#include "physical/render/solid_faces.h"
#include "physical/trace/pose_frames.h"
#include "view/foxglove_schema.h"
#include "view/mcap_file.h"
#include "view/trace_picture.h"

namespace stig::view {

namespace {

using Json = nlohmann::ordered_json;

enum McapTopic : std::size_t { kTransforms, kScene, kLog };
constexpr std::string_view kWorld = "world";

// As foxglove.LogLevel has them.
constexpr int kDebug = 1, kInfo = 2, kWarning = 3, kError = 4;

std::string dumped(const Json& json) {
  // What programs log may be any bytes.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json xyz(const Vec3& v) { return {{"x", v.x}, {"y", v.y}, {"z", v.z}}; }

/// A frame for each body: its name, with its number where that is not its alone.
std::vector<std::string> frame_names(const PoseTrace& trace) {
  std::vector<std::string> out;
  std::set<std::string> taken{std::string(kWorld), ""};
  for (const TraceBody& body : trace.header.bodies) {
    std::string name = printable(body.name);
    for (std::size_t i = out.size(); !taken.insert(name).second; ++i) {
      name = fmt::format("{} #{}", printable(body.name), i);
    }
    out.push_back(std::move(name));
  }
  return out;
}

/// A body's surface, as what foxglove.SceneEntity calls a list of.
std::pair<const char*, Json> surface(const TraceBody& body, Led led) {
  const bool lit = body.block && led != Led::off;
  const Rgb rgb = lit ? blend(body.rgb, rgb_of(led), 0.6) : body.rgb;
  const auto share = [](std::uint8_t value) { return std::round(value / 255.0 * 1e4) / 1e4; };
  Json out{{"pose", {{"position", xyz({})}, {"orientation", xyz({})}}}};
  out["pose"]["orientation"]["w"] = 1;
  out["color"] = {{"r", share(rgb.r)}, {"g", share(rgb.g)}, {"b", share(rgb.b)}, {"a", 1}};
  if (body.shape.kind != ShapeKind::hull) out["size"] = xyz(body.shape.half * 2);
  switch (body.shape.kind) {
    case ShapeKind::box:
      return {"cubes", out};
    case ShapeKind::sphere:
      return {"spheres", out};
    case ShapeKind::cylinder:
      out["bottom_scale"] = out["top_scale"] = 1;
      return {"cylinders", out};
    case ShapeKind::hull:
      break;
  }
  out["points"] = out["colors"] = out["indices"] = Json::array();
  for (const SolidFace& face : faces_of(body.shape)) {
    // Faces are convex: a fan of triangles fills them.
    for (std::size_t i = 2; i < face.corners.size(); ++i) {
      for (const std::size_t k : {std::size_t{0}, i - 1, i}) {
        out["points"].push_back(xyz(face.corners[k]));
      }
    }
  }
  return {"triangles", out};
}

std::string event_text(EventKind kind, const std::string& other) {
  switch (kind) {
    case EventKind::contact_began:
      return "touches " + other;
    case EventKind::slept:
      return "rests";
    case EventKind::woke:
      return "moves";
    case EventKind::left_arena:
      return "left the arena";
    case EventKind::snapped:
      return "snapped together with " + other;
    case EventKind::let_go:
      return "let go of " + other;
  }
  return {};
}

int event_level(EventKind kind) {
  if (kind == EventKind::left_arena) return kWarning;
  return kind == EventKind::snapped || kind == EventKind::let_go ? kInfo : kDebug;
}

class PoseMcap {
 public:
  PoseMcap(const PoseTrace& trace, const McapWriter::Sink& sink)
      : trace_(trace),
        out_({{"/tf", "foxglove.FrameTransforms", frame_transforms_schema()},
              {"/scene", "foxglove.SceneUpdate", scene_update_schema()},
              {"/log", "foxglove.Log", log_schema()}},
             sink),
        names_(frame_names(trace)),
        leds_(led_changes(trace, 0, UINT64_MAX)),
        led_(leds_.size()),
        there_(leds_.size()) {
    for (const std::string& name : names_) {
      transform_heads_.push_back(
          fmt::format(R"("parent_frame_id":"{}","child_frame_id":{},)", kWorld, dumped(name)));
    }
    const auto channel =
        std::find(trace.header.channels.begin(), trace.header.channels.end(), "log");
    log_channel_ = static_cast<std::uint32_t>(channel - trace.header.channels.begin());
  }

  void write() {
    put_facts();
    for_each_frame(trace_, [&](const TraceFrame& frame) {
      if (!out_.wanted()) return;
      put_log_before(frame.tick);
      put_scene(frame);
      put_transforms(frame);
    });
    put_log_before(UINT64_MAX);
    put_end();
    out_.finish();
  }

 private:
  /// ns; of a tick that nobody can reach: the last that there is.
  std::uint64_t time_at(std::uint64_t tick) const {
    const double time = static_cast<double>(tick) * trace_.header.step * 1e9;
    return static_cast<std::uint64_t>(std::llround(std::min(time, 4e18)));
  }
  static Json stamp(std::uint64_t time) {
    return {{"sec", time / 1'000'000'000}, {"nsec", time % 1'000'000'000}};
  }

  void put_facts() {
    const PoseTraceHeader& header = trace_.header;
    out_.metadata("run", {{"title", printable(header.title)},
                          {"seed", std::to_string(header.seed)},
                          {"step", fmt::format("{} s", header.step)},
                          {"ended", std::string(to_string(trace_.end.why))},
                          {"hash", to_hex(trace_.end.hash)}});
  }

  void put_transforms(const TraceFrame& frame) {
    const std::uint64_t time = time_at(frame.tick);
    const std::string head = "{\"timestamp\":" + stamp(time).dump() + ",";
    std::string text = "{\"transforms\":[";
    for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
      if (frame.bodies[i].left) continue;
      const Pose pose = frame.bodies[i].pose();
      if (text.back() == '}') text.push_back(',');
      text += head + transform_heads_[i];
      fmt::format_to(std::back_inserter(text),
                     R"("translation":{{"x":{:.5f},"y":{:.5f},"z":{:.5f}}},)"
                     R"("rotation":{{"x":{:.6f},"y":{:.6f},"z":{:.6f},"w":{:.6f}}}}})",
                     pose.p.x, pose.p.y, pose.p.z, pose.q.x, pose.q.y, pose.q.z, pose.q.w);
    }
    out_.message(kTransforms, time, text + "]}");
  }

  /// Has anything come, left or changed its light by this frame?
  bool follow(const TraceFrame& frame) {
    bool changed = !begun_;
    begun_ = true;
    for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
      const std::vector<LedChange>& list = leds_[i];
      const std::size_t before = led_[i];
      while (led_[i] + 1 < list.size() && list[led_[i] + 1].tick <= frame.tick) ++led_[i];
      const bool there = !frame.bodies[i].left;
      changed = changed || led_[i] != before || there != there_[i];
      there_[i] = there;
    }
    return changed;
  }

  Json entity(std::size_t body, const Json& timestamp) const {
    Json out{{"timestamp", timestamp},
             {"frame_id", names_[body]},
             {"id", names_[body]},
             {"lifetime", stamp(0)},  // until it is deleted
             {"frame_locked", true}};
    for (const char* list : {"metadata", "arrows", "cubes", "spheres", "cylinders", "lines",
                             "triangles", "texts", "models"}) {
      out[list] = Json::array();
    }
    const auto [list, primitive] = surface(trace_.header.bodies[body], leds_[body][led_[body]].led);
    out[list].push_back(primitive);
    return out;
  }

  void put_scene(const TraceFrame& frame) {
    if (!follow(frame)) return;
    const std::uint64_t time = time_at(frame.tick);
    const Json timestamp = stamp(time);
    constexpr int kAll = 1;
    Json update;
    update["deletions"].push_back({{"timestamp", timestamp}, {"type", kAll}, {"id", ""}});
    update["entities"] = Json::array();
    for (std::size_t i = 0; i < there_.size(); ++i) {
      if (there_[i]) update["entities"].push_back(entity(i, timestamp));
    }
    out_.message(kScene, time, dumped(update));
  }

  void put_line(std::uint64_t tick, int level, const std::string& name, const std::string& text) {
    const std::uint64_t time = time_at(tick);
    out_.message(kLog, time,
                 dumped({{"timestamp", stamp(time)},
                         {"level", level},
                         {"message", text},
                         {"name", name},
                         {"file", ""},
                         {"line", 0}}));
  }

  /// Events and what programs said, up to a tick, in the order of their ticks.
  void put_log_before(std::uint64_t tick) {
    const auto& events = trace_.events;
    const auto& values = trace_.values;
    while (true) {
      const bool event = event_ < events.size() && events[event_].tick < tick;
      const bool value = value_ < values.size() && values[value_].tick < tick;
      if (event && (!value || events[event_].tick <= values[value_].tick)) {
        put_event(events[event_++]);
      } else if (value) {
        const TraceValue& said = values[value_++];
        if (said.channel == log_channel_) put_line(said.tick, kInfo, names_[said.body], said.bytes);
      } else {
        return;
      }
    }
  }

  void put_event(const TraceEvent& event) {
    const bool floor = event.event.other == kFloorId;
    const std::string other =
        floor ? "the floor" : names_[static_cast<std::uint32_t>(event.event.other)];
    put_line(event.tick, event_level(event.event.kind),
             names_[static_cast<std::uint32_t>(event.event.body)],
             event_text(event.event.kind, other));
  }

  void put_end() {
    const TraceEnd& end = trace_.end;
    const bool bad = end.why == RunEnd::diverged || end.why == RunEnd::failed;
    const std::string why = fmt::format("the run ended: {}", to_string(end.why));
    put_line(end.ticks, bad ? kError : kInfo, std::string(kWorld),
             end.message.empty() ? why : why + ": " + end.message);
  }

  const PoseTrace& trace_;
  McapWriter out_;
  std::vector<std::string> names_, transform_heads_;
  std::vector<std::vector<LedChange>> leds_;
  std::vector<std::size_t> led_;  ///< of each body, which of its changes holds
  std::vector<bool> there_;
  bool begun_ = false;
  std::uint32_t log_channel_ = 0;
  std::size_t event_ = 0, value_ = 0;
};

}  // namespace

void write_pose_mcap(const PoseTrace& trace, const std::function<bool(std::string_view)>& sink) {
  PoseMcap(trace, sink).write();
}

}  // namespace stig::view
