// SPDX-License-Identifier: MIT
// stigc graph: the firing graph as DOT.
//
// The graph is quadratic in the rules, hence the limit that firing_graph_problem tells of.
#include "commands.h"
#include "lattice/firing_graph.h"

namespace stig::cli {

int run(const GraphOptions& options, App& app) {
  const std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  const std::string problem = firing_graph_problem(*rules);
  if (!problem.empty()) {
    app.complain(problem);
    return kFailed;
  }
  app.print(to_dot(firing_graph(*rules), *rules));
  return kOk;
}

}  // namespace stig::cli
