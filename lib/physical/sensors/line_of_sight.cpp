// SPDX-License-Identifier: MIT
// Tiles lie over the plane z = 1 before the camera, where straight lines from the camera are
// points. A body covers a convex region of that plane, and the rectangle about its box's corners
// encloses it. Lists of tiles are chained through one array, newest first; the answer does not
// depend on their order.
#include "physical/sensors/line_of_sight.h"

#include <algorithm>
#include <cmath>

namespace stig::physics {

namespace {

constexpr double kMargin = 1e-9;  ///< of the normalised image plane: what arithmetic may lose

std::array<Vec3, 8> box_corners(const Vec3& half) {
  std::array<Vec3, 8> out;
  for (std::size_t i = 0; i < 8; ++i) {
    out[i] = scaled(half, {i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  }
  return out;
}

// Points beside the view fall to the tiles at its border, which hold what lies there only as far as
// margins go; callers ask for points of the view.
int tile(double v, double low, double high, int count) {
  const double at = std::floor((v - low) / (high - low) * count);
  return static_cast<int>(std::clamp(at, 0.0, count - 1.0));
}

}  // namespace

Bounds frustum_bounds(const CameraView& view, const Pose& X_WC) {
  const auto corners = frustum_corners(view);
  std::vector<Vec3> points;
  points.reserve(corners.size());
  for (const Vec3& p_C : corners) points.push_back(X_WC * p_C);
  return bounds_of(points);
}

LinesOfSight::LinesOfSight(const SensorIndex& index, const CameraView& view, const Pose& X_WC)
    : index_(index),
      low_(view.low),
      high_(view.high),
      near_(view.near),
      p_WC_(X_WC.p),
      r_WC_(matrix(X_WC.q)) {
  heads_.fill(-1);
  // What stands nearer than the near plane hides as well: the bounds of frustum and camera together
  // hold the whole pyramid.
  Bounds where = frustum_bounds(view, X_WC);
  where.low = {std::min(where.low.x, p_WC_.x), std::min(where.low.y, p_WC_.y),
               std::min(where.low.z, p_WC_.z)};
  where.high = {std::max(where.high.x, p_WC_.x), std::max(where.high.y, p_WC_.y),
                std::max(where.high.z, p_WC_.z)};
  std::vector<std::uint32_t> found;
  index.obstacles.find(where, found);
  for (const std::uint32_t obstacle : found) add(obstacle);
}

int LinesOfSight::column(double x) const { return tile(x, low_.x, high_.x, kTiles); }
int LinesOfSight::row(double y) const { return tile(y, low_.y, high_.y, kTiles); }

/// All tiles for a body that reaches beside or behind the camera.
LinesOfSight::TileRange LinesOfSight::tiles_of(std::uint32_t obstacle) const {
  const SightObstacle& o = index_.scene.obstacles[obstacle];
  double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
  for (const Vec3& corner : box_corners(index_.scene.shapes[o.shape].half)) {
    const Vec3 p_C = r_WC_.transposed(o.X_WS.p + index_.axes[obstacle] * corner - p_WC_);
    // A box that reaches behind the camera has no bounded image. The threshold is above 0 since
    // images of points just before the camera exceed any bound.
    if (!(p_C.z > near_ * 0.01)) return {};
    const double x = p_C.x / p_C.z, y = p_C.y / p_C.z;
    x0 = std::min(x0, x), x1 = std::max(x1, x);
    y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
  if (x1 < low_.x - kMargin || x0 > high_.x + kMargin || y1 < low_.y - kMargin ||
      y0 > high_.y + kMargin) {
    // An empty range: the loops of add run over nothing.
    return {0, 0, -1, -1};
  }
  return {column(x0 - kMargin), row(y0 - kMargin), column(x1 + kMargin), row(y1 + kMargin)};
}

void LinesOfSight::add(std::uint32_t obstacle) {
  const SightObstacle& o = index_.scene.obstacles[obstacle];
  const TileRange range = tiles_of(obstacle);
  const auto candidate = static_cast<std::uint32_t>(candidates_.size());
  // The camera in the obstacle's frame is worked out once, as the start of all its lines.
  candidates_.push_back({obstacle, index_.axes[obstacle].transposed(p_WC_ - o.X_WS.p)});
  for (int y = range.y0; y <= range.y1; ++y) {
    for (int x = range.x0; x <= range.x1; ++x) {
      std::int32_t& head = heads_[static_cast<std::size_t>(y * kTiles + x)];
      entries_.push_back({candidate, head});
      head = static_cast<std::int32_t>(entries_.size() - 1);
    }
  }
}

bool LinesOfSight::hidden(const Vec3& p_W, std::uint32_t owner) const {
  const Vec3 way_W = p_W - p_WC_;
  const Vec3 way_C = r_WC_.transposed(way_W);
  // A point beside or behind the camera is not seen anyway.
  if (!(way_C.z > 0)) return true;
  const int x = column(way_C.x / way_C.z), y = row(way_C.y / way_C.z);
  for (std::int32_t e = heads_[static_cast<std::size_t>(y * kTiles + x)]; e >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(e)];
    e = entry.next;
    const Candidate& c = candidates_[entry.candidate];
    const SightObstacle& o = index_.scene.obstacles[c.obstacle];
    // The owner's bodies never hide its own marks: a tag stands proud of its face, and rounding
    // must not decide.
    if (o.owner == owner) continue;
    const auto meets =
        cut(index_.scene.shapes[o.shape], c.p_SC, index_.axes[c.obstacle].transposed(way_W));
    // t = 1 is the point itself: one in a surface counts as hidden by that body. in <= 0 is a body
    // that holds the camera.
    if (meets && meets->in > 0 && meets->in <= 1) return true;
  }
  return false;
}

}  // namespace stig::physics
