// SPDX-License-Identifier: MIT
// What the decisions of a certificate ask for, by what is known.
#pragma once

#include <optional>
#include <vector>

#include "recheck/uses.h"
#include "recheck/view.h"
#include "recheck/work_certificate.h"

namespace stig::recheck {

/// A block to be put, from the column. `cell` says on which level, on top of it too.
struct Put {
  NearCell cell;
  Colour colour = 0;
};

/// Nothing where nothing is to be done, an answer is not known, or has no branch.
std::optional<Put> decide(const WorkCertificate& certificate, const View& view,
                          const std::vector<std::int8_t>& known, int side);

}  // namespace stig::recheck
