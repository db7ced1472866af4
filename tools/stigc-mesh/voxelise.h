// SPDX-License-Identifier: MIT
// Which cells of a cubic grid a model fills.
#pragma once

#include "model.h"

namespace stig::meshes {

using CellPlace = std::array<int, 3>;  ///< x, y, z from 0; level 0 stands on the floor

enum class Fill : std::uint8_t {
  solid,  ///< cells whose middle is in the model
  shell   ///< cells that a surface passes through
};

struct Grid {
  int up = 2;         ///< the model's axis that points up
  bool down = false;  ///< it points down instead
  double side = 1;    ///< of a cell, in the file's unit
  Fill fill = Fill::solid;
};

struct Cells {
  double side = 0;               ///< of a cell, in the file's unit
  std::vector<CellPlace> cells;  ///< lowest level first, then by y and x
  std::size_t joined = 0;        ///< cells added where parts touched at an edge or a corner alone
  std::size_t parts_left_out = 0, cells_left_out = 0;  ///< what stands apart from the largest part
  std::size_t on_floor = 0;                            ///< cells of level 0
  std::size_t overhanging = 0;                         ///< cells above level 0 without one beneath
};

inline constexpr double kMostCells = 2e7;  ///< of the box about a model
inline constexpr std::size_t kMostBricks = 1'000'000;

/// The grid's lines are such that the model stands on level 0 and in the middle of its cells along
/// both other axes. False with `problem` set: too many cells, or none is filled.
bool voxelise(const Model& model, const Grid& grid, Cells& cells, std::string& problem);

/// The same with cells of a size for about so many bricks: the nearest number that was met while
/// halving.
bool voxelise_to(const Model& model, Grid grid, std::size_t bricks, double volume, Cells& cells,
                 std::string& problem);

}  // namespace stig::meshes
