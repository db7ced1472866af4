// SPDX-License-Identifier: MIT
// The order in which errors are drawn is a part of the outputs: a stream is one sequence, so a draw
// that is left out or added changes all that follow it in that image. Hence a probability or a
// deviation of 0 draws nothing at all, and an error that is turned on keeps the others'
// distributions but not their values.
#include "physical/sensors/camera_reading.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "sensing/gaussian.h"
#include "sensing/led_colour.h"
#include "sensing/tag_pose.h"

namespace stig::physics {

namespace {

constexpr int kTries = 32;            ///< to fit a false tag into the image
constexpr double kFalseSide = 0.024;  ///< m
// A tag that is turned away farther would hardly be decoded, so false ones are not either.
constexpr double kFalseTilt = 1.0;     ///< rad, at most
constexpr std::uint64_t kColours = 4;  ///< of false LEDs

bool happens(double probability, Random& random) {
  return probability > 0 && random.unit() < probability;
}

void blur(ImagePoint& pixel, double sigma, Random& random) {
  if (!(sigma > 0)) return;
  pixel.x += sigma * gaussian(random);
  pixel.y += sigma * gaussian(random);
}

std::optional<TagReading> tag_reading(const CameraIntrinsics& camera, int id, double side,
                                      const std::array<ImagePoint, 4>& corners) {
  const auto pose = estimate_tag_pose(camera, corners, side);
  if (!pose) return std::nullopt;
  return TagReading{id, pose->X_CT.p, pose->X_CT.q, pose->centre, corners};
}

double blurred(double value, double sigma, Random& random) {
  if (!(sigma > 0)) return value;
  return std::clamp(value + sigma * gaussian(random), 0.0, 255.0);
}

LedReading led_reading(ImagePoint pixel, Rgb rgb, const CameraNoise& noise, Random& random) {
  blur(pixel, noise.pixel, random);
  const Yuv light = to_yuv(rgb);
  const double y = blurred(light.y, noise.colour, random);
  const double u = blurred(light.u, noise.colour, random);
  return {pixel, y, u, blurred(light.v, noise.colour, random)};
}

// Pixel centres are whole numbers, so the image begins at -0.5.
ImagePoint somewhere(const CameraIntrinsics& camera, Random& random) {
  const double x = random.unit() * camera.width - 0.5;
  return {x, random.unit() * camera.height - 0.5};
}

/// The corners of a tag that might hang anywhere in the frustum, turned by at most kFalseTilt.
std::optional<std::array<ImagePoint, 4>> false_corners(const CameraView& view, Random& random) {
  const auto way = unproject(view.intrinsics, somewhere(view.intrinsics, random));
  const double depth = view.near + (view.far - view.near) * random.unit();
  // A half turn about x makes the tag look into the camera, whose z axis leads away from it; then
  // it is tilted about an axis in its plane and turned about its normal.
  const double axis = 2 * std::numbers::pi * random.unit(), tilt = kFalseTilt * random.unit();
  const Quat q_CT = Quat{0, 1, 0, 0} * rotation(Vec3{std::cos(axis), std::sin(axis), 0} * tilt) *
                    rotation({0, 0, 2 * std::numbers::pi * random.unit()});
  // Tested last, for a false tag takes the same draws whether or not its middle can be unprojected.
  if (!way) return std::nullopt;
  std::array<ImagePoint, 4> out;
  const auto places = tag_corners(kFalseSide);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto pixel = image_of(view, Pose{*way * depth, q_CT} * places[i]);
    if (!pixel) return std::nullopt;
    out[i] = *pixel;
  }
  return out;
}

void add_false_tag(const CameraView& view, Random& random, CameraReading& out) {
  // Near the border a corner may fall outside, which no detector would report. The tries are
  // bounded: a narrow frustum may have hardly any room for a tag.
  for (int i = 0; i < kTries; ++i) {
    const auto corners = false_corners(view, random);
    if (!corners) continue;
    const int id = static_cast<int>(random.below(kTagIds));
    const auto tag = tag_reading(view.intrinsics, id, kFalseSide, *corners);
    if (tag) out.tags.push_back(*tag);
    return;
  }
}

}  // namespace

CameraReading read_camera(const SensorScene& scene, const CameraSight& sight,
                          const CameraView& view, const CameraNoise& noise,
                          const NoiseAddress& address) {
  Random random = noise_stream(address);
  CameraReading out;
  out.enabled = true;
  out.tags.reserve(sight.tags.size());
  out.leds.reserve(sight.leds.size());
  for (const SeenTag& seen : sight.tags) {
    // What is missed is drawn for each tag before its pixels are, tag by tag.
    if (happens(noise.missed_tags, random)) continue;
    const TagMark& tag = scene.kinds[scene.marked[seen.body].kind].tags[seen.tag];
    auto corners = seen.corners;
    for (ImagePoint& pixel : corners) blur(pixel, noise.pixel, random);
    // A pose comes from the blurred pixels alone. Its errors are thus those that a real estimate
    // has: along the line of sight and in tilt far more than across.
    const auto reading = tag_reading(view.intrinsics, tag.id, tag.side, corners);
    if (reading) out.tags.push_back(*reading);
  }
  for (const SeenLed& seen : sight.leds) {
    if (happens(noise.missed_leds, random)) continue;
    const Rgb rgb = scene.marked[seen.body].leds[seen.led];
    out.leds.push_back(led_reading(seen.pixel, rgb, noise, random));
  }
  if (happens(noise.false_tags, random)) add_false_tag(view, random, out);
  if (happens(noise.false_leds, random)) {
    // Colour 0 is unlit, which is not reported.
    const auto colour = static_cast<std::uint8_t>(1 + random.below(kColours));
    const ImagePoint pixel = somewhere(view.intrinsics, random);
    out.leds.push_back(led_reading(pixel, led_rgb(colour), noise, random));
  }
  return out;
}

}  // namespace stig::physics
