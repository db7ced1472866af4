// SPDX-License-Identifier: MIT
// stigc schema and stigc completions: what the program knows of itself.
#include "commands.h"
#include "help.h"
#include "physical/scene/scene.h"
#include "robots/block.h"
#include "robots/robot_reader.h"
#include "rules/rule_schema.h"

namespace stig {
namespace {

std::string schema_of(FileForm form) {
  switch (form) {
    case FileForm::scene:
      return scene_schema();
    case FileForm::robot:
      return robot_schema();
    case FileForm::block:
      return block_schema();
    case FileForm::rules:
      break;
  }
  return json_schema();
}

}  // namespace

int run(const SchemaOptions& options, App& app) {
  app.print(schema_of(options.form));
  return kOk;
}

int run(const CompletionsOptions& options, App& app) {
  app.print(completion_script(command_tree(), options.shell));
  return kOk;
}

}  // namespace stig
