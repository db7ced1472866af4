// SPDX-License-Identifier: MIT
// What is to be built: cells, and for each the colours that will do.
#pragma once

#include <optional>
#include <vector>

#include "lattice/loaded_structure.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// What becomes of the colours that a structure file gives.
enum class ColourUse : std::uint8_t {
  given,  ///< kept; a brick whose symbol is "?" or "#" may be of any colour
  free,   ///< ignored: the file says the shape alone
};

struct Target {
  Lattice lattice = Lattice::cubic;
  std::vector<Cell> cells;        ///< sorted
  std::vector<StateSet> colours;  ///< beside `cells`: those allowed; anything(): free
  std::vector<Brick> bricks;      ///< the given colours; colour k is bricks[k - 1]
};

/// Given colours are numbered anew, in the order of the file, wildcards left out.
Target target_of(const LoadedStructure& structure, ColourUse use);

}  // namespace stig::synthesis
