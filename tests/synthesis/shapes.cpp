// SPDX-License-Identifier: MIT
#include "synthesis/shapes.h"
#include "support/uses.h"

#include "lattice/rgb.h"
#include "lattice/structure_text.h"

namespace stig {

Target drawn(std::string_view text, ColourUse use, Lattice lattice) {
  return target_of({structure_literal(text, lattice), numbered_bricks(9), false}, use);
}

Target staircase(ColourUse use) {
  return drawn(R"(
    3 . .
    ---
    3 2 .
    ---
    3 2 1)",
               use);
}

Target stepped_cross(ColourUse use) {
  return drawn(R"(
    . . . . .
    . . . . .
    . . 3 . .
    . . . . .
    . . . . .
    ---
    . . . . .
    . . 2 . .
    . 2 3 2 .
    . . 2 . .
    . . . . .
    ---
    . . 1 . .
    . . 2 . .
    1 2 3 2 1
    . . 2 . .
    . . 1 . .)",
               use);
}

}  // namespace stig
