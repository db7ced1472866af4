// SPDX-License-Identifier: MIT
// stigc test: rule sets held to what they expect of themselves.
//
// Expectations stand in the rule set's own file: bricks, structure, verdict. They are tried by
// sampling and search first, which are quick and find most contradictions, and by proof for what is
// still open.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "lattice/expectation.h"
#include "progress.h"
#include "report.h"
#include "verify/verify.h"

namespace stig::cli {
namespace {

std::string coloured(Standing standing, bool color) {
  // The longest word has 16 characters.
  const std::string padded = fmt::format("{:<17}", to_string(standing));
  switch (standing) {
    case Standing::held:
    case Standing::not_contradicted:
      return green(padded, color);
    case Standing::undecided:
      return yellow(padded, color);
    case Standing::failed:
      break;
  }
  return red(padded, color);
}

/// 0, 1 or 3: see app.h. What failed counts for more than what stayed open.
int exit_code(const ExpectationReport& report) {
  if (report.passed()) return kOk;
  const bool failed = !report.problem.empty() ||
                      std::any_of(report.items.begin(), report.items.end(), [](const auto& item) {
                        return item.standing == Standing::failed;
                      });
  return failed ? kFailed : kRunFailed;
}

bool expects_nothing(const ExpectationReport& report) {
  return report.items.empty() && report.problem.empty() && !report.interrupted;
}

void print_text(const std::string& file, const ExpectationReport& report, App& app) {
  app.print(bold(printable(file), app.color_out()) + "\n");
  if (!report.problem.empty()) {
    app.print(fmt::format("  {}: {}\n", red("cannot be run", app.color_out()), report.problem));
  } else if (report.interrupted) {
    app.print("  interrupted\n");
  } else if (expects_nothing(report)) {
    // No expectation is no failure, but no success that counts either.
    app.print("  nothing is expected\n");
  }
  for (const ExpectationItem& item : report.items) {
    app.print(fmt::format("  {:<11}{}{}: {} ({})\n", item.key,
                          coloured(item.standing, app.color_out()), item.expected,
                          printable(item.found), item.method));
  }
}

Json json_of_file(const std::string& file, const ExpectationReport& report) {
  Json json{{"file", file},
            {"passed", report.passed()},
            {"expectations", report.items.size()},
            {"states", report.states}};
  if (!report.problem.empty()) json["problem"] = report.problem;
  if (report.interrupted) json["interrupted"] = true;
  json["items"] = Json::array();
  for (const ExpectationItem& item : report.items) {
    json["items"].push_back({{"key", item.key},
                             {"standing", to_string(item.standing)},
                             {"expected", item.expected},
                             {"found", item.found},
                             {"method", item.method}});
  }
  return json;
}

/// "2 of 3 files are as expected, 1 expects nothing".
std::string summary(std::size_t passed, std::size_t of, std::size_t without) {
  std::string text;
  if (of > 0 || without == 0) {
    text = fmt::format("{} of {} {} as expected", passed, of, of == 1 ? "file is" : "files are");
  }
  if (without > 0) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", without,
                        without == 1 ? "file expects nothing" : "files expect nothing");
  }
  return text + "\n";
}

/// Every order ends in the same structure.
void settle(const RuleSet& rules, const VerifyResult& proof, ExpectationItem& item) {
  if (item.key == "verdict") {
    const bool expected = *rules.expect->verdict == Verdict::coordinated;
    item.standing = expected ? Standing::held : Standing::failed;
    item.found = to_string(Verdict::coordinated);
  } else if (item.key == "bricks") {
    // By its text, as the file says it.
    const bool same = fmt::to_string(proof.structure->size()) == item.expected;
    item.standing = same ? Standing::held : Standing::failed;
  } else if (item.standing == Standing::not_contradicted) {
    item.standing = Standing::held;  // of the only end there is
  }
  item.method = "a proof";
}

