// SPDX-License-Identifier: MIT
// Small structures by chance, for laws that hold for all.
#pragma once

#include "lattice/structure.h"
#include "support/uses.h"

namespace stig {

/// Up to some forty bricks of colours 1..colours within ±reach; sometimes none. Call
/// inside of rc::check.
Structure any_structure(Lattice lattice, int colours = 4, int reach = 3);

/// Either lattice.
Lattice any_lattice();

}  // namespace stig
