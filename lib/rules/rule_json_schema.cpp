// SPDX-License-Identifier: MIT
// The table of rule_schema.h as JSON Schema.
#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

#include "rules/rule_schema.h"

namespace stig {

namespace {

using Json = nlohmann::ordered_json;

// Symbols and texts may be written as 3 or true without quotes; YAML readers then
// hand editors a number or a truth value.
Json any_scalar() { return Json::array({"string", "number", "boolean"}); }

constexpr const char* kSymbolPattern =
    "^(?!(\\.|\\*|\\?|#|=|---)$)[^\\u0000-\\u0020\\u007f]{1,16}$";
static_assert(kMaxStage == 63, "the pattern of stage numbers says so too");
constexpr const char* kStagePattern = "^([1-9]|[1-5][0-9]|6[0-3])$";

Json range_json(const KeySchema& key, const char* type) {
  Json out = {{"type", type}};
  out[key.above_low ? "exclusiveMinimum" : "minimum"] = key.low;
  out["maximum"] = key.high;
  if (std::string_view(type) == "integer") {
    out["minimum"] = static_cast<std::int64_t>(key.low);
    out["maximum"] = static_cast<std::int64_t>(key.high);
  }
  return out;
}

Json reference(ObjectKind kind) {
  std::string title(object_schema(kind).title);
  std::replace(title.begin(), title.end(), ' ', '_');
  return {{"$ref", "#/definitions/" + title}};
}

Json words_json(const KeySchema& key) {
  Json out = {{"enum", Json::array()}};
  for (const std::string_view word : key.words) out["enum"].push_back(word);
  return out;
}

Json list_json(const KeySchema& key, Json items) {
  Json out = {{"type", "array"}, {"items", std::move(items)}};
  if (key.least > 0) out["minItems"] = key.least;
  if (key.most != SIZE_MAX) out["maxItems"] = key.most;
  return out;
}

Json map_json(const KeySchema& key, const char* pattern, Json value) {
  Json out = {{"type", "object"}, {"additionalProperties", false}};
  out["patternProperties"][pattern] = std::move(value);
  if (key.least > 0) out["minProperties"] = key.least;
  if (key.most != SIZE_MAX) out["maxProperties"] = key.most;
  return out;
}

Json state_list_json() {
  return {{"type", "array"}, {"minItems", 1}, {"items", {{"$ref", "#/definitions/state"}}}};
}

Json value_json(const KeySchema& key) {
  using enum ValueKind;
  switch (key.kind) {
    case text:
      return {{"type", any_scalar()}};
    case name:
      return {{"$ref", "#/definitions/name"}};
    case symbol:
      return {{"$ref", "#/definitions/symbol"}};
    case colour:
      return {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
    case choice:
      return words_json(key);
    case boolean:
      return {{"type", "boolean"}};
    case integer:
      return range_json(key, "integer");
    case number:
      return range_json(key, "number");
    case drawing:
      return {{"type", "string"}};
    case cell: {
      Json out = list_json(key, range_json(key, "integer"));
      out["minItems"] = out["maxItems"] = 3;
      return out;
    }
    case symbols:
      return state_list_json();
    case choices:
      return list_json(key, words_json(key));
    case object:
      return reference(key.object);
    case objects:
      return list_json(key, reference(key.object));
    case bricks:
      return map_json(key, kSymbolPattern, reference(key.object));
    case legend:
      return map_json(key, kSymbolPattern, state_list_json());
    case by_stage:
      return map_json(key, kStagePattern, range_json(key, "integer"));
  }
  assert(false);
  return {};
}

Json object_json(const ObjectSchema& schema) {
  Json out = {{"type", "object"}, {"additionalProperties", false}};
  for (const KeySchema& key : schema.keys) {
    Json value = value_json(key);
    // Draft 7 ignores what stands beside a $ref, so the reference is wrapped.
    if (value.contains("$ref")) value = {{"allOf", Json::array({std::move(value)})}};
    Json documented = {{"description", key.doc}};
    documented.update(value);
    out["properties"][std::string(key.name)] = std::move(documented);
    if (key.required) out["required"].push_back(key.name);
  }
  return out;
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

std::string json_schema() { return json_schema({"1", "2", "3", "4"}); }

std::string json_schema(const std::vector<std::string>& symbols) {
  Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", "stigc rule set, version 1"},
              {"description", "Rules of collective construction on a 3-D lattice."}};
  out.update(object_json(object_schema(ObjectKind::rule_set)));
  std::vector<std::string> states = symbols;
  states.insert(states.end(), {".", "?", "#", "="});
  Json& definitions = out["definitions"];
  definitions["symbol"] = {{"description", "A symbol of the drawings."},
                           {"type", any_scalar()},
                           {"pattern", kSymbolPattern},
                           {"examples", offered(symbols)}};
  definitions["state"] = {{"description", "A brick's symbol, or one of . ? # ="},
                          {"type", any_scalar()},
                          {"pattern", "^[^\\u0000-\\u0020\\u007f]{1,16}$"},
                          {"examples", offered(states)}};
  definitions["name"] = {{"type", any_scalar()}, {"pattern", "^[^\\u0000-\\u001f\\u007f]+$"}};
  for (int kind = 1; kind <= static_cast<int>(ObjectKind::expect); ++kind) {
    const ObjectSchema& schema = object_schema(static_cast<ObjectKind>(kind));
    std::string title(schema.title);
    std::replace(title.begin(), title.end(), ' ', '_');
    definitions[title] = {{"title", schema.title}};
    definitions[title].update(object_json(schema));
  }
  return out.dump(2) + "\n";
}

}  // namespace stig
