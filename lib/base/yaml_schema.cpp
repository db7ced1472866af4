// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/yaml_shape.h"

namespace stig {

namespace {

using Json = nlohmann::ordered_json;

std::string definition_name(const YamlObject& object) {
  std::string name(object.title);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

// YAML readers hand editors a number or a truth value for a text written as 3 or true.
Json any_scalar() { return Json::array({"string", "number", "boolean"}); }

Json number_json(const YamlKey& key) {
  const bool whole = key.type == YamlType::integer || key.type == YamlType::integers;
  Json out = {{"type", whole ? "integer" : "number"}};
  const auto bound = [whole](double x) {
    return whole ? Json(static_cast<std::int64_t>(x)) : Json(x);
  };
  out[key.above_low ? "exclusiveMinimum" : "minimum"] = bound(key.low);
  out["maximum"] = bound(key.high);
  return out;
}

Json list_json(const YamlKey& key, Json items) {
  Json out = {{"type", "array"}, {"items", std::move(items)}};
  if (key.least > 0) out["minItems"] = key.least;
  if (key.most != SIZE_MAX) out["maxItems"] = key.most;
  return out;
}

Json reference(const YamlObject& object) {
  return {{"$ref", "#/definitions/" + definition_name(object)}};
}

Json value_json(const YamlKey& key) {
  switch (key.type) {
    case YamlType::text:
      return {{"type", any_scalar()}};
    case YamlType::name:
      return {{"type", any_scalar()}, {"pattern", "^[^\\u0000-\\u001f\\u007f]+$"}};
    case YamlType::number:
    case YamlType::integer:
      return number_json(key);
    case YamlType::boolean:
      return {{"type", "boolean"}};
    case YamlType::choice:
      return {{"enum", key.words}};
    case YamlType::numbers:
    case YamlType::integers:
      return list_json(key, number_json(key));
    case YamlType::object:
      // Draft 7 ignores what stands beside a $ref, so the reference is wrapped.
      return {{"allOf", Json::array({reference(*key.object)})}};
    case YamlType::objects:
      return list_json(key, reference(*key.object));
  }
  return {};
}

Json object_json(const YamlObject& object) {
  Json out = {{"type", "object"}, {"additionalProperties", false}};
  for (const YamlKey& key : object.keys) {
    Json documented = {{"description", key.doc}};
    documented.update(value_json(key));
    out["properties"][std::string(key.name)] = std::move(documented);
    if (key.required) out["required"].push_back(key.name);
  }
  return out;
}

/// The definitions of all objects below, each once.
void define(const YamlObject& object, Json& definitions) {
  for (const YamlKey& key : object.keys) {
    if (key.object == nullptr) continue;
    Json& definition = definitions[definition_name(*key.object)];
    if (!definition.is_null()) continue;
    definition = {{"title", key.object->title}};
    definition.update(object_json(*key.object));
    define(*key.object, definitions);
  }
}

}  // namespace

std::string yaml_schema(const YamlObject& root, std::string_view title,
                        std::string_view description) {
  Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", title},
              {"description", description}};
  out.update(object_json(root));
  define(root, out["definitions"]);
  return out.dump(2) + "\n";
}

}  // namespace stig
