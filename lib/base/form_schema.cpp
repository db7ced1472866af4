// SPDX-License-Identifier: MIT
// Prints forms as JSON Schema draft 7, the version that editors support. Forms that others
// refer to become definitions; the walk over these goes on to the forms that they mention.
#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

#include "base/form.h"

namespace stig {

namespace {

using Json = nlohmann::ordered_json;

Json range_json(const FormKey& key) {
  const bool whole = key.kind == FormKind::integer || key.kind == FormKind::integers;
  Json out = {{"type", whole ? "integer" : "number"}};
  // Draft 7 has exclusive bounds as numbers of their own.
  const char* low = key.above_low ? "exclusiveMinimum" : "minimum";
  if (whole) {
    out[low] = static_cast<std::int64_t>(key.low);
    out["maximum"] = static_cast<std::int64_t>(key.high);
  } else {
    out[low] = key.low;
    out["maximum"] = key.high;
  }
  return out;
}

/// A definition is named after the form's title, which is unique among the forms of a file.
std::string definition(const Form& form) {
  std::string title(form.title);
  std::replace(title.begin(), title.end(), ' ', '_');
  return title;
}

Json words_json(const FormKey& key) {
  Json words = Json::array();
  for (const std::string_view word : key.words) words.push_back(word);
  return {{"enum", words}};
}

Json map_json(const FormKey& key, Json value) {
  Json out = {{"type", "object"}, {"additionalProperties", false}};
  out["patternProperties"][std::string(key.own->pattern)] = std::move(value);
  if (key.least > 0) out["minProperties"] = key.least;
  if (key.most != SIZE_MAX) out["maxProperties"] = key.most;
  return out;
}

Json list_json(const FormKey& key, Json items) {
  Json out = {{"type", "array"}, {"items", std::move(items)}};
  if (key.least > 0) out["minItems"] = key.least;
  if (key.most != SIZE_MAX) out["maxItems"] = key.most;
  return out;
}

/// Collects the forms that are referred to, once each. Forms can contain each other, so
/// they are collected by address and printed once.
class Printer {
 public:
  Json form_json(const Form& form) {
    Json out = {{"type", "object"}, {"additionalProperties", false}};
    for (const FormKey& key : form.keys) {
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
  /// Adds them to those that are there.
  Json definitions(Json out) {
    for (std::size_t i = 0; i < forms_.size(); ++i) {  // grows while it is walked
      const Form& form = *forms_[i];
      Json& named = out[definition(form)] = {{"title", form.title}};
      named.update(form_json(form));
    }
    return out;
  }

 private:
  // A reference and not a copy: editors then show one definition in all places.
  Json reference(const Form& form) {
    if (std::find(forms_.begin(), forms_.end(), &form) == forms_.end()) forms_.push_back(&form);
    return {{"$ref", "#/definitions/" + definition(form)}};
  }

  Json value_json(const FormKey& key) {
    // YAML scalars such as 1 or true are texts where a text is wanted, so editors must
    // accept them.
    const Json scalar = {{"type", {"string", "number", "boolean"}}};
    Json name = scalar;
    name["pattern"] = "^[^\\u0000-\\u001f\\u007f]+$";
    switch (key.kind) {
      case FormKind::text:
        return scalar;
      case FormKind::name:
        return name;
      case FormKind::colour:
        return {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
      case FormKind::choice:
        return words_json(key);
      case FormKind::boolean:
        return {{"type", "boolean"}};
      case FormKind::integer:
      case FormKind::number:
        return range_json(key);
      case FormKind::version:
        return {{"const", static_cast<std::int64_t>(key.high)}};
      case FormKind::numbers:
      case FormKind::integers:
        return list_json(key, range_json(key));
      case FormKind::names:
        return list_json(key, std::move(name));
      case FormKind::choices:
        return list_json(key, words_json(key));
      case FormKind::map:
        return map_json(key, value_json(*key.entry));
      case FormKind::own:
        return Json::parse(key.own->schema);
      case FormKind::form:
        return reference(*key.form);
      case FormKind::forms:
        return list_json(key, reference(*key.form));
      case FormKind::anything:
        break;
    }
    return Json::object();
  }

  std::vector<const Form*> forms_;
};

}  // namespace

std::string form_schema(const Form& form, std::string_view title, std::string_view description,
                        std::string_view definitions) {
  Printer printer;
  Json out = {{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", title},
              {"description", description}};
  out.update(printer.form_json(form));
  Json all = printer.definitions(Json::parse(definitions));
  if (!all.empty()) out["definitions"] = std::move(all);
  return out.dump(2) + "\n";
}

}  // namespace stig
