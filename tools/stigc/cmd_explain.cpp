// SPDX-License-Identifier: MIT
// stigc explain: rule by rule, why it fires at a site or why not.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.h"
#include "explain_report.h"
#include "structure_input.h"

namespace stig::cli {
namespace {

/// The words of what is wrong with the numbers asked for, or empty.
std::string options_problem(const ExplainOptions& options, const RuleSet& rules) {
  if (options.stage > rules.stage_count()) {
    return fmt::format("there is no stage {}: the rule set has {}", options.stage,
                       rules.stage_count());
  }
  if (options.rule && static_cast<std::size_t>(*options.rule) > rules.rules.size()) {
    return fmt::format("there is no rule {}: the rule set has {}", *options.rule,
                       rules.rules.size());
  }
  return {};
}

}  // namespace

int run(const ExplainOptions& options, App& app) {
  const std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  const std::string problem = options_problem(options, *rules);
  if (!problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  Structure structure(rules->lattice, rules->start);
  if (options.structure) {
    auto read = read_structure_for(*rules, *options.structure, app);
    if (!read) return kFailed;
    structure = std::move(*read);
  }
  const ExplainedSite scene = explained_site(*rules, structure, options.at, options.stage);
  app.print(options.json ? dump(explain_json(scene, options.rule))
                         : explain_text(scene, options.rule, app.color_out()));
  return kOk;
}

}  // namespace stig::cli
