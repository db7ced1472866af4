// SPDX-License-Identifier: MIT
// Symbols, lists of them, drawings and numbers of stages: diagnostics R1xx, and JSON Schema.
#include "rules/rule_kinds.h"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "base/node_checks.h"
#include "base/text.h"
#include "rules/rule.h"
#include "rules/rule_schema.h"
#include "rules/state.h"

namespace stig::rules {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSymbolPattern =
    "^(?!(\\.|\\*|\\?|#|=|---)$)[^\\u0000-\\u0020\\u007f]{1,16}$";
static_assert(kMaxSymbolLength == 16, "the patterns of symbols say so too");
static_assert(kMaxStage == 63, "the pattern of stage numbers says so too");
constexpr std::string_view kStagePattern = "^([1-9]|[1-5][0-9]|6[0-3])$";

// Lengths count code points, as editors show them.
bool check_symbol_text(NodeChecks& checks, const YamlNode& node, bool of_states) {
  if (!checks.expect(node, YamlKind::scalar, "a symbol")) return false;
  const std::string shown = in_quotes(node.text);
  if (node.text.empty()) return checks.bad_text(node, "a symbol cannot be empty");
  if (has_control(node.text) || node.text.find(' ') != std::string::npos) {
    return checks.bad_text(node, fmt::format("a symbol has no space in it: {}", shown));
  }
  if (count_code_points(node.text) > kMaxSymbolLength) {
    return checks.bad_text(node,
                           fmt::format("a symbol has at most {} characters", kMaxSymbolLength));
  }
  if (!of_states && is_reserved_symbol(node.text)) {
    return checks.bad_text(
        node, fmt::format("{} has a meaning of its own and is no brick's symbol", shown));
  }
  return true;
}

bool check_symbol(NodeChecks& checks, const YamlNode& node, const FormKey& /*key*/) {
  return check_symbol_text(checks, node, false);
}

/// A single symbol without brackets is the usual slip, and the mended form is suggested.
bool check_states(NodeChecks& checks, const YamlNode& node, const FormKey& key) {
  constexpr std::string_view kWanted = "a list of symbols";
  if (node.kind == YamlKind::scalar) {
    return checks.wrong(node, kWanted, fmt::format("[{}]", yaml_text(node.text, true)));
  }
  if (!checks.expect(node, YamlKind::sequence, kWanted)) return false;
  bool sound = checks.check_size(node, key.name, node.items.size(), 1, SIZE_MAX);
  for (const YamlNode& item : node.items) sound = check_symbol_text(checks, item, true) && sound;
  return sound || checks.mark(node);
}

bool check_drawing(NodeChecks& checks, const YamlNode& node, const FormKey& /*key*/) {
  constexpr std::string_view kWanted = "a drawing: a bar '|' and the rows below it";
  if (!checks.expect(node, YamlKind::scalar, kWanted)) return false;
  // `when: 3` is a number to an editor.
  const bool plain = node.style == YamlStyle::plain;
  if (plain && (number_of(node) || node.text == "true" || node.text == "false")) {
    return checks.wrong(node, kWanted);
  }
  return true;
}

// Leading zeros are refused: YAML readers disagree on whether 010 is eight or ten.
bool check_stage(NodeChecks& checks, const YamlNode& node, const FormKey& /*key*/) {
  int stage = 0;
  const char* end = node.text.data() + node.text.size();
  const auto result = std::from_chars(node.text.data(), end, stage);
  const bool digits = node.kind == YamlKind::scalar && result.ec == std::errc() &&
                      result.ptr == end && node.text[0] != '0';
  if (!digits) return checks.wrong(node, "the number of a stage");
  if (stage >= 1 && stage <= kMaxStage) return true;
  return checks.out_of_range(node, fmt::format("stages are numbered from 1 to {}", kMaxStage));
}

/// Symbols as editors offer them: 3 without quotes, as rule sets have it.
Json offered(const std::vector<std::string>& symbols) {
  Json out = Json::array();
  for (const std::string& symbol : symbols) {
    const bool digits = symbol.find_first_not_of("0123456789") == std::string::npos;
    const bool number = digits && !symbol.starts_with('0') && symbol.size() < 16;
    out.push_back(number ? Json(std::stoll(symbol)) : Json(symbol));
  }
  return out;
}

}  // namespace

const ValueKind kSymbolKind{check_symbol, R"({"$ref": "#/definitions/symbol"})", kSymbolPattern};
const ValueKind kStatesKind{
    check_states,
    R"({"type": "array", "minItems": 1, "items": {"$ref": "#/definitions/state"}})",
    {}};
const ValueKind kDrawingKind{check_drawing, R"({"type": "string"})", {}};
const ValueKind kStageKind{check_stage, {}, kStagePattern};

std::string kind_definitions(const std::vector<std::string>& symbols) {
  // Symbols may be written as 3 or true without quotes; YAML readers then hand editors a number
  // or a truth value.
  const Json scalar = Json::array({"string", "number", "boolean"});
  std::vector<std::string> states = symbols;
  states.insert(states.end(), {".", "?", "#", "="});
  return Json{{"symbol",
               {{"description", "A symbol of the drawings."},
                {"type", scalar},
                {"pattern", kSymbolPattern},
                {"examples", offered(symbols)}}},
              {"state",
               {{"description", "A brick's symbol, or one of . ? # ="},
                {"type", scalar},
                {"pattern", "^[^\\u0000-\\u0020\\u007f]{1,16}$"},
                {"examples", offered(states)}}}}
      .dump();
}

}  // namespace stig::rules
