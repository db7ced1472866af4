// SPDX-License-Identifier: MIT
#include "rules/rule_schema.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <nlohmann/json.hpp>

#include "rules/cell.h"
#include "rules/neighbourhood.h"
#include "rules/state.h"

namespace stig {

namespace {

using enum ValueKind;
constexpr double kFar = kMaxCoordinate;

// Designated initialisers name only what a key needs; the rest keeps its default.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

std::vector<KeySchema> rule_set_keys() {
  return {
      {.name = "stigc",
       .kind = integer,
       .required = true,
       .doc = "Version of the file format: 1.",
       .low = 1,
       .high = kFormatVersion},
      {.name = "name", .kind = name, .required = true, .doc = "Short name, for files and reports."},
      {.name = "title", .kind = text, .doc = "What it builds, in one line."},
      {.name = "source", .kind = text, .doc = "Where the rules come from."},
      {.name = "lattice",
       .kind = choice,
       .required = true,
       .doc = "Cubic: 26 neighbours. Hexagonal: 20, in axial coordinates.",
       .words = {"cubic", "hexagonal"}},
      {.name = "symmetry",
       .kind = choice,
       .doc = "Turns and mirrors about the vertical under which every rule holds.",
       .words = {"none", "rotations", "rotations+mirrors"}},
      {.name = "inversion", .kind = boolean, .doc = "Rules hold upside down as well."},
      {.name = "floor", .kind = boolean, .doc = "Cells below z = 0 are seen as floor (=)."},
      {.name = "conflicts",
       .kind = choice,
       .doc = "What happens when rules that place different bricks match together.",
       .words = {"error", "random", "first"}},
      {.name = "bricks",
       .kind = bricks,
       .required = true,
       .doc = "The kinds of brick, by the symbol that drawings use.",
       .object = ObjectKind::brick,
       .least = 1,
       .most = kMaxColours},
      {.name = "legend", .kind = legend, .doc = "Symbols that stand for a set of states."},
      {.name = "box", .kind = object, .doc = "A bounded world.", .object = ObjectKind::box},
      {.name = "stages",
       .kind = by_stage,
       .doc = "Deposits after which the next stage begins; without: when no rule of the stage can "
              "fire.",
       .low = 1,
       .high = 1e12},
      {.name = "start",
       .kind = objects,
       .required = true,
       .doc = "The bricks that are there before.",
       .object = ObjectKind::start_entry},
      {.name = "physical",
       .kind = object,
       .doc = "What is assumed of the robots' world; for compile and validate alone.",
       .object = ObjectKind::physical},
      {.name = "expect",
       .kind = object,
       .doc = "What `stigc test` holds the file to.",
       .object = ObjectKind::expect},
      {.name = "rules",
       .kind = objects,
       .required = true,
       .doc = "The rules.",
       .object = ObjectKind::rule,
       .least = 1,
       .most = kMaxRules},
  };
}

std::vector<KeySchema> brick_keys() {
  return {
      {.name = "name", .kind = name, .doc = "What people call it; its symbol, if left out."},
      {.name = "color", .kind = colour, .required = true, .doc = "For pictures: \"#rrggbb\"."},
      {.name = "led",
       .kind = choice,
       .doc = "Block colour of the physical layer.",
       .words = {"Q1", "Q2", "Q3", "Q4"}},
  };
}

std::vector<KeySchema> start_keys() {
  return {
      {.name = "at",
       .kind = cell,
       .required = true,
       .doc = "Cell [x, y, z].",
       .low = -kFar,
       .high = kFar},
      {.name = "brick", .kind = symbol, .required = true, .doc = "Symbol of the brick."},
  };
}

std::vector<KeySchema> rule_keys() {
  return {
      {.name = "name", .kind = name, .required = true, .doc = "Unique among the rules."},
      {.name = "stage",
       .kind = integer,
       .doc = "The one stage in which the rule is active.",
       .low = 1,
       .high = kMaxStage},
      {.name = "place", .kind = symbol, .required = true, .doc = "Symbol of the brick to place."},
      {.name = "probability",
       .kind = number,
       .doc = "Chance to fire when chosen.",
       .low = 0,
       .high = 1,
       .above_low = true},
      {.name = "weight",
       .kind = number,
       .doc = "Share in `conflicts: random`.",
       .low = 0,
       .high = 1e9,
       .above_low = true},
      {.name = "symmetry",
       .kind = choice,
       .doc = "For this rule alone.",
       .words = {"none", "rotations", "rotations+mirrors"}},
      {.name = "inversion", .kind = boolean, .doc = "For this rule alone."},
      {.name = "when",
       .kind = drawing,
       .required = true,
       .doc = "The neighbourhood: slices above, level, below side by side."},
      {.name = "height",
       .kind = object,
       .doc = "Height of the site; the floor's first layer is 0.",
       .object = ObjectKind::height},
      {.name = "count",
       .kind = objects,
       .doc = "How many neighbours show what.",
       .object = ObjectKind::count},
  };
}

std::vector<KeySchema> height_keys() {
  return {
      {.name = "min", .kind = integer, .doc = "Lowest.", .low = -kFar, .high = kFar},
      {.name = "max", .kind = integer, .doc = "Highest.", .low = -kFar, .high = kFar},
  };
}

std::vector<KeySchema> count_keys() {
  return {
      {.name = "of",
       .kind = symbols,
       .required = true,
       .doc = "Symbols that are counted.",
       .least = 1},
      {.name = "among",
       .kind = choice,
       .doc = "All neighbours, or those that share a face.",
       .words = {"faces", "all"}},
      {.name = "min", .kind = integer, .doc = "Fewest.", .low = 0, .high = kMaxNeighbours},
      {.name = "max", .kind = integer, .doc = "Most.", .low = 0, .high = kMaxNeighbours},
  };
}

std::vector<KeySchema> box_keys() {
  return {
      {.name = "size",
       .kind = cell,
       .required = true,
       .doc = "Cells along [x, y, z].",
       .low = 1,
       .high = kFar},
      {.name = "origin",
       .kind = cell,
       .doc = "Lowest cell; if left out, the box is laid around the start.",
       .low = -kFar,
       .high = kFar},
      {.name = "periodic", .kind = boolean, .doc = "Opposite sides are joined."},
  };
}

std::vector<KeySchema> physical_keys() {
  return {
      {.name = "sides",
       .kind = choices,
       .doc = "Robots work from these sides only.",
       .words = {"+x", "-x", "+y", "-y"},
       .most = 4},
      {.name = "robots", .kind = integer, .doc = "How many.", .low = 1, .high = 1000},
  };
}

std::vector<KeySchema> expect_keys() {
  return {
      {.name = "bricks",
       .kind = integer,
       .doc = "Bricks in the end, the start included.",
       .low = 1,
       .high = 1e12},
      {.name = "verdict",
       .kind = choice,
       .doc = "Do all orders of events end alike?",
       .words = {"coordinated", "order-dependent", "endless"}},
      {.name = "structure",
       .kind = drawing,
       .doc = "The structure in the end: slices from the top down, parted by ---."},
  };
}

#pragma GCC diagnostic pop

}  // namespace

const ObjectSchema& object_schema(ObjectKind kind) {
  static const std::array<ObjectSchema, 9> kTable = {{
      {ObjectKind::rule_set, "rule set", "stigc: 1 …", rule_set_keys()},
      {ObjectKind::brick, "brick", "{color: \"#8d99ae\"}", brick_keys()},
      {ObjectKind::start_entry, "start entry", "{at: [0, 0, 0], brick: 1}", start_keys()},
      {ObjectKind::rule, "rule", "{name: …, place: …, when: …}", rule_keys()},
      {ObjectKind::height, "height", "{min: 0, max: 3}", height_keys()},
      {ObjectKind::count, "count", "{of: [1], min: 2}", count_keys()},
      {ObjectKind::box, "box", "{size: [9, 9, 4]}", box_keys()},
      {ObjectKind::physical, "physical", "{sides: [+x]}", physical_keys()},
      {ObjectKind::expect, "expect", "{bricks: 6}", expect_keys()},
  }};
  const ObjectSchema& found = kTable[static_cast<std::size_t>(kind)];
  assert(found.kind == kind);
  return found;
}

bool is_reserved_symbol(std::string_view symbol) {
  static constexpr std::array<std::string_view, 6> kReserved = {".", "*", "?", "#", "=", "---"};
  return std::find(kReserved.begin(), kReserved.end(), symbol) != kReserved.end();
}

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
