// SPDX-License-Identifier: MIT
#include "view/pose_glb.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/glb.h"
#include "base/text.h"
#include "physical/trace/pose_frames.h"
#include "view/pose_track.h"
#include "view/trace_picture.h"

namespace stig::view {

namespace {

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

GlbPrimitive surface_of(const PictureBody& body) {
  GlbPrimitive out;
  const bool lit = body.block && body.led != Led::off;
  out.rgb = lit ? blend(body.colour, rgb_of(body.led), 0.6) : body.colour;
  out.material = to_color(out.rgb);
  for (const SolidFace& face : faces_of(body.shape)) {
    const std::uint32_t first = out.vertices;
    for (const Vec3& corner : face.corners) out.add_vertex(floats(corner), floats(face.normal));
    // Faces are convex: a fan of triangles fills them.
    for (std::uint32_t i = 2; i < face.corners.size(); ++i) {
      out.add_triangle(first, first + i - 1, first + i);
    }
  }
  return out;
}

/// The tracks of all bodies within the span; ticks are of the run.
std::vector<std::vector<TrackKey>> tracks_of(const PoseTrace& trace, std::uint64_t first,
                                             std::uint64_t last) {
  std::vector<PoseTrack> tracks(trace.header.bodies.size());
  const auto add = [&](const TraceFrame& frame, std::uint64_t tick) {
    for (std::size_t i = 0; i < tracks.size(); ++i) tracks[i].add({tick, frame.bodies[i]});
  };
  add(frame_at(trace, first), first);
  for_each_frame(trace, [&](const TraceFrame& frame) {
    if (frame.tick > first && frame.tick <= last) add(frame, frame.tick);
  });
  std::vector<std::vector<TrackKey>> out;
  for (PoseTrack& track : tracks) out.push_back(track.finish());
  return out;
}

/// Place and turn between the keys.
GlbMotion movement(const std::vector<TrackKey>& keys, const std::vector<float>& times) {
  GlbMotion out;
  out.times = times;
  for (const TrackKey& key : keys) {
    const Pose pose = key.state.pose();
    // A trace may hold a turn of nothing but zeros for what is nowhere.
    const Quat q = std::isfinite(pose.q.w) ? pose.q : Quat{};
    out.translations.push_back(floats(pose.p));
    out.rotations.push_back({static_cast<float>(q.x), static_cast<float>(q.y),
                             static_cast<float>(q.z), static_cast<float>(q.w)});
  }
  return out;
}

/// There, or not.
GlbMotion presence(const std::vector<TrackKey>& keys, const std::vector<float>& times) {
  GlbMotion out;
  out.stepped = true;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool same = i > 0 && keys[i].state.left == keys[i - 1].state.left;
    if (same) continue;
    const float scale = keys[i].state.left ? 0 : 1;
    out.times.push_back(times[i]);
    out.scales.push_back({scale, scale, scale});
  }
  return out;
}

/// Is it the same all the time, and so what the node has already?
bool is_still(const GlbMotion& motion) {
  const auto same = [](const auto& values) {
    return std::all_of(values.begin(), values.end(),
                       [&](const auto& value) { return value == values.front(); });
  };
  return same(motion.translations) && same(motion.rotations) && same(motion.scales);
}

struct Nodes {
  std::vector<GlbNode> nodes;
  std::vector<GlbMotion> motions;

  void add(const std::string& name, const PictureBody& look, const std::vector<TrackKey>& keys,
           const std::vector<float>& times) {
    std::vector<GlbMotion> wanted = {movement(keys, times), presence(keys, times)};
    GlbNode node;
    node.name = printable(name);
    node.primitives.push_back(surface_of(look));
    node.X_PN = keys.front().state.pose();
    node.parent = 0;
    for (GlbMotion& motion : wanted) {
      motion.node = nodes.size();
      if (!is_still(motion)) motions.push_back(std::move(motion));
    }
    nodes.push_back(std::move(node));
  }
};

bool is_nowhere(const std::vector<TrackKey>& keys) {
  return std::all_of(keys.begin(), keys.end(), [](const auto& key) { return key.state.left; });
}

}  // namespace

std::string pose_glb(const PoseTrace& trace, const PoseSpan& span) {
  assert(span.speed > 0 && span.from <= span.to);
  const double step = trace.header.step;
  const auto tick_at = [&](double time) {
    return std::min(trace.end.ticks, static_cast<std::uint64_t>(std::llround(time / step)));
  };
  const std::uint64_t first = tick_at(span.from);
  const auto tracks = tracks_of(trace, first, tick_at(span.to));
  const std::vector<PictureBody> looks = last_looks(trace);
  Nodes out;
  // The world has z up, the file y.
  GlbNode root;
  root.name = printable(trace.header.title.empty() ? "run" : trace.header.title);
  root.X_PN.q = rotation({-std::numbers::pi / 2, 0, 0});
  out.nodes.push_back(std::move(root));
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (is_nowhere(tracks[i])) continue;
    std::vector<float> times;
    for (const TrackKey& key : tracks[i]) {
      const double seconds = static_cast<double>(key.tick - first) * step / span.speed;
      times.push_back(static_cast<float>(seconds));
    }
    out.add(trace.header.bodies[i].name, looks[i], tracks[i], times);
  }
  return glb_file(out.nodes, out.motions);
}

}  // namespace stig::view
