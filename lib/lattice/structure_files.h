// SPDX-License-Identifier: MIT
// The front door to structure files: the ending of the name says which kind.
//
//   read and write  .txt slices   .json   .vox MagicaVoxel
//   write           .stl .ply .glb surfaces   .png .svg pictures
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lattice/loaded_structure.h"
#include "lattice/picture.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// What a file need not say itself. One that says otherwise is a diagnostic.
struct StructureReadOptions {
  std::optional<Lattice> lattice;  ///< left out: the file's, or cubic
  std::vector<Brick> bricks;       ///< symbols of .txt; empty: the file's (text_file.h)
};

struct StructureWriteOptions {
  double scale = 1;        ///< width of a cell in a surface, in the file's units
  PictureOptions picture;  ///< its format is set by the ending
};

/// Anything wrong, an unreadable file and an unknown ending included, is a diagnostic.
std::optional<LoadedStructure> read_structure_file(const std::string& path,
                                                   const StructureReadOptions& options,
                                                   Diagnostics& diagnostics);

/// False with `error` set; the file is then as it was.
bool write_structure_file(const std::string& path, const Structure& structure,
                          const std::vector<Brick>& bricks, const StructureWriteOptions& options,
                          std::string& error);

/// Whether write_structure_file knows the ending, so that a program can say so before
/// a long run. Otherwise `error` lists the known ones.
bool can_write_structure(const std::string& path, std::string& error);

}  // namespace stig::lattice
