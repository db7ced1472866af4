// SPDX-License-Identifier: MIT
// Marks are given by kind and only poses by body: a tick writes a few numbers for each body, and
// the tables of faces are made once for a run.
#include "physical/sensors/sensor_scene.h"

#include <algorithm>
#include <array>

namespace stig::physics {

namespace {

constexpr double kObstacleCell = 0.12;  ///< m: a block touches one to four cells

/// The axes x and y of a face's tag; right × up is the normal out of the face. Tags on the sides
/// stand upright, so a robot that reads one knows which way up the block is.
struct Face {
  Vec3 right, up;
};
constexpr std::array<Face, 6> kFaces = {{{{0, 1, 0}, {0, 0, 1}},
                                         {{1, 0, 0}, {0, 0, 1}},
                                         {{0, -1, 0}, {0, 0, 1}},
                                         {{-1, 0, 0}, {0, 0, 1}},
                                         {{1, 0, 0}, {0, 1, 0}},
                                         {{1, 0, 0}, {0, -1, 0}}}};

std::vector<Bounds> obstacle_bounds(const SensorScene& scene) {
  std::vector<Bounds> out;
  out.reserve(scene.obstacles.size());
  for (const SightObstacle& o : scene.obstacles) {
    out.push_back(bounds_of(o.X_WS, scene.shapes[o.shape].half));
  }
  return out;
}

std::vector<Bounds> marked_bounds(const SensorScene& scene) {
  std::vector<Bounds> out;
  out.reserve(scene.marked.size());
  for (const MarkedBody& m : scene.marked) {
    const double r = scene.kinds[m.kind].reach;
    out.push_back({m.X_WB.p - Vec3{r, r, r}, m.X_WB.p + Vec3{r, r, r}});
  }
  return out;
}

}  // namespace

MarkedKind finish_kind(MarkedKind kind) {
  kind.reach = 0;
  for (const TagMark& t : kind.tags) {
    // Half a square's diagonal is side · 0.7071…, rounded up.
    kind.reach = std::max(kind.reach, length(t.X_BT.p) + t.side * 0.7072);
  }
  for (const LedMark& l : kind.leds) kind.reach = std::max(kind.reach, length(l.p_B));
  return kind;
}

MarkedKind cube_marks(const FaceMarks& marks) {
  MarkedKind kind;
  for (std::size_t f = 0; f < kFaces.size(); ++f) {
    const Face& face = kFaces[f];
    const Vec3 normal = cross(face.right, face.up);
    const Vec3 middle = normal * (marks.cube_side / 2);
    const Pose X_BT{middle + normal * marks.tag_proud,
                    quaternion_of({face.right, face.up, normal})};
    if (marks.tag_side > 0) {
      kind.tags.push_back({static_cast<int>(f), X_BT, marks.tag_side, marks.tag_widest});
    }
    // An offset of exactly 0, as it was written, means no LEDs.
    if (marks.led_offset == 0) continue;
    for (const Vec3& way : {face.right, face.up, -face.right, -face.up}) {
      kind.leds.push_back({middle + way * marks.led_offset, normal, marks.led_widest});
    }
  }
  return finish_kind(std::move(kind));
}

// The axes of all obstacles as matrices once: every line of sight turns vectors into their frames.
SensorIndex::SensorIndex(const SensorScene& scene_now)
    : scene(scene_now),
      obstacles(obstacle_bounds(scene_now), kObstacleCell),
      marked(marked_bounds(scene_now), kObstacleCell) {
  axes.reserve(scene.obstacles.size());
  for (const SightObstacle& o : scene.obstacles) axes.push_back(matrix(o.X_WS.q));
}

}  // namespace stig::physics
