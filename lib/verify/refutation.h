// SPDX-License-Identifier: MIT
// From two runs that differ to the one deposit that makes the difference.
#pragma once

#include <optional>
#include <vector>

#include "verify/uses.h"
#include "verify/verify.h"

namespace stig::verify {

/// `earlier`: deposits of the stages before, on which all orders agree; `first` and
/// `other`: two orders of the present stage that differ, of which the first ended. None when
/// they end in the same structure after all, in a later stage.
///
/// The other order is followed for a while, and then the first as far as the rules still
/// allow it. The longest such detour that ends as the first order does, and the next
/// deposit of the other, make the difference.
std::optional<DivergingOrders> explain_refutation(const RuleSet& rules, const RuleTable& table,
                                                  const LatticeWorld& stage_begin,
                                                  const std::vector<Deposit>& earlier,
                                                  const std::vector<Deposit>& first,
                                                  const std::vector<Deposit>& other,
                                                  const Budget& budget);

/// Two of a few random orders, from the beginning of the first stage to the end of the last,
/// that end differently; none: all that were tried and ended agree.
std::optional<DivergingOrders> find_whole_orders(const LatticeWorld& start, const Budget& budget);

}  // namespace stig::verify
