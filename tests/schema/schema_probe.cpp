// SPDX-License-Identifier: MIT
// What the readers say of rule sets or, after the word "scenes", of scenes, for
// check_schema.py: one JSON object with the schema and, for each file named, its codes and
// its content as JSON.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "physical/scene/scene.h"
#include "robots/robot_reader.h"
#include "rules/rule_reader.h"
#include "rules/rule_schema.h"
#include "support/uses.h"

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

void read_scene_alone(const std::shared_ptr<const SourceFile>& source, Diagnostics& diagnostics) {
  // Blocks, robots and poses have forms of their own.
  const SceneLoader load = [](const std::string& name, std::size_t, FileError&) {
    if (name.find("bot") != std::string::npos || name.find("cart") != std::string::npos) {
      return std::optional<std::string>(
          "stigc_robot: 1\nname: r\nbodies: [{name: b, box: [1, 1, 1], mass: 1, base: [0, 0, "
          "0]}]\n");
    }
    return std::optional<std::string>(
        "stigc_block: 1\nname: b\nbody: {side: 0.055, mass: 0.1, friction: 0.5}\n");
  };
  read_scene(source, load, diagnostics);
}

/// A kind of file: its name on the command line, its reader and its schema.
struct FileKind {
  std::string_view name;
  void (*read)(const std::shared_ptr<const SourceFile>&, Diagnostics&);
  std::string (*schema)();
};
const FileKind kKinds[] = {
    {"rules", [](const auto& source, auto& out) { read_rule_set(source, out); }, json_schema},
    {"scenes", read_scene_alone, scene_schema},
    {"robots", [](const auto& source, auto& out) { read_robot(source, out); }, robot_schema}};

Json probe(const std::string& path, const FileKind& kind) {
  Json out;
  FileError error;
  const auto text = read_file(path, kMaxRuleFileBytes, error);
  if (!text) return {{"error", error.message}};
  const auto source = std::make_shared<SourceFile>(path, *text);
  Diagnostics diagnostics;
  kind.read(source, diagnostics);
  out["codes"] = Json::array();
  for (const Diagnostic& d : diagnostics.all()) out["codes"].push_back(info(d.code).name);
  Diagnostics ignored;
  const auto document = parse_yaml(source, {}, ignored);
  out["parsed"] = document.has_value() && !ignored.has_errors();
  if (document) out["content"] = to_json(document->root);
  return out;
}

}  // namespace

/// All files with what the reader says of them, and the schema.
nlohmann::json probe_all(const std::vector<std::string>& arguments) {
  const auto kind = std::find_if(std::begin(kKinds), std::end(kKinds),
                                 [&](const FileKind& one) { return one.name == arguments.at(0); });
  nlohmann::json out;
  if (kind == std::end(kKinds)) return out;
  out["schema"] = nlohmann::json::parse(kind->schema());
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    out["files"][arguments[i]] = probe(arguments[i], *kind);
  }
  return out;
}

}  // namespace stig

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const nlohmann::json out = stig::probe_all({argv + 1, argv + argc});
  std::printf("%s\n", out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  return out.is_null() ? 2 : 0;
}
