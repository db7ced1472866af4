// SPDX-License-Identifier: MIT
// The smallest change to a refuted rule set, of the changes that are tried, after which
// every order ends alike: rules for sites where one order comes to a halt and another does
// not, or one rule left out of two that are at odds.
#pragma once

#include "verify/findings.h"
#include "verify/uses.h"

namespace stig::verify {

/// None: nothing that was tried within the budget is proved.
std::optional<Repair> find_repair(const RuleSet& rules, const VerifyOptions& options,
                                  const VerifyResult& refuted, const Budget& budget);

}  // namespace stig::verify
