// SPDX-License-Identifier: MIT
// What the reader says of rule set files, for check_schema.py: one JSON object with
// the schema and, for each file named, its codes and its content as JSON.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "rules/rule_reader.h"
#include "rules/rule_schema.h"

namespace stig {

namespace {

using Json = nlohmann::json;

/// A scalar as an editor's YAML 1.2 reader takes it.
Json scalar_json(const YamlNode& node) {
  if (node.style != YamlStyle::plain) return node.text;
  if (node.text == "true" || node.text == "false") return node.text == "true";
  const auto number = number_of(node);
  if (!number) return node.text;
  const bool whole = node.text.find_first_of(".eE") == std::string::npos;
  if (whole && *number >= -1e15 && *number <= 1e15) return static_cast<std::int64_t>(*number);
  return *number;
}

Json to_json(const YamlNode& node) {
  switch (node.kind) {
    case YamlKind::scalar:
      return scalar_json(node);
    case YamlKind::sequence: {
      Json out = Json::array();
      for (const YamlNode& item : node.items) out.push_back(to_json(item));
      return out;
    }
    case YamlKind::mapping: {
      Json out = Json::object();
      for (const YamlPair& pair : node.pairs) out[pair.key.text] = to_json(pair.value);
      return out;
    }
    default:
      return nullptr;
  }
}

Json probe(const std::string& path) {
  Json out;
  FileError error;
  const auto text = read_file(path, kMaxRuleFileBytes, error);
  if (!text) return {{"error", error.message}};
  const auto source = std::make_shared<SourceFile>(path, *text);
  Diagnostics diagnostics;
  read_rule_set(source, diagnostics);
  out["codes"] = Json::array();
  for (const Diagnostic& d : diagnostics.all()) out["codes"].push_back(info(d.code).name);
  Diagnostics ignored;
  const auto document = parse_yaml(source, {}, ignored);
  out["parsed"] = document.has_value() && !ignored.has_errors();
  if (document) out["content"] = to_json(document->root);
  return out;
}

}  // namespace

}  // namespace stig

int main(int argc, char** argv) {
  nlohmann::json out;
  out["schema"] = nlohmann::json::parse(stig::json_schema());
  for (int i = 1; i < argc; ++i) out["files"][argv[i]] = stig::probe(argv[i]);
  std::printf("%s\n", out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  return 0;
}
