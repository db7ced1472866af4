// SPDX-License-Identifier: MIT
#include "view/pose_track.h"

#include <algorithm>
#include <cmath>

namespace stig::view {

namespace {

/// The longest stretch that is interpolated, in frames: what a new frame costs grows with it.
constexpr std::size_t kLongestStretch = 100;

bool same_place(const TraceState& a, const TraceState& b) {
  return a.place == b.place && a.turn == b.turn && a.left == b.left;
}

double length_of(const std::array<double, 4>& q) {
  return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

/// Is the state in the middle where interpolation has it?
bool fits(const TrackKey& first, const TrackKey& middle, const TrackKey& last,
          const TrackTolerance& tolerance) {
  const double share =
      static_cast<double>(middle.tick - first.tick) / static_cast<double>(last.tick - first.tick);
  const auto mix = [share](std::int64_t a, std::int64_t b) {
    return static_cast<double>(a) + static_cast<double>(b - a) * share;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const double at = mix(first.state.place[i], last.state.place[i]);
    const double off = std::abs(at - static_cast<double>(middle.state.place[i]));
    if (off * kPlaceQuantum > tolerance.way) return false;
  }
  std::array<double, 4> turn{}, is{};
  for (std::size_t i = 0; i < 4; ++i) {
    turn[i] = mix(first.state.turn[i], last.state.turn[i]);
    is[i] = static_cast<double>(middle.state.turn[i]);
  }
  const double scale = std::max(length_of(turn), 1.0), unit = std::max(length_of(is), 1.0);
  for (std::size_t i = 0; i < 4; ++i) {
    if (std::abs(turn[i] / scale - is[i] / unit) > tolerance.turn) return false;
  }
  return true;
}

}  // namespace

void PoseTrack::add(const TrackKey& key) {
  if (kept_.empty()) {
    kept_.push_back(key);
    return;
  }
  const bool stays = same_place(key.state, kept_.back().state);
  if (still_ && stays) {
    since_.assign(1, key);  // what rests needs its last moment alone
    return;
  }
  if (!since_.empty() && (still_ || !spans(key))) {
    kept_.push_back(since_.back());
    since_.clear();
  }
  still_ = same_place(key.state, kept_.back().state);
  since_.push_back(key);
}

bool PoseTrack::spans(const TrackKey& next) const {
  // What comes or leaves does so at once.
  if (next.state.left != since_.back().state.left || next.state.left != kept_.back().state.left ||
      since_.size() >= kLongestStretch) {
    return false;
  }
  return std::all_of(since_.begin(), since_.end(), [&](const TrackKey& middle) {
    return fits(kept_.back(), middle, next, tolerance_);
  });
}

std::vector<TrackKey> PoseTrack::finish() {
  if (!since_.empty()) kept_.push_back(since_.back());
  since_.clear();
  return std::move(kept_);
}

}  // namespace stig::view
