// SPDX-License-Identifier: MIT
#include "proof_box.h"

namespace stig {

std::optional<BoxSpec> meant_box(const RuleSet& rules, const std::optional<BoxOption>& box,
                                 bool periodic) {
  std::optional<BoxSpec> meant = rules.box;
  if (box) {
    meant.reset();
    if (box->size) meant = BoxSpec{*box->size, std::nullopt, false};
  }
  if (meant && periodic) meant->periodic = true;
  return meant;
}

}  // namespace stig
