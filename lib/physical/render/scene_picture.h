// SPDX-License-Identifier: MIT
// Pictures of bodies on a floor, seen in perspective: plain shading, edges, shadows on the
// floor, a grid with a scale, the LEDs of blocks on their faces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physical/collision/contact.h"
#include "physical/render/raster.h"
#include "physical/render/solid_faces.h"
#include "physical/render/uses.h"
#include "physical/robots/led.h"
#include "sensing/camera.h"

namespace stig::physics {

struct PictureBody {
  Shape shape;
  Pose X_WB;
  Rgb colour{176, 180, 186};
  bool block = false;  ///< tags and LEDs on its faces
  Led led = Led::off;
  std::vector<SolidFace> faces = {};  ///< drawn in place of the shape's, if there are any
  std::optional<Rgb> glow = {};       ///< of LEDs that are lit; otherwise as rgb_of has it
};

/// A straight mark: `width` in pixels, drawn as if nearer by the share `bias`.
struct PictureLine {
  Vec3 from, to;
  double width = 1;
  Rgb colour;
  double bias = 0;
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

/// Points about bodies, for the view and the floor; of those a long way off from the others (what
/// has rolled away) no account is taken. Those of several moments together are what one view of
/// all of them is about.
std::vector<Vec3> points_about(const std::vector<PictureBody>& bodies);

/// The view from a direction that holds all points.
PictureView view_holding(const std::vector<Vec3>& points, const PictureLook& look);
/// The view that holds all bodies now.
PictureView fitted_view(const std::vector<PictureBody>& bodies, const PictureLook& look);

/// How far the floor reaches, and its grid.
struct PictureFloor {
  Vec3 low, high;   ///< of what stands on it
  double grid = 0;  ///< m between lines
};
PictureFloor floor_under(const std::vector<Vec3>& points);

struct ScenePicture {
  Image image;
  double grid = 0;  ///< m between lines
};
inline constexpr Rgb kBackdrop{250, 251, 252};
Image draw_bodies(const std::vector<PictureBody>& bodies, const PictureView& view,
                  const std::optional<PictureFloor>& floor,
                  const std::vector<PictureLine>& lines = {});

/// Takes up what is painted, in pixels as of RasterPoint: convex polygons, shadows on the floor,
/// and lines so many pixels wide.
class PictureSink {
 public:
  virtual ~PictureSink() = default;
  virtual void polygon(const std::vector<RasterPoint>& corners, Rgb colour) = 0;
  virtual void shadow(const std::vector<RasterPoint>& corners, double darkness) = 0;
  virtual void line(const RasterPoint& from, const RasterPoint& to, double width, Rgb colour,
                    double bias) = 0;
};
/// Floor, shadows, bodies in the order in which they are given, then lines. One that knows no depth
/// wants the painting_order.
void paint_bodies(PictureSink& sink, const std::vector<PictureBody>& bodies,
                  const PictureView& view, const std::optional<PictureFloor>& floor,
                  const std::vector<PictureLine>& lines);
/// With the floor under the bodies as they stand, if there is one.
ScenePicture draw_bodies(const std::vector<PictureBody>& bodies, const PictureView& view,
                         bool floor, const std::vector<PictureLine>& lines = {});

/// A PNG file with a caption in its lower left corner, in letters that fit its width; empty when
/// there is no memory for it.
std::string png_of(const Image& image, const std::string& caption);

}  // namespace stig::physics
