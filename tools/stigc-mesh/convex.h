// SPDX-License-Identifier: MIT
// What physics needs of a model: convex pieces that together are about as large, and the mass
// properties of the model itself.
//
// The box about the model is cut by planes along its axes, where that takes most of what the hulls
// of the parts have too much, and each piece is the hull of what of the model lies in a cell. Cells
// are boxes and nothing is made of surfaces but lists of places, so that models whose faces cross
// are cut as well as others.
#pragma once

#include "model.h"

namespace stig::meshes {

/// Of a body of density 1.
struct MassSums {
  double volume = 0;
  Point centre{};
  Point squares{};   ///< integrals of x², y², z² about the centre
  Point products{};  ///< of yz, zx, xy
};
/// By the divergence theorem: exact but for rounding. What several surfaces enclose counts for
/// each.
MassSums mass_of(const Model& model);

struct Pieces {
  std::vector<std::vector<Point>> corners;  ///< of each piece
  double volume = 0;                        ///< of all hulls
  double off = 0;  ///< the most that a corner of a hull was left out by, in the model's unit
};

inline constexpr std::size_t kMostCorners =
    32;  ///< of a piece: contacts take time with their square
/// Cuts until hulls have no more than this part of the volume too much.
inline constexpr double kMostExcess = 0.02;

/// At most so many pieces; 1 is the hull. False with `problem` set: nothing encloses a volume.
bool decompose(const Model& model, std::size_t most, Pieces& pieces, std::string& problem);

/// The surface with fewer triangles, to look at.
Model simplified(const Model& model, std::size_t triangles);

}  // namespace stig::meshes
