// SPDX-License-Identifier: MIT
// What a compiled controller says of itself: its chart and its decisions, taken from its text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "view/uses.h"

namespace stig::view {

/// {"chart": [{"state": "look", "does": "look", "to": [["decided", "approach site"], …]}, …],
///  "decides": {"line": 5, "text": "local function decide…"}}, both empty in a program that
/// `stigc compile` has not written (compiler/controller_lua.h).
nlohmann::ordered_json program_json(std::string_view text);

}  // namespace stig::view
