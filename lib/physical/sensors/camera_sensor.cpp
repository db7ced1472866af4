// SPDX-License-Identifier: MIT
// Tests run from cheap to dear: the grid of bodies, a ball about the body, the angle of each mark,
// its projection, and last the lines of sight. A scene has far more marks than a camera sees at
// once.
#include "physical/sensors/camera_sensor.h"

#include <cmath>
#include <optional>

#include "physical/sensors/line_of_sight.h"
#include "sensing/tag_pose.h"

namespace stig::physics {

namespace {

// A mark exactly at its limit is seen, as the rule says; without this, rounding would decide, and
// decide differently where poses differ in the last bit.
constexpr double kOnLimit = 1e-12;  ///< of a cosine: what arithmetic may lose

/// A camera while it looks.
struct Looking {
  const SensorIndex& index;
  const CameraView& view;
  Pose X_CW;
  Vec3 p_WC;
  LinesOfSight lines;
};

/// Whether a ball may reach into the frustum; it may say yes for a ball beside a corner, never no
/// wrongly. A plane of the frustum through the camera is x = slope · z; a point's distance to it is
/// (x - slope · z) / sqrt(1 + slope²).
bool may_be_seen(const CameraView& v, const Vec3& p, double r) {
  const auto beside = [&](double along, double slope) {
    // A ball of radius r stays clear of the plane if its centre is farther out than r.
    return along > slope * p.z + r * std::sqrt(1 + slope * slope);
  };
  return p.z + r >= v.near && p.z - r <= v.far && !beside(p.x, v.high.x) &&
         !beside(-p.x, -v.low.x) && !beside(p.y, v.high.y) && !beside(-p.y, -v.low.y);
}

/// `way` leads from the mark to the camera; both in one frame.
bool faces(const Vec3& normal, const Vec3& way, double widest) {
  // Compares cosines, which needs no arc cosine and no unit vector; cos falls from 0 to pi, so
  // limits up to pi are sound.
  return dot(normal, way) >= (std::cos(widest) - kOnLimit) * length(way);
}

std::optional<std::array<ImagePoint, 4>> corners_seen(const Looking& l, const Pose& X_WT,
                                                      double side, std::uint32_t owner) {
  std::array<ImagePoint, 4> out;
  std::array<Vec3, 4> places = tag_corners(side);
  for (std::size_t i = 0; i < 4; ++i) {
    places[i] = X_WT * places[i];
    // Projection first: it costs some multiplications, a line of sight a walk along a tile's
    // bodies.
    const auto pixel = image_of(l.view, l.X_CW * places[i]);
    if (!pixel) return std::nullopt;
    out[i] = *pixel;
  }
  for (const Vec3& p_W : places) {
    if (l.lines.hidden(p_W, owner)) return std::nullopt;
  }
  return out;
}

void look_at_tags(const Looking& l, std::uint32_t body, const Vec3& p_BC, CameraSight& sight) {
  const MarkedBody& marked = l.index.scene.marked[body];
  const auto& tags = l.index.scene.kinds[marked.kind].tags;
  for (std::uint32_t i = 0; i < tags.size(); ++i) {
    const TagMark& tag = tags[i];
    // The normal of a tag is its z axis, see sensing/tag_pose.h. The angle is measured at the tag's
    // middle alone, though near a large tag its corners have other ones.
    if (!faces(matrix(tag.X_BT.q).z, p_BC - tag.X_BT.p, tag.widest)) continue;
    const auto corners = corners_seen(l, marked.X_WB * tag.X_BT, tag.side, marked.owner);
    if (corners) sight.tags.push_back({body, i, *corners});
  }
}

void look_at_leds(const Looking& l, std::uint32_t body, const Vec3& p_BC, CameraSight& sight) {
  const MarkedBody& marked = l.index.scene.marked[body];
  const auto& leds = l.index.scene.kinds[marked.kind].leds;
  // A body may state fewer LEDs than its kind has: missing ones are unlit.
  for (std::uint32_t i = 0; i < leds.size() && i < marked.leds.size(); ++i) {
    if (marked.leds[i] == Rgb{}) continue;
    if (!faces(leds[i].normal_B, p_BC - leds[i].p_B, leds[i].widest)) continue;
    const Vec3 p_W = marked.X_WB * leds[i].p_B;
    const auto pixel = image_of(l.view, l.X_CW * p_W);
    if (pixel && !l.lines.hidden(p_W, marked.owner)) sight.leds.push_back({body, i, *pixel});
  }
}

}  // namespace

CameraSight look(const SensorIndex& index, const CameraView& view, const Pose& X_WC) {
  const Looking l{index, view, inverse(X_WC), X_WC.p, LinesOfSight(index, view, X_WC)};
  std::vector<std::uint32_t> found;
  // Rising body numbers, so that readings come in the same order however the grid is laid out.
  index.marked.find(frustum_bounds(view, X_WC), found);
  CameraSight sight;
  for (const std::uint32_t body : found) {
    const MarkedBody& marked = index.scene.marked[body];
    if (!may_be_seen(view, l.X_CW * marked.X_WB.p, index.scene.kinds[marked.kind].reach)) continue;
    // Angles are compared in the body's frame: one point is transformed instead of each mark.
    const Vec3 p_BC = inverse(marked.X_WB) * l.p_WC;
    look_at_tags(l, body, p_BC, sight);
    look_at_leds(l, body, p_BC, sight);
  }
  return sight;
}

}  // namespace stig::physics
