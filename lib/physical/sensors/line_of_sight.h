// SPDX-License-Identifier: MIT
// Whether a body stands between a camera and a point.
//
// All lines of a camera start in one point, so bodies are sorted once by where they appear:
// a raster of tiles over the view, each with the bodies that it may show. A line asks those
// of its tile alone. A body that holds the camera itself hides nothing: it is what the camera
// is mounted on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "physical/sensors/sensor_scene.h"
#include "physical/sensors/uses.h"
#include "sensing/camera_view.h"

namespace stig::physics {

class LinesOfSight {
 public:
  LinesOfSight(const SensorIndex& index, const CameraView& view, const Pose& X_WC);

  /// Whether a body hides this point of the view, others than those of `owner`. A body's surface
  /// belongs to it; points of a body are hidden by it.
  bool hidden(const Vec3& p_W, std::uint32_t owner) const;

 private:
  static constexpr int kTiles = 16;

  /// Bodies before the camera, and the camera in their frames.
  struct Candidate {
    std::uint32_t obstacle;
    Vec3 p_SC;
  };
  struct Entry {
    std::uint32_t candidate;
    std::int32_t next;
  };
  struct TileRange {
    int x0 = 0, y0 = 0, x1 = kTiles - 1, y1 = kTiles - 1;
  };

  int column(double x) const;
  int row(double y) const;
  TileRange tiles_of(std::uint32_t obstacle) const;
  void add(std::uint32_t obstacle);

  const SensorIndex& index_;
  Vec3 low_, high_;
  double near_ = 0;
  Vec3 p_WC_;
  Mat3 r_WC_;
  std::vector<Candidate> candidates_;
  std::array<std::int32_t, std::size_t{kTiles} * kTiles> heads_;
  std::vector<Entry> entries_;
};

/// About the camera's frustum, world frame.
Bounds frustum_bounds(const CameraView& view, const Pose& X_WC);

}  // namespace stig::physics
