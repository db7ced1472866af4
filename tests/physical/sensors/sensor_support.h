// SPDX-License-Identifier: MIT
// Scenes for sensors. The camera stands in the world's origin and looks along z, unless said
// otherwise, so that its frame is the world's.
#pragma once

#include <doctest/doctest.h>

#include "base/degree.h"
#include "physical/sensors/camera_reading.h"
#include "physical/sensors/sensor_scene.h"
#include "sensing/camera_view.h"
#include "support/uses.h"

namespace stig {

/// Turns a mark towards a camera that looks along z; x stays to the right.
inline constexpr Quat kFacing{0, 1, 0, 0};
inline constexpr Rgb kPink{255, 120, 255};

inline CameraView paper_view() {
  CameraIntrinsics c;
  c.fx = c.fy = 883.961;
  c.cx = 319.5;
  c.cy = 179.5;
  const auto view = make_view(c, 0.05, 0.5);
  REQUIRE(view);
  return *view;
}

inline FaceMarks paper_marks() {
  FaceMarks marks;
  marks.tag_widest = marks.led_widest = 75 * kDegree;
  return marks;
}

/// A single mark in its body's origin, normal along the body's z.
inline SensorScene one_tag(const Pose& X_WT, double side, double widest) {
  SensorScene scene;
  scene.kinds = {finish_kind({{{7, {}, side, widest}}, {}, 0})};
  scene.marked = {{0, 1, X_WT, {}}};
  return scene;
}
inline SensorScene one_led(const Pose& X_WL, double widest) {
  SensorScene scene;
  scene.kinds = {finish_kind({{}, {{{}, {0, 0, 1}, widest}}, 0})};
  scene.marked = {{0, 1, X_WL, {kPink}}};
  return scene;
}

/// Adds a body of its own owner, 2 unless said otherwise.
inline void hide_behind(SensorScene& scene, SightShape shape, const Pose& X_WS,
                        std::uint32_t owner = 2) {
  scene.shapes.push_back(std::move(shape));
  scene.obstacles.push_back({static_cast<std::uint32_t>(scene.shapes.size() - 1), owner, X_WS});
}

inline CameraSight sight_of(const SensorScene& scene, const Pose& X_WC = {}) {
  return look(SensorIndex(scene), paper_view(), X_WC);
}
inline bool sees_tag(const SensorScene& scene) { return sight_of(scene).tags.size() == 1; }
inline bool sees_led(const SensorScene& scene) { return sight_of(scene).leds.size() == 1; }

/// Adds a block of the paper, lit in one colour.
inline void add_block(SensorScene& scene, const Pose& X_WB, std::uint32_t owner,
                      Rgb colour = kPink) {
  if (scene.kinds.empty()) {
    scene.kinds = {cube_marks(paper_marks())};
    scene.shapes = {sight_box({0.055, 0.055, 0.055})};
  }
  scene.obstacles.push_back({0, owner, X_WB});
  scene.marked.push_back({0, owner, X_WB, std::vector<Rgb>(24, colour)});
}

/// As robots carry it: 45 degrees down, at this height, ahead along world x turned by `yaw`.
inline Pose tilted_camera(const Vec3& p_W, double yaw) {
  const Quat level = Quat{0.5, -0.5, 0.5, -0.5};  // z ahead along x, x to the right, y down
  return {p_W, rotation({0, 0, yaw}) * level * rotation({-45 * kDegree, 0, 0})};
}

}  // namespace stig
