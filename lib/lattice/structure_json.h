// SPDX-License-Identifier: MIT
// Structures as JSON, absolute places and brick colours included:
//
//   {"stigc_structure": 1, "lattice": "cubic",
//    "bricks": [{"symbol": "3", "name": "Q3", "color": "#4363d8"}],
//    "cells": [[0, 0, 0, 1], [0, 0, 1, 1]]}
//
// A cell is x, y, z and the number of a brick, counted from 1; on the hexagonal
// lattice x and y are the axial coordinates q and r.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lattice/loaded_structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// Keys may come in any order, all but `lattice` (cubic) must be there, unknown and
/// repeated ones are errors. Reading stops at the first error in the form.
std::optional<LoadedStructure> read_structure_json(SourceRef source, Diagnostics& diagnostics);

/// One cell a line, in cell order. Colours without a brick in `bricks` get one from
/// the built-in palette.
std::string print_structure_json(const Structure& structure, const std::vector<Brick>& bricks);

}  // namespace stig::lattice
