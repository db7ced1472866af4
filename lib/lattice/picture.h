// SPDX-License-Identifier: MIT
// Pictures of structures for papers and pages: from above and aside, with a legend of the
// bricks, drawn by cairo. The same input gives the same bytes with the same
// versions of cairo and the same fonts (DejaVu Sans).
#pragma once

#include <string>
#include <vector>

#include "lattice/rgb.h"
#include "lattice/structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

enum class PictureFormat : std::uint8_t { png, svg };

struct PictureOptions {
  PictureFormat format = PictureFormat::png;
  std::string title;    ///< above; UTF-8, empty: none
  std::string caption;  ///< below
  Palette palette = Palette::file;
  bool floor = false;  ///< draw the ground at z = 0 with shadows on it
  bool axes = true;
  bool legend = true;
  int turns = 0;            ///< of the structure before it is drawn (see view.h)
  int most_pixels = 1600;   ///< a side of the picture; at least 720 are taken
  double cell_pixels = 96;  ///< width of a cell, if the picture has room for it
  bool same_frame = true;   ///< several structures: show all in the box of all
};

/// One of several structures in a picture.
struct PicturePanel {
  const Structure* structure = nullptr;
  std::string label;  ///< under it
};

/// The most faces that an .svg is drawn with; beyond, files are too large for use.
inline constexpr std::size_t kMostSvgFaces = 200000;

/// The file's bytes; empty when cairo has no memory for it, or an .svg has too many
/// faces. `bricks` gives names and colours.
std::string draw_structure(const Structure& structure, const std::vector<Brick>& bricks,
                           const PictureOptions& options = {});

/// Several structures of one lattice side by side, row by row, on one scale.
std::string draw_structures(const std::vector<PicturePanel>& panels,
                            const std::vector<Brick>& bricks, const PictureOptions& options = {});

}  // namespace stig::lattice
