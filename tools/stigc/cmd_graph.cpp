// SPDX-License-Identifier: MIT
// stigc graph: the firing graph as DOT.
#include <fmt/format.h>

#include "commands.h"
#include "lattice/firing_graph.h"

namespace stig {
namespace {

/// Edges grow with the square of the rules; beyond this no layout ends.
constexpr std::size_t kMostRules = 2000;

}  // namespace

int run(const GraphOptions& options, App& app) {
  const std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  if (rules->rules.size() > kMostRules) {
    app.complain(fmt::format("{} rules are too many for a drawing: at most {}", rules->rules.size(),
                             kMostRules));
    return kRunFailed;
  }
  app.print(to_dot(firing_graph(*rules), *rules));
  return kOk;
}

}  // namespace stig
