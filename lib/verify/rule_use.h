// SPDX-License-Identifier: MIT
// Which rules can act at all in a proved set, and which bricks close open sites.
#pragma once

#include <vector>

#include "verify/findings.h"
#include "verify/uses.h"

namespace stig::verify {

struct RuleUse {
  std::vector<std::uint32_t> dead;  ///< match in no local state that the certificate allows
  std::vector<Blocking> blocking;   ///< one example for each pair of rules
};

/// Reads the certificate of `result`, so the set must have been proved.
RuleUse use_of_rules(const RuleSet& rules, const VerifyOptions& options,
                     const VerifyResult& result);

}  // namespace stig::verify
