// SPDX-License-Identifier: MIT
// stigc explore: a swarm on a rule set.
//
// One run, with pictures and files of its own, or an ensemble of which only figures are kept. A run
// that a limit ended which nobody asked for says so: its structure may be unfinished.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "ensemble.h"
#include "explore_config.h"
#include "explore_outputs.h"
#include "outputs.h"
#include "progress.h"
#include "report.h"
#include "run_journal.h"

namespace stig::cli {
namespace {

/// The share of a run that is done for certain: by the nearer of its limits. The larger share,
/// since the first limit that is reached ends the run.
double fraction_done(const SwarmConfig& config, std::uint64_t steps, std::uint64_t deposits) {
  const auto share = [](std::uint64_t done, const std::optional<std::uint64_t>& limit) {
    return limit && *limit > 0 ? static_cast<double>(done) / static_cast<double>(*limit) : 0.0;
  };
  return std::max(share(steps, config.max_steps), share(deposits, config.max_deposits));
}

/// Says that a limit nobody asked for ended a run.
void say_default_limit(const ExploreConfig& config, const RunSummary& run, const App& app) {
  const bool steps = run.terminated == Terminated::steps && config.steps_by_default;
  // The limit of the last stage ends a run in the same way, as Terminated::deposits, and somebody
  // did ask for it.
  const bool deposits = run.terminated == Terminated::deposits && config.deposits_by_default &&
                        run.deposits >= kDefaultDeposits;
  if (!steps && !deposits) return;
  std::string text =
      steps ? fmt::format("stopped after {} steps, the limit when --steps is not given",
                          kDefaultSteps)
            : fmt::format("stopped after {} deposits, the limit when --deposits is not given",
                          kDefaultDeposits);
  text += fmt::format("; {} enabled {} left", run.enabled_left,
                      run.enabled_left == 1 ? "site was" : "sites were");
  if (run.out_of_reach > 0) text += fmt::format(", {} out of the agents' reach", run.out_of_reach);
  app.say(text);
}

int explore_once(const RuleSet& rules, const RuleTable& table, const ExploreConfig& config,
                 const ExploreOptions& options, const std::vector<Output>& outputs, App& app) {
  // The writer before the run: a file that cannot be opened costs no work.
  OutputWriter writer(outputs, rules, config.swarm);
  Progress progress(app);
  SwarmHooks hooks;
  hooks.stop = &stop_requested();
  // Deposits are handed on only where some output wants them: a call each costs time.
  if (writer.wants_deposits()) hooks.deposit = [&](const Deposit& d) { writer.deposit(d); };
  hooks.progress = [&](std::uint64_t steps, std::uint64_t deposits) {
    progress.show(fraction_done(config.swarm, steps, deposits),
                  fmt::format("{} steps, {} deposits", steps, deposits));
  };
  const SwarmResult result = run_swarm(table, rules.start, config.swarm, hooks);
  progress.clear();
  // Also of an interrupted run: what was built so far is there.
  const int written = writer.write(result, app);
  say_default_limit(config,
                    {result.steps, result.deposits, 0, 0, result.enabled_left, result.out_of_reach,
                     result.terminated},
                    app);
  if (options.json) {
    app.print(dump(run_json(rules, config.swarm, result)));
  } else {
    app.print(run_lines(rules, config.swarm, result, app.color_out()));
    // Only structures that fit onto a screen.
    const std::string drawing = small_drawing(result.structure, rules.bricks);
    if (!drawing.empty()) app.print("\n" + drawing);
  }
  return result.terminated == Terminated::interrupted ? kRunFailed : written;
}

/// The object of --json with several runs. The runs are objects in text already, which are put
/// between the braces by hand: as JSON values they would take as much memory as their structures.
void print_ensemble_json(const RuleSet& rules, const ExploreConfig& config,
                         const Ensemble& ensemble, App& app) {
  Json json = setting_json(rules, config.swarm);
  std::uint64_t steps = 0, deposits = 0;
  for (const RunSummary& run : ensemble.runs) {
    steps += run.steps;
    deposits += run.deposits;
  }
  json["steps"] = steps;
  json["deposits"] = deposits;
  json["rules"] = Json::array();
  for (std::size_t r = 0; r < rules.rules.size(); ++r) {
    json["rules"].push_back({{"name", rules.rules[r].name}, {"fired", ensemble.fired[r]}});
  }
  json["interrupted_runs"] = std::count_if(
      ensemble.runs.begin(), ensemble.runs.end(),
      [](const RunSummary& run) { return run.terminated == Terminated::interrupted; });
  json["distinct_structures"] = ensemble.structures.size();
  std::string text = dump(json);
  // The object's closing brace is taken off, and put back behind the list.
  text.resize(text.rfind("\n}"));
  app.print(text + ",\n  \"runs\": [\n");
  app.print(ensemble.runs_json);
  app.print("\n  ]\n}\n");
}

int explore_many(const RuleSet& rules, const RuleTable& table, const ExploreConfig& config,
                 const ExploreOptions& options, const std::vector<Output>& outputs, App& app) {
  const Ensemble ensemble = run_all(rules, table, config, options, outputs, app);
  if (ensemble.runs.empty()) return ensemble.exit_code;
  // The run with most left to do stands for all: one remark, not a thousand.
  const auto longest = std::max_element(
      ensemble.runs.begin(), ensemble.runs.end(),
      [](const RunSummary& a, const RunSummary& b) { return a.enabled_left < b.enabled_left; });
  say_default_limit(config, *longest, app);
  if (options.json) {
    print_ensemble_json(rules, config, ensemble, app);
  } else {
    app.print(ensemble_lines(rules, config, ensemble, app.color_out()));
  }
  return ensemble.interrupted ? kRunFailed : ensemble.exit_code;
}

}  // namespace

int run(const ExploreOptions& options, App& app) {
  const bool ensemble = options.runs > 1;
  if (options.run && ensemble) {
    app.complain("--run is one of --runs by itself: leave one of them out");
    return kUsage;
  }
  std::vector<Output> outputs;
  const int planned = plan_outputs(options.outputs, options.trace, ensemble, app, outputs);
  if (planned != kOk) return planned;
  for (Output& output : outputs) output.palette = options.palette;
  const std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  const RuleTable table(*rules);
  ExploreConfig config = explore_config(*rules, table, options);
  config.swarm.run = static_cast<std::uint32_t>(options.run.value_or(0));
  if (!config.problem.empty()) {
    app.complain(printable(config.problem));
    return kUsage;
  }
  // Each of several runs may write files with its number in their names.
  std::vector<std::string> names = names_of(outputs, options.runs);
  if (const auto tables = tables_of(outputs); ensemble && !tables.empty()) {
    names.push_back(journal_name(tables));
  }
  if (const int code = check_outputs(names, app); code != kOk) return code;
  stop_on_signals();
  return ensemble ? explore_many(*rules, table, config, options, outputs, app)
                  : explore_once(*rules, table, config, options, outputs, app);
}

}  // namespace stig::cli
