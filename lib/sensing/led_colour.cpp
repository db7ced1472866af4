// SPDX-License-Identifier: MIT
// The robot of 2017 reads LEDs from a YUV image and tells colours apart by thresholds in its chroma
// plane alone, since brightness depends on distance and exposure. The thresholds are those of its
// camera's program (docs/sensing.md), and the colours of led_rgb lie well within them.
#include "sensing/led_colour.h"

#include <array>
#include <cassert>
#include <cmath>

namespace stig::sensing {

namespace {
constexpr double kHalfWindow = 3;  ///< pixels
}  // namespace

// ITU-R BT.601 in full range, as JPEG has it; the chroma planes are centred on 128.
Yuv to_yuv(Rgb rgb) {
  const double y = 0.299 * rgb.r + 0.587 * rgb.g + 0.114 * rgb.b;
  return {y, 128 + (rgb.b - y) / 1.772, 128 + (rgb.r - y) / 1.402};
}

std::uint8_t classify_led(double u, double v) {
  if (v > 140 && u > 140) return 1;
  if (v > 140 && u < 100) return 2;
  if (v < 110 && u < 130) return 3;
  if (v < 100 && u > 145) return 4;
  return 0;
}

Rgb led_rgb(std::uint8_t colour) {
  constexpr std::array<Rgb, 5> kColours{
      {{0, 0, 0}, {255, 120, 255}, {255, 208, 27}, {74, 255, 27}, {74, 255, 255}}};
  assert(colour < kColours.size());
  return kColours[colour];
}

void LedWindow::add(const ImagePoint& point, const Yuv& light) {
  if (!(std::abs(point.x - centre_.x) <= kHalfWindow)) return;
  if (!(std::abs(point.y - centre_.y) <= kHalfWindow)) return;
  // Chroma is weighted by luma: pixels in the dark about the LED have a chroma of 128 and would
  // draw the mean to no colour at all.
  y_ += light.y;
  yu_ += light.y * light.u;
  yv_ += light.y * light.v;
}

std::uint8_t LedWindow::colour() const {
  return y_ > 0 ? classify_led(yu_ / y_, yv_ / y_) : std::uint8_t{0};
}

}  // namespace stig::sensing
