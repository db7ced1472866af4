// SPDX-License-Identifier: MIT
// stigc verify: does every order of events end in the same structure?
//
// The box in which a claim holds is part of the claim, so it is settled first, by the command line
// or the file. Work is counted in steps: the same effort gives the same verdict on any machine, and
// --budget, in seconds, is the exception that a user asks for.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.h"
#include "meant_box.h"
#include "outputs.h"
#include "progress.h"
#include "report.h"
#include "rules/worked_from.h"
#include "verify_report.h"

namespace stig::cli {
namespace {

/// With losses: a list of more would not fit into memory.
constexpr std::uint64_t kMostStructures = 200'000;

/// The world to prove things of; none: unbounded space.
std::optional<Box> chosen_box(const RuleSet& rules, const WorldOptions& world,
                              std::string& problem) {
  const std::optional<BoxSpec> spec = meant_box(rules, world, problem);
  if (!spec) return std::nullopt;
  return lay_box(*spec, rules.start, rules.floor);
}

// 3 for unknown: neither yes nor no.
int exit_code(ProofVerdict verdict) {
  switch (verdict) {
    case ProofVerdict::proved:
      return kOk;
    case ProofVerdict::refuted:
    case ProofVerdict::endless:
      return kFailed;
    case ProofVerdict::unknown:
      break;
  }
  return kRunFailed;
}

int exit_code(LossVerdict verdict) {
  switch (verdict) {
    case LossVerdict::restored:
      return kOk;
    case LossVerdict::lasting:
      return kFailed;
    case LossVerdict::unknown:
      break;
  }
  return kRunFailed;
}

/// Nothing where it is not proved in what the orders end.
std::optional<LossResult> losses_of(const RuleSet& rules, const VerifyOptions& settings,
                                    const VerifyResult& result, Progress& progress) {
  if (result.verdict != ProofVerdict::proved) return std::nullopt;
  LossOptions options;
  options.box = settings.box;
  options.states = std::min(settings.states, kMostStructures);
  options.work = settings.work;
  options.seconds = settings.seconds;
  options.stop = settings.stop;
  options.progress = [&](std::uint64_t structures) {
    progress.show(0, fmt::format("losses: {} structures", structures));
  };
  return find_losses(rules, *result.structure, options);
}

int write_certificate(const std::string& path, const VerifyResult& result, const App& app) {
  if (!result.certificate) {
    // No failure in itself: the verdict has a code of its own.
    app.say("no certificate was written: nothing was proved");
    return kOk;
  }
  return write_output(path, print_certificate(*result.certificate), app);
}

/// Every file that may be written.
std::vector<std::string> output_names(const VerifyFileOptions& options) {
  std::vector<std::string> names;
  if (options.witness) names = witness_names(*options.witness);
  if (options.certificate) names.push_back(*options.certificate);
  return names;
}

int complain(const std::string& problem, const App& app) {
  app.complain(printable(problem));
  return kUsage;
}

}  // namespace

int run(const VerifyFileOptions& options, App& app) {
  std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  if (const int code = check_outputs(output_names(options), app); code != kOk) return code;
  rules = worked_from(std::move(*rules), options.sides);
  VerifyOptions settings;
  std::string problem;
  settings.box = chosen_box(*rules, options.world, problem);
  if (!problem.empty()) return complain(problem, app);
  // Events in the box are what is proved; the same check as explore's.
  SwarmConfig config;
  config.motion = Motion::event;
  config.box = settings.box;
  problem = config_problem(RuleTable(*rules), rules->start, config);
  if (!problem.empty()) return complain(problem, app);
  stop_on_signals();
  Progress progress(app);
  const auto part = [&](std::uint64_t work) {
    // Parts of the work in their usual proportion.
    return static_cast<std::uint64_t>(options.effort * static_cast<double>(work));
  };
  settings.work = part(settings.work);
  settings.seconds = options.budget.value_or(kNoTimeLimit);
  settings.states = options.states;
  settings.stop = &stop_requested();
  settings.progress = [&](int stage, const std::string& what) {
    progress.show(0, rules->stage_count() > 1 ? fmt::format("stage {}: {}", stage, what) : what);
  };
  const VerifyResult result = verify::verify(*rules, settings);
  FindingOptions limits;
  limits.work = part(limits.work);
  limits.seconds = settings.seconds;
  // Walled-in bricks, rules that never fire, repairs: what else the user will ask.
  progress.show(0, "looking at what else there is to say");
  const Findings findings = find_more(*rules, settings, result, limits);
  const std::optional<LossResult> losses =
      options.losses ? losses_of(*rules, settings, result, progress) : std::nullopt;
  progress.clear();
  if (options.losses && !losses) app.say("losses were not looked at: nothing was proved");
  int code = exit_code(result.verdict);
  if (losses) code = std::max(code, exit_code(losses->verdict));
  const VerifyReport report{*rules, settings.box, result, findings, losses ? &*losses : nullptr};
  if (options.json) {
    app.print(dump(to_json(report)));
  } else {
    app.print(to_text(report, app.color_out()));
  }
  // A failure to write is worse than a verdict of "no".
  if (options.certificate)
    code = std::max(code, write_certificate(*options.certificate, result, app));
  if (options.witness) code = std::max(code, write_witness(*options.witness, report, app));
  return code;
}

}  // namespace stig::cli
