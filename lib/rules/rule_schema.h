// SPDX-License-Identifier: MIT
// The keys of a rule set file, as tables of base/form.h: one for each kind of mapping in it.
//
// check_form holds a file to them and reports every diagnostic R1xx, json_schema prints them for
// editors, the reader of plain values and the printer take from them what belongs to the members
// of RuleSet (key_field.h). What the tables cannot say (symbols that are not defined, rules that
// contradict each other) are diagnostics R2xx and R3xx; a schema cannot see them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/form.h"

namespace stig::rules {

const Form& rule_set_form();
const Form& brick_form();
const Form& start_form();
const Form& rule_form();
const Form& height_form();
const Form& count_form();
const Form& box_form();
const Form& physical_form();
const Form& expect_form();

/// The key at a path, which has to be there; `a/b` is the key b of the mapping under a
/// (key_field.h).
const FormKey& key_of(const Form& form, std::string_view path);

/// The version of the file format that is read.
inline constexpr int kFormatVersion = 1;
inline constexpr int kMaxRules = 20'000;
inline constexpr std::size_t kMaxSymbolLength = 16;  ///< code points

/// Symbols with a meaning of their own in drawings; no brick may take them.
bool is_reserved_symbol(std::string_view symbol);

/// JSON Schema draft 7 of the file format, with a newline at the end.
std::string json_schema();
/// The same, which offers these symbols of bricks where one is wanted. It refuses no others, since
/// a palette grows while its file is written.
std::string json_schema(const std::vector<std::string>& symbols);

}  // namespace stig::rules
