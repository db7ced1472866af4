// SPDX-License-Identifier: MIT
// stigc schema and stigc completions: what the program knows of itself.
//
// Schemas are printed from the tables that the readers check by, so they cannot be out of date.
#include "base/load.h"
#include "base/yaml.h"
#include "commands.h"
#include "help.h"
#include "physical/scene/scene.h"
#include "robots/block.h"
#include "robots/robot_reader.h"
#include "rules/rule_schema.h"
#include "search/plan_reader.h"
#include "sweep_plan.h"

namespace stig::cli {
namespace {

std::string schema_of(FileForm form) {
  switch (form) {
    case FileForm::scene:
      return scene_schema();
    case FileForm::robot:
      return robot_schema();
    case FileForm::block:
      return block_schema();
    case FileForm::solid:
      return solid_schema();
    case FileForm::search:
      return search::plan_schema();
    case FileForm::sweep:
      return sweep_schema();
    case FileForm::rules:
      break;
  }
  return json_schema();
}

/// The symbols of a file's bricks; the rest of it need not be good. For editors, which ask while a
/// file is being written and is mostly not yet valid.
std::vector<std::string> symbols_of(const YamlDocument& document) {
  std::vector<std::string> symbols;
  const YamlNode* bricks = document.root.find("bricks");
  if (bricks == nullptr) return symbols;
  for (const YamlPair& brick : bricks->pairs) {
    // "." and the like mean cells in drawings and are no bricks.
    if (!is_reserved_symbol(brick.key.text)) symbols.push_back(brick.key.text);
  }
  return symbols;
}

int schema_with_symbols(const SchemaOptions& options, App& app) {
  if (options.form != FileForm::rules) {
    app.complain("--symbols-of goes with the schema of rule sets");
    return kUsage;
  }
  Diagnostics diagnostics;
  std::optional<YamlDocument> document;
  if (SourceRef source = load_source(*options.symbols_of, YamlLimits().bytes, diagnostics)) {
    document = parse_yaml(std::move(source), {}, diagnostics);
  }
  app.report(diagnostics);
  // A file that cannot be parsed at all has no symbols to offer.
  if (!document) return kFailed;
  app.print(json_schema(symbols_of(*document)));
  return kOk;
}

}  // namespace

int run(const SchemaOptions& options, App& app) {
  if (options.symbols_of) return schema_with_symbols(options, app);
  app.print(schema_of(options.form));
  return kOk;
}

int run(const CompletionsOptions& options, App& app) {
  app.print(completion_script(command_tree(), options.shell));
  return kOk;
}

}  // namespace stig::cli
