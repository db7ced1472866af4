// SPDX-License-Identifier: MIT
// stigc synth: from a target structure to a rule set that builds it.
//
// The search may be ended by its budget at any time, so each step afterwards (the proof that fewer
// colours do not do, the proof of the rules, bricks that can be walled in) takes what time is left
// and says when it was cut short. What is printed has been proved by verify, whatever synthesis
// thinks of it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "base/text.h"
#include "certify/certificate.h"
#include "certify/fewest.h"
#include "commands.h"
#include "mesh_input.h"
#include "outputs.h"
#include "progress.h"
#include "report.h"
#include "rules/rule_printer.h"
#include "rules/rule_reader.h"
#include "structure_input.h"
#include "synth_report.h"
#include "synth_robot.h"
#include "synth_words.h"
#include "synthesis/emit.h"
#include "synthesis/remedies.h"
#include "synthesis/scaffold.h"
#include "synthesis/synthesise.h"
#include "verify/reachability.h"
#include "verify/verify.h"

namespace stig::cli {
namespace {

/// In larger structures it is not asked whether agents can walk to every site in time. Walking is a
/// search through empty space for every brick.
constexpr std::size_t kMostWalkedTo = 20'000;
/// For the proof of what was found when the time was over.
constexpr double kSecondsAfterwards = 1;
/// What --proof writes into its folder.
constexpr std::array<const char*, 3> kProofFiles = {"fewer.json", "fewer.cnf", "fewer.drat"};

/// The options that made a difference, as they are written. They go into the file, which then says
/// how it was made.
std::string options_in_words(const SynthOptions& o) {
  std::string out;
  if (o.use == ColourUse::given) out += " --colours given";
  if (o.colours) out += fmt::format(" --colours {}", *o.colours);
  if (o.symmetry != Symmetry::none) out += fmt::format(" --symmetry {}", to_string(o.symmetry));
  for (const Cell c : o.start) out += fmt::format(" --start {},{},{}", c.x, c.y, c.z);
  if (o.floor) out += " --floor";
  if (o.fewest == Fewest::rules) out += " --fewest rules";
  if (o.effort != 1) out += fmt::format(" --effort {}", o.effort);
  return out;
}

Wording wording(const SynthOptions& options, const Solution& solution, bool cut_short) {
  const std::string file = file_name(options.target);
  return {set_name(options.target),
          fmt::format("{}, {}", file, counted(solution.frame->cells.size(), "brick")),
          fmt::format("{} from {}{}; {}{}", kMadeBySynth, file, options_in_words(options),
                      solution.order.name,
                      cut_short ? fmt::format("; {}", ended_early()) : std::string())};
}

/// Holds "the fewest for this order" to the checker: states that only seem possible, seen
/// from one site, make clauses that it does not derive.
void confirm_fewest(const SynthOptions& options, const Target& target, const Deadline& deadline,
                    Solution& solution, SynthOutcome& outcome) {
  // One colour needs no proof, and where fewer colours were not refuted, "the fewest" is not
  // claimed.
  if (!solution.fewer_refuted || solution.colour_count == 1) return;
  Effort effort(deadline);
  outcome.fewest =
      prove_fewest(solution, static_cast<int>(target.bricks.size()),
                   {&effort, static_cast<std::uint64_t>(options.effort * kStepsOfEffort)});
  // The checker of stigc certify, not the search's own word.
  if (outcome.fewest && !derive_formula(outcome.fewest->problem, outcome.fewest->cnf).derived) {
    outcome.fewest.reset();
  }
  solution.fewer_refuted = outcome.fewest.has_value();
}

/// The proof that one colour fewer does not do; returns an exit code.
int write_proof(const SynthOptions& options, const Solution& solution,
                const std::optional<MinimalityProof>& proof, const App& app,
                std::vector<std::string>& written) {
  if (solution.colour_count == 1) {
    app.say("one colour: there are no fewer to be refuted");
    return kOk;
  }
  if (!proof) {
    app.complain("no proof that fewer colours do not do was found with this effort");
    return kRunFailed;
  }
  if (const int code = make_folder(*options.proof, app); code != kOk) return code;
  const std::size_t before = written.size();
  const std::array<const std::string*, 3> bytes = {&proof->problem, &proof->cnf, &proof->drat};
  for (std::size_t i = 0; i < kProofFiles.size(); ++i) {
    const std::string path = *options.proof + "/" + kProofFiles[i];
    FileError error;
    if (!write_file(path, *bytes[i], error)) {
      app.complain(error.message);
      // Two of the three files prove nothing.
      for (; written.size() > before; written.pop_back()) std::remove(written.back().c_str());
      return kRunFailed;
    }
    written.push_back(path);
  }
  return kOk;
}

/// Proves the rules once more, and looks for bricks that can be walled in. When the time
/// is over a moment is left for the proof.
void prove(const RuleSet& rules, const Deadline& deadline, SynthOutcome& outcome) {
  VerifyOptions verifying;
  // The stop flag is set for good once it was; looked at here it would end the proof at once.
  if (deadline.passed()) {
    verifying.seconds = kSecondsAfterwards;
  } else {
    const std::chrono::duration<double> left = deadline.end - std::chrono::steady_clock::now();
    verifying.seconds = std::clamp(left.count(), kSecondsAfterwards, verifying.seconds);
    verifying.stop = deadline.stop;
  }
  outcome.proof = verify::verify(rules, verifying);
  const bool small = outcome.proof.structure && outcome.proof.structure->size() <= kMostWalkedTo;
  if (outcome.proof.verdict == ProofVerdict::proved && small && !deadline.passed()) {
    const Budget budget{deadline.end, verifying.states, deadline.stop};
    find_walled_in(rules, verifying, outcome.proof, budget, outcome.findings);
  }
}

/// Rules, certificate and proof, proved once more by the verifier; returns an exit code.
int write_results(const SynthOptions& options, const Target& target, const Deadline& deadline,
                  Synthesis& result, App& app, SynthOutcome& outcome) {
  confirm_fewest(options, target, deadline, *result.best, outcome);
  const Solution& s = *result.best;
  const RuleSet rules = make_rule_set(*s.frame, s.colours, s.colour_count, target.bricks, s.rules,
                                      wording(options, s, result.cut_short));
  prove(rules, deadline, outcome);
  result.cut_short = result.cut_short || deadline.passed();
  // Interrupted before the proof was done: nothing unproved is written.
  if (result.cut_short && outcome.proof.verdict != ProofVerdict::proved) {
    app.complain(fmt::format("the rules that were found are not proved: {}", ended_early()));
    return kRunFailed;
  }
  const std::string text = print_rule_set(rules);
  // What cannot be read back is not written.
  if (text.size() > kMaxRuleFileBytes) {
    app.complain(
        fmt::format("the rule set takes {} bytes, more than the {} that a rule file may have",
                    text.size(), kMaxRuleFileBytes));
    return kRunFailed;
  }
  int code = kOk;
  if (has_file(options)) {
    code = write_one(*options.output, text, app, outcome.written);
  } else if (!options.json) {
    app.print(text);
  }
  if (code == kOk && options.certificate) {
    if (outcome.proof.certificate) {
      code = write_one(*options.certificate, print_certificate(*outcome.proof.certificate), app,
                       outcome.written);
    } else {
      app.complain("there is no certificate: " + outcome.proof.open);
      code = kRunFailed;
    }
  }
  if (code == kOk && options.proof) {
    code = write_proof(options, s, outcome.fewest, app, outcome.written);
  }
  return code;
}

SynthesisOptions synthesis_options(const SynthOptions& options) {
  SynthesisOptions out;
  out.symmetry = options.symmetry;
  out.start = options.start;
  out.floor = options.floor;
  if (options.colours) out.most_colours = *options.colours;
  out.fewest = options.fewest;
  out.family = options.family;
  out.strict_only = options.strict;
  out.merge = !options.exact;
  out.effort = options.effort;
  return out;
}

/// Every file that is written.
std::vector<std::string> output_names(const SynthOptions& options) {
  std::vector<std::string> names;
  // In the order in which they are written.
  if (has_file(options)) names.push_back(*options.output);
  if (options.certificate) names.push_back(*options.certificate);
  for (const char* name : kProofFiles) {
    if (options.proof) names.push_back(*options.proof + "/" + name);
  }
  return names;
}

/// Tries to do with fewer colours by means of a scaffold.
void add_scaffold(const SynthOptions& options, Target& target, Synthesis& result,
                  const SynthesisHooks& hooks, SynthOutcome& outcome) {
  SynthesisOptions searching = synthesis_options(options);
  Synthesis plain;
  // With a bound on colours there may be no solution to learn from: one with any number shows which
  // cells count.
  if (!result.best && options.colours) {
    searching.most_colours = kMaxColours;
    plain = synthesise(target, searching, hooks);
    searching.most_colours = *options.colours;
  }
  const Synthesis& known = result.best ? result : plain;
  if (known.best && known.best->colour_count == 1) return;
  // Without a solution to learn from, the longest run is what has to count.
  const std::vector<Cell> run =
      known.best ? counting_cells(*known.best, static_cast<int>(target.bricks.size()))
                 : longest_run(target);
  // Only fewer colours than without the scaffold are of any use.
  const int below =
      std::min(known.best ? known.best->colour_count : kMaxColours, searching.most_colours + 1);
  auto found = find_scaffold(target, run, static_cast<std::size_t>(options.scaffold), below,
                             searching, options.effort, hooks);
  if (!found) return;
  target = std::move(found->target);
  result = std::move(found->result);
  outcome.scaffold = std::move(found->cells);
}

}  // namespace

int run(const SynthOptions& options, App& app) {
  if (const std::string problem = bricks_problem(options.mesh, {options.target});
      !problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  if (options.robot) return synth_for_robot(options, app);
  if (options.block || !options.sides.empty() || options.robots || options.kinds) {
    app.complain(
        "--block, --sides, --robots and --kinds are about robots: --robot FILE says which");
    return kUsage;
  }
  const auto loaded = read_structure(options.target, options.lattice, app, options.mesh);
  if (!loaded) return kFailed;
  if (loaded->structure.empty()) {
    app.complain("the target has no cells");
    return kFailed;
  }
  Target target = target_of(*loaded, options.use);
  if (const int code = check_outputs(output_names(options), app, options.proof.value_or(""));
      code != kOk) {
    return code;
  }
  stop_on_signals();
  Progress progress(app);
  SynthesisHooks hooks;
  hooks.deadline = Deadline::after(options.seconds, &stop_requested());
  hooks.progress = [&](double fraction, const std::string& what) { progress.show(fraction, what); };
  const SynthesisOptions searching = synthesis_options(options);
  Synthesis result = synthesise(target, searching, hooks);
  SynthOutcome outcome;
  // A scaffold changes the target: more bricks than were asked for, and said so.
  if (options.scaffold > 0) {
    add_scaffold(options, target, result, hooks, outcome);
    result.cut_short = result.cut_short || hooks.deadline.passed();
  }
  if (result.obstacle) {
    // Remedies are tried, one by one: each is known to work.
    result.obstacle->remedies = find_remedies(target, searching, *result.obstacle, hooks);
    result.cut_short = result.cut_short || hooks.deadline.passed();
  }
  progress.clear();
  int code = kRunFailed;
  if (result.best) {
    code = write_results(options, target, hooks.deadline, result, app, outcome);
    if (has_file(options) && !options.json) app.print(synth_summary(result, outcome));
    if (!has_file(options) && !options.json) app.say(synth_summary(result, outcome));
  } else if (result.obstacle) {
    // 1 for what is proved impossible, 3 for what was not found.
    code = result.obstacle->proved ? kFailed : kRunFailed;
    if (!options.json) app.print(synth_reason(result, app.color_out()));
    if (result.cut_short) app.say(ended_early());
  } else if (!options.json) {
    app.complain(result.cut_short
                     ? fmt::format("not found: {}", ended_early())
                     : fmt::format("not found: {} with this effort; --effort allows more",
                                   orders_in_words(result.orders_tried)));
  }
  if (options.json) app.print(dump(synth_json(options, result, outcome)));
  return code;
}

}  // namespace stig::cli
