// SPDX-License-Identifier: MIT
// An order for colours that are all given: nothing is left for a solver, the linear
// check alone decides about an order, and so orders are searched by small changes: a cell that
// takes part in a clash is moved to another place in the order, and the change is kept
// if there are no more clashes than before.
#pragma once

#include <cstdint>
#include <optional>

#include "synthesis/clashes.h"
#include "synthesis/effort.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct OrderSearch {
  std::optional<Order> order;  ///< without a clash
  std::size_t tried = 0;
  std::optional<Schedule> nearest;  ///< none found: the one with the fewest clashes …
  std::optional<Clash> clash;       ///< … and one of them
};

/// Begins from each of `first` in turn, with random numbers of its own.
OrderSearch search_orders(const Frame& frame, const Colouring& colours,
                          const std::vector<Order>& first, const Allowance& allowance);

}  // namespace stig::synthesis
