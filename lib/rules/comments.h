// SPDX-License-Identifier: MIT
// Which element of a rule set file each comment belongs to.
#pragma once

#include <vector>

#include "base/yaml.h"
#include "rules/rule_set.h"

namespace stig::rules {

/// A comment on a line of its own belongs to the element after it, one behind
/// something to the element it stands behind; those before everything to "stigc",
/// those after everything to "".
std::vector<Comment> place_comments(const YamlDocument& document);

}  // namespace stig::rules
