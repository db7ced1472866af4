// SPDX-License-Identifier: MIT
// The kinds of value that rule sets have and no other file: how each is checked, and what JSON
// Schema says of it. The table of keys (rule_schema.h) is made of these and of those of every
// format (base/form.h).
#pragma once

#include <string>
#include <vector>

#include "base/form.h"

namespace stig::rules {

/// A symbol of the drawings, quoted or not (`3` is the text "3").
extern const ValueKind kSymbolKind;
/// List of symbols, drawing symbols such as "." included.
extern const ValueKind kStatesKind;
/// Text of several lines.
extern const ValueKind kDrawingKind;
/// Number of a stage; it is the key of a map.
extern const ValueKind kStageKind;

/// What their schemas refer to, as a JSON object. Editors offer these symbols of bricks.
std::string kind_definitions(const std::vector<std::string>& symbols);

}  // namespace stig::rules
