// SPDX-License-Identifier: MIT
// Which of the block's colours an LED shows, as the robot's program tells it from the planes of
// its camera's image: the mean of U and V in a window of six by six pixels, weighted with the
// luminance, against the thresholds of the real camera (the authors' published parameters of
// Allwright et al. 2017, TR/IRIDIA/2017-003).
//
//     Q1 V > 140, U > 140    Q2 V > 140, U < 100    Q3 V < 110, U < 130    Q4 V < 100, U > 145
//
// What is in none of them is 0, off.
#pragma once

#include <cstdint>

#include "base/rgb.h"
#include "sensing/camera.h"

namespace stig::sensing {

/// Planes of an image, each 0 to 255; U and V about 128.
struct Yuv {
  double y = 0, u = 128, v = 128;
};
/// ITU-R BT.601, full range.
Yuv to_yuv(Rgb rgb);

/// 1 to 4 for Q1 to Q4, 0 for anything else.
std::uint8_t classify_led(double u, double v);

/// The light of a block's LEDs that show a colour 0 (dark) to 4.
Rgb led_rgb(std::uint8_t colour);

/// A window of 6 × 6 pixels about a point, and the light that falls into it.
class LedWindow {
 public:
  explicit LedWindow(const ImagePoint& centre) : centre_(centre) {}
  /// Counted when it is inside.
  void add(const ImagePoint& point, const Yuv& light);
  std::uint8_t colour() const;

 private:
  ImagePoint centre_;
  double y_ = 0, yu_ = 0, yv_ = 0;
};

}  // namespace stig::sensing
