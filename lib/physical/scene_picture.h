// SPDX-License-Identifier: MIT
// Pictures of bodies on a floor, seen in perspective: plain shading, edges, shadows on the
// floor, a grid with a scale, the LEDs of blocks on their faces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physical/contact.h"
#include "physical/led.h"
#include "physical/raster.h"
#include "sensing/camera.h"

namespace stig {

struct PictureBody {
  Shape shape;
  Pose X_WB;
  Rgb colour{176, 180, 186};
  bool block = false;  ///< tags and LEDs on its faces
  Led led = Led::off;
};

/// An eye: where it is and what it sees. Camera frame: z ahead, x right, y down.
struct PictureView {
  Pose X_WC;
  CameraIntrinsics camera;
};

struct PictureLook {
  int width = 1200, height = 800;  ///< pixels
  double azimuth = -1.05;          ///< rad, of the eye about the bodies, from the x axis
  double elevation = 0.42;         ///< rad, above the floor
  bool floor = true;
};

/// The view from a direction that holds all bodies; of those a long way off from the others
/// (what has rolled away) no account is taken.
PictureView fitted_view(const std::vector<PictureBody>& bodies, const PictureLook& look);

struct ScenePicture {
  Image image;
  double grid = 0;  ///< m between lines
};
ScenePicture draw_bodies(const std::vector<PictureBody>& bodies, const PictureView& view,
                         bool floor);

/// A PNG file with a caption in its lower left corner; empty when there is no memory for it.
std::string png_of(const Image& image, const std::string& caption);

}  // namespace stig
