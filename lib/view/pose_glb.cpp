// SPDX-License-Identifier: MIT
#include "view/pose_glb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <set>

#include "base/glb.h"
#include "base/text.h"
#include "physical/render/solid_faces.h"
#include "physical/trace/pose_frames.h"
#include "view/pose_track.h"
#include "view/trace_picture.h"

namespace stig::view {

namespace {

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Of the surface that a body has to be looked at, or of its shape.
std::vector<SolidFace> seen_faces(const TraceBody& body) {
  if (!body.visual) return faces_of(body.shape);
  std::vector<SolidFace> out;
  for (const auto& [a, b, c] : body.visual->triangles) {
    const auto& points = body.visual->points;
    const Vec3 across = cross(points[b] - points[a], points[c] - points[a]);
    // Without area it has no normal, and nothing to be seen.
    if (!(squared(across) > 0)) continue;
    out.push_back({{points[a], points[b], points[c]}, normalised(across), false});
  }
  return out;
}

GlbPrimitive surface_of(const TraceBody& body, Led led, const PoseLook& look) {
  GlbPrimitive out;
  const bool lit = body.block && led != Led::off;
  const auto glow = [&] { return look.glow ? look.glow(led) : rgb_of(led); };
  out.rgb = lit ? blend(body.rgb, glow(), 0.6) : body.rgb;
  out.material = to_color(out.rgb);
  for (const SolidFace& face : seen_faces(body)) {
    const std::uint32_t first = out.vertices;
    for (const Vec3& corner : face.corners) out.add_vertex(floats(corner), floats(face.normal));
    // Faces are convex: a fan of triangles fills them.
    for (std::uint32_t i = 2; i < face.corners.size(); ++i) {
      out.add_triangle(first, first + i - 1, first + i);
    }
  }
  return out;
}

/// From a tick on: whether it is there.
struct Presence {
  std::uint64_t tick = 0;
  bool there = false;
};

struct BodyTrack {
  std::vector<TrackKey> keys;
  std::vector<Presence> presences;
};

/// The tracks of all bodies within the span; ticks are of the run. Whether they are shown follows
/// from every frame: between two keys a body may come into what is shown and leave it.
std::vector<BodyTrack> tracks_of(const PoseTrace& trace, std::uint64_t first, std::uint64_t last,
                                 const PoseLook& look) {
  std::vector<PoseTrack> tracks(trace.header.bodies.size());
  std::vector<BodyTrack> out(tracks.size());
  const auto add = [&](const TraceFrame& frame, std::uint64_t tick) {
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      const TraceState& state = frame.bodies[i];
      tracks[i].add({tick, state});
      const bool there = !state.left && (!look.shown || look.shown(state.pose().p));
      std::vector<Presence>& list = out[i].presences;
      if (list.empty() || list.back().there != there) list.push_back({tick, there});
    }
  };
  add(frame_at(trace, first), first);
  for_each_frame(trace, [&](const TraceFrame& frame) {
    if (frame.tick > first && frame.tick <= last) add(frame, frame.tick);
  });
  for (std::size_t i = 0; i < tracks.size(); ++i) out[i].keys = tracks[i].finish();
  return out;
}

/// Ticks of the run as seconds of the animation.
struct Clock {
  std::uint64_t first = 0;
  double step = 0, speed = 1;

  float at(std::uint64_t tick) const {
    return static_cast<float>(static_cast<double>(tick - first) * step / speed);
  }
};

/// Place and turn between the keys.
GlbMotion movement(const std::vector<TrackKey>& keys, const Clock& clock) {
  GlbMotion out;
  for (const TrackKey& key : keys) {
    out.times.push_back(clock.at(key.tick));
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
GlbMotion presence(const std::vector<Presence>& list, const Clock& clock) {
  GlbMotion out;
  out.stepped = true;
  for (const Presence& one : list) {
    const float scale = one.there ? 1 : 0;
    out.times.push_back(clock.at(one.tick));
    out.scales.push_back({scale, scale, scale});
  }
  return out;
}

/// When a block shows a colour.
std::vector<Presence> shows(const std::vector<LedChange>& changes, Led led) {
  std::vector<Presence> out;
  for (const LedChange& change : changes) out.push_back({change.tick, change.led == led});
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
  Clock clock;
  std::vector<GlbNode> nodes = {};
  std::vector<GlbMotion> motions = {};

  /// Returns its number.
  int add(GlbNode node, std::vector<GlbMotion> wanted) {
    for (GlbMotion& motion : wanted) {
      motion.node = nodes.size();
      if (!is_still(motion)) motions.push_back(std::move(motion));
    }
    nodes.push_back(std::move(node));
    return static_cast<int>(nodes.size() - 1);
  }

  void add_body(const TraceBody& body, const BodyTrack& track,
                const std::vector<LedChange>& changes, const PoseLook& look) {
    GlbNode node;
    node.name = printable(body.name);
    node.X_PN = track.keys.front().state.pose();
    node.parent = 0;
    std::set<Led> leds;
    for (const LedChange& change : changes) leds.insert(change.led);
    if (leds.size() == 1) {
      GlbPrimitive surface = surface_of(body, *leds.begin(), look);
      // Pieces of a solid, the surface of which is another's, show nothing.
      if (surface.vertices > 0) node.primitives.push_back(std::move(surface));
    }
    const int number =
        add(std::move(node), {movement(track.keys, clock), presence(track.presences, clock)});
    if (leds.size() == 1) return;
    for (const Led led : leds) {
      GlbNode one;
      one.name = fmt::format("{} {}", printable(body.name), to_string(led));
      one.parent = number;
      one.primitives.push_back(surface_of(body, led, look));
      add(std::move(one), {presence(shows(changes, led), clock)});
    }
  }
};

bool is_nowhere(const std::vector<Presence>& list) {
  return std::none_of(list.begin(), list.end(), [](const Presence& one) { return one.there; });
}

}  // namespace

std::string pose_glb(const PoseTrace& trace, const PoseSpan& span, const PoseLook& look) {
  assert(span.speed > 0 && span.from <= span.to);
  const double step = trace.header.step;
  const auto tick_at = [&](double time) {
    return std::min(trace.end.ticks, static_cast<std::uint64_t>(std::llround(time / step)));
  };
  const std::uint64_t first = tick_at(span.from), last = tick_at(span.to);
  const std::vector<BodyTrack> tracks = tracks_of(trace, first, last, look);
  const auto changes = led_changes(trace, first, last);
  Nodes out{{first, step, span.speed}};
  // The world has z up, the file y.
  GlbNode root;
  root.name = printable(trace.header.title.empty() ? "run" : trace.header.title);
  root.X_PN.q = rotation({-std::numbers::pi / 2, 0, 0});
  out.add(std::move(root), {});
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (is_nowhere(tracks[i].presences)) continue;
    out.add_body(trace.header.bodies[i], tracks[i], changes[i], look);
  }
  return glb_file(out.nodes, out.motions);
}

}  // namespace stig::view
