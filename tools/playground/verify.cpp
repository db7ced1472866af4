// SPDX-License-Identifier: MIT
// The verdict of `stigc verify`, and what shows it: the structure that is proved, or the orders of
// events that part.
#include <nlohmann/json.hpp>

#include "answers.h"
#include "rules_text.h"
#include "shown_runs.h"
#include "verify_report.h"
#include "view/lattice_run.h"

namespace stig::playground {
namespace {

Structure built_by(const RuleSet& rules, const std::vector<Deposit>& order) {
  Structure structure(rules.lattice, rules.start);
  for (const Deposit& deposit : order) structure.place(deposit.site, deposit.colour);
  return structure;
}

struct Shown {
  const RuleSet& rules;
  const std::optional<Box>& box;
  PageContent page;
  Json traces = Json::array();

  void add(const std::string& name, const std::vector<Deposit>& order) {
    const Trace trace = given_order(rules, box, order, built_by(rules, order));
    add_lattice_run(trace, rules, name, page);
    traces.push_back({{"name", name}, {"stigt", trace_file(rules, trace)}});
  }
};

void show(const VerifyResult& result, Shown& shown) {
  if (result.refutation) {
    shown.add("one end", result.refutation->first);
    shown.add(result.refutation->second_ended ? "another" : "another, still growing",
              result.refutation->second);
  } else if (result.endless) {
    shown.add("and so on", result.endless->run);
  } else if (result.structure) {
    shown.add(result.verdict == ProofVerdict::proved ? "every end" : "one end", result.run);
  }
}

}  // namespace

Json verify_answer(const Json& question) {
  Json out;
  const std::optional<RuleSet> rules = read_rules_text(question, out);
  if (!rules) return out;
  VerifyOptions settings;
  settings.box = file_box(*rules);
  const double effort = effort_of(question);
  settings.work = static_cast<std::uint64_t>(effort * static_cast<double>(settings.work));
  const VerifyResult result = verify::verify(*rules, settings);
  FindingOptions limits;
  limits.work = static_cast<std::uint64_t>(effort * static_cast<double>(limits.work));
  const Findings findings = find_more(*rules, settings, result, limits);
  const VerifyReport report{*rules, settings.box, result, findings};
  out["verify"] = to_json(report);
  out["text"] = to_text(report, false);
  if (result.certificate) out["certificate"] = print_certificate(*result.certificate);
  Shown shown{*rules, settings.box, PageContent(rules->name)};
  show(result, shown);
  if (!shown.traces.empty()) add_view(shown.page, out);
  out["traces"] = std::move(shown.traces);
  return out;
}

}  // namespace stig::playground
