// SPDX-License-Identifier: MIT
// How a body moved, as the few moments between which it can be interpolated.
//
// A trace has a frame every 20 ms. Of these only such are kept that no frame left out is farther
// than a tolerance from where linear interpolation of place and (normalised) quaternion has it.
#pragma once

#include <vector>

#include "physical/trace/pose_trace.h"
#include "view/uses.h"

namespace stig::view {

struct TrackKey {
  std::uint64_t tick = 0;
  TraceState state;
};

struct TrackTolerance {
  double way = 1e-4;     ///< m, along each axis
  double turn = 1.5e-3;  ///< of each part of the quaternion: 0.17° of rotation
};

/// Thins the states of one body as they come.
class PoseTrack {
 public:
  explicit PoseTrack(const TrackTolerance& tolerance = {}) : tolerance_(tolerance) {}

  /// Ticks rise.
  void add(const TrackKey& key);
  /// The moments that are kept: the first and the last are among them.
  std::vector<TrackKey> finish();

 private:
  bool spans(const TrackKey& next) const;

  TrackTolerance tolerance_;
  std::vector<TrackKey> kept_;
  std::vector<TrackKey> since_;  ///< those after the last one kept
  bool still_ = true;            ///< are all of since_ as the last one kept?
};

}  // namespace stig::view
