// SPDX-License-Identifier: MIT
// A run, by the program's own defaults for whatever the page does not say.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "answers.h"
#include "base/hash.h"
#include "explore_config.h"
#include "lattice/structure_json.h"
#include "numbers.h"
#include "report.h"
#include "rules_text.h"
#include "shown_runs.h"
#include "view/lattice_run.h"

namespace stig::playground {
namespace {

Motion motion_of(const std::string& word) {
  for (const Motion motion : {Motion::teleport, Motion::event}) {
    if (to_string(motion) == word) return motion;
  }
  return Motion::walk;
}

/// The number under a key; nothing when there is none, or none that counts anything.
template <class Number>
std::optional<Number> number_at(const Json& question, const char* key) {
  const auto found = question.find(key);
  if (found == question.end() || !found->is_number_unsigned()) return std::nullopt;
  const auto value = found->get<std::uint64_t>();
  if (value > static_cast<std::uint64_t>(std::numeric_limits<Number>::max())) return std::nullopt;
  return static_cast<Number>(value);
}

ExploreOptions options_of(const Json& question, std::string& problem) {
  ExploreOptions options;
  options.motion = motion_of(question.value("motion", ""));
  if (options.motion != Motion::event) {
    options.agents = number_at<int>(question, "agents");
    options.moves = number_at<int>(question, "moves");
  }
  options.seed = number_at<std::uint64_t>(question, "seed").value_or(1);
  options.steps = number_at<std::uint64_t>(question, "steps");
  options.deposits = number_at<std::uint64_t>(question, "deposits");
  const std::string size = question.value("box", "");
  if (!size.empty()) {
    BoxOption& box = options.world.box.emplace();
    if (size != "none") problem = parse_size(size, box.size.emplace());
    if (!problem.empty()) problem = fmt::format("box: {}", problem);
  }
  return options;
}

}  // namespace

Json explore_answer(const Json& question) {
  Json out;
  const std::optional<RuleSet> rules = read_rules_text(question, out);
  if (!rules) return out;
  const RuleTable table(*rules);
  std::string problem;
  const ExploreOptions options = options_of(question, problem);
  if (!problem.empty()) {
    out["problem"] = problem;
    return out;
  }
  const ExploreConfig config = explore_config(*rules, table, options);
  if (!config.problem.empty()) {
    out["problem"] = config.problem;
    return out;
  }
  Trace trace;
  trace.config = config.swarm;
  SwarmHooks hooks;
  hooks.deposit = [&](const Deposit& deposit) { trace.events.push_back(deposit); };
  const SwarmResult result = run_swarm(table, rules->start, config.swarm, hooks);
  trace.rule_set_hash = rule_set_hash(*rules);
  trace.steps = result.steps;
  trace.terminated = result.terminated;
  trace.final_hash = structure_hash(result.structure);
  PageContent page;
  add_lattice_run(trace, *rules, rules->name, page);
  add_view(page, out);
  out["run"] = run_json(*rules, config.swarm, result);
  out["text"] = run_lines(*rules, config.swarm, result, false);
  out["stage"] = result.stage;
  out["files"] = {{"json", print_structure_json(result.structure, rules->bricks)},
                  {"stigt", trace_file(*rules, trace)}};
  return out;
}

}  // namespace stig::playground
