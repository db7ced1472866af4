// SPDX-License-Identifier: MIT
// Pictures of one structure as it grows, for films and figures: all of one size and from one
// camera, framed for the whole that the structure grows to, so that nothing moves from one to the
// next but bricks that come.
#pragma once

#include <string>
#include <vector>

#include "lattice/canvas.h"
#include "lattice/picture.h"
#include "lattice/picture_marks.h"
#include "lattice/picture_scene.h"
#include "lattice/uses.h"

namespace stig::lattice {

struct RunPictureOptions {
  PictureFormat format = PictureFormat::png;
  int width = 1200, height = 800;  ///< pixels; of an .svg only their ratio counts
  std::string title;               ///< above; UTF-8, empty: none
  Palette palette = Palette::file;
  bool floor = false;  ///< draw the ground at z = 0 with shadows on it
  bool ghost = false;  ///< draw what is still to come as if of glass
  bool legend = true;  ///< and axes
  double azimuth = 0;  ///< rad, see camera_at
  double elevation = 0;
  bool orbit = false;  ///< the camera goes round: the frame holds the structure in every turn
};

class RunPictures {
 public:
  /// `whole` has every brick that will be drawn.
  RunPictures(Structure whole, const std::vector<Brick>& bricks, RunPictureOptions options);

  /// The file's bytes; empty when cairo has no memory for it, or an .svg has too many faces. `now`
  /// is part of the whole; the caption stands below. `turn` is added to the azimuth, rad, and is 0
  /// unless the camera goes round.
  std::string draw(const Structure& now, const std::string& caption, double turn = 0) const;

 private:
  struct Round {
    Point pivot;  ///< on the ground
    double radius = 0, low = 0, high = 0;
  };
  LatticeCamera camera(double turn) const;
  void find_round();
  PictureFrame frame_from(const LatticeCamera& camera) const;
  void draw_marks(Canvas& canvas, const Structure& now, const LatticeCamera& camera) const;

  Structure whole_;
  std::vector<Brick> bricks_;
  RunPictureOptions options_;
  PageSize page_;
  ColourCounts counts_;  ///< of the whole
  PictureScene stage_;   ///< of the whole, whose frame and ground all pictures have
  Round round_;          ///< a cylinder about it and its ground
  std::vector<PagePoint> legend_places_;
  double drawing_top_ = 0, legend_top_ = 0, caption_base_ = 0;
};

}  // namespace stig::lattice
