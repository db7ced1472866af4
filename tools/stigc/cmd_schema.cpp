// SPDX-License-Identifier: MIT
// stigc schema and stigc completions: what the program knows of itself.
#include "commands.h"
#include "help.h"
#include "physical/scene.h"
#include "rules/rule_schema.h"

namespace stig {

int run(const SchemaOptions& options, App& app) {
  app.print(options.form == FileForm::scene ? scene_schema() : json_schema());
  return kOk;
}

int run(const CompletionsOptions& options, App& app) {
  app.print(completion_script(command_tree(), options.shell));
  return kOk;
}

}  // namespace stig