/// Two orders end differently. What is expected of every end fails where one of these two has
/// something else; that both have it proves nothing of others.
void settle(const RuleSet& rules, const DivergingOrders& orders, ExpectationItem& item) {
  std::vector<const Structure*> ends = {&orders.first_end};
  if (orders.second_ended) ends.push_back(&orders.second_end);
  const auto fails = [&](const auto& fits) {
    if (!std::all_of(ends.begin(), ends.end(), fits)) item.standing = Standing::failed;
    return item.standing == Standing::failed;
  };
  if (item.key == "verdict") {
    const bool expected = *rules.expect->verdict == Verdict::order_dependent;
    item.standing = expected ? Standing::held : Standing::failed;
    item.found = to_string(Verdict::order_dependent);
  } else if (item.key == "bricks") {
    const auto fits = [&](const Structure* end) {
      return fmt::to_string(end->size()) == item.expected;
    };
    if (!fails(fits)) return;
    item.found = "another number in one of two orders that end differently";
  } else {
    const Structure wanted = to_origin(Structure(rules.lattice, rules.expect->structure));
    if (!fails([&](const Structure* end) { return to_origin(*end) == wanted; })) return;
    item.found = "another structure in one of two orders that end differently";
  }
  item.method = "a proof";
}

/// One order is endless. That others end is not ruled out, but not all of them do.
void settle_endless(const RuleSet& rules, ExpectationItem& item) {
  if (item.key != "verdict") return;
  item.found = "an order that never ends (a proof); " + item.found;
  if (*rules.expect->verdict == Verdict::coordinated) item.standing = Standing::failed;
}

/// What samples and searches have left open, a proof may settle.
void settle_by_proof(const RuleSet& rules, ExpectationReport& report) {
  const auto open = [](const ExpectationItem& item) {
    return item.standing == Standing::not_contradicted || item.standing == Standing::undecided;
  };
  if (std::none_of(report.items.begin(), report.items.end(), open) || !report.problem.empty()) {
    return;
  }
  VerifyOptions options;
  options.box = file_box(rules);
  // The proof is bounded by work; only the user's patience bounds it in time.
  options.stop = &stop_requested();
  const VerifyResult result = verify::verify(rules, options);
  for (ExpectationItem& item : report.items) {
    if (!open(item)) continue;
    switch (result.verdict) {
      case ProofVerdict::proved:
        settle(rules, result, item);
        break;
      case ProofVerdict::refuted:
        settle(rules, *result.refutation, item);
        break;
      case ProofVerdict::endless:
        settle_endless(rules, item);
        break;
      case ProofVerdict::unknown:
        break;
    }
  }
}

}  // namespace

int run(const TestOptions& options, App& app) {
  ExpectationLimits limits;
  if (options.samples) limits.samples = *options.samples;
  if (options.states) limits.search.states = *options.states;
  EventOrdersHooks hooks;
  stop_on_signals();
  hooks.stop = &stop_requested();
  Json all = Json::array();
  int worst = kOk;
  std::size_t passed = 0, without = 0;
  Progress progress(app);
  for (std::size_t i = 0; i < options.files.size() && !stop_requested(); ++i) {
    const std::string& file = options.files[i];
    hooks.progress = [&](std::uint64_t states) {
      progress.show(
          static_cast<double>(i) / static_cast<double>(options.files.size()),
          fmt::format("{}: {} {}", printable(file), states, states == 1 ? "state" : "states"));
    };
    const std::optional<RuleSet> rules = app.read_rules(file);
    ExpectationReport report;
    if (rules) report = verify_expectation(*rules, limits, hooks);
    if (rules && !report.interrupted) settle_by_proof(*rules, report);
    const int code = rules ? exit_code(report) : kFailed;
    progress.clear();
    if (rules && expects_nothing(report)) {
      ++without;
    } else if (code == kOk) {
      ++passed;
    }
    // What failed (1) counts for more than what stayed open (3).
    if (worst != kFailed && code != kOk) worst = code;
    if (!options.json && rules) {
      print_text(file, report, app);
      // A long test shows its files as they come.
      app.flush();
    }
    if (options.json) {
      all.push_back(rules ? json_of_file(file, report)
                          : Json{{"file", file}, {"passed", false}, {"problem", "invalid"}});
    }
  }
  if (options.json) {
    app.print(dump({{"files", all},
                    {"passed", passed},
                    {"of", options.files.size() - without},
                    {"without_expectations", without}}));
  } else {
    app.print(summary(passed, options.files.size() - without, without));
  }
  // Interrupted: what was not tested may have failed.
  return stop_requested() ? kRunFailed : worst;
}

}  // namespace stig::cli
