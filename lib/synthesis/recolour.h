// SPDX-License-Identifier: MIT
// When the colours that a target gives cannot be kept: which few cells must have others?
#pragma once

#include "synthesis/synthesise.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct Recoloured {
  Target target;                                 ///< as it could be built
  std::vector<std::pair<Cell, Colour>> changes;  ///< none of them can be spared
};

/// Looks through the orders for the one with the fewest cells changed, with the given
/// colours alone. A set of changes is minimal for its order; another order may do with
/// fewer.
std::optional<Recoloured> find_recolouring(const Target& target, const Placing& placing,
                                           const Allowance& allowance);

}  // namespace stig::synthesis
