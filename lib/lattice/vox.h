// SPDX-License-Identifier: MIT
// MagicaVoxel files (.vox, version 150 with the scene graph of 200). z is up there
// too. A file has at most 256 cells a side in one model; larger structures are
// written as several models with a scene that places them.
//
// Colour k is palette entry k. Places are absolute: reading gives the cells that
// were written. The format knows the cubic lattice alone: a hexagonal structure is
// written on its axial grid, and read back when the reader is told so.
//
// Format: github.com/ephtracy/voxel-model, MagicaVoxel-file-format-vox.txt and
// MagicaVoxel-file-format-vox-extension.txt.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "lattice/loaded_structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// Reads models, scene (first frame of animations, hidden parts included) and
/// palette; other chunks are passed over. When no palette index above 62 is used,
/// index k becomes colour k; otherwise the used indices become colours 1, 2, … in
/// rising order. The bricks' symbols and names are those numbers.
std::optional<LoadedStructure> read_vox(const std::string& path, std::string_view bytes,
                                        Diagnostics& diagnostics, Lattice lattice = Lattice::cubic);

/// The whole file's bytes.
std::string print_vox(const Structure& structure, const std::vector<Brick>& bricks);

}  // namespace stig::lattice
