// SPDX-License-Identifier: MIT
#include "support/any_structure.h"
#include "support/uses.h"

#include <rapidcheck.h>

#include <tuple>

namespace stig {

Structure any_structure(Lattice lattice, int colours, int reach) {
  const auto coordinate = rc::gen::inRange(-reach, reach + 1);
  const auto brick =
      rc::gen::tuple(coordinate, coordinate, coordinate, rc::gen::inRange(1, colours + 1));
  Structure structure(lattice);
  for (const auto& [x, y, z, colour] :
       *rc::gen::container<std::vector<std::tuple<int, int, int, int>>>(brick)) {
    if (structure.at({x, y, z}) == kEmpty) structure.place({x, y, z}, static_cast<Colour>(colour));
  }
  return structure;
}

Lattice any_lattice() { return *rc::gen::element(Lattice::cubic, Lattice::hexagonal); }

}  // namespace stig
