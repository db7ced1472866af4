// SPDX-License-Identifier: MIT
// Why a rule fires at a site or why not, among bricks that the page has: those that stand at the
// moment it shows.
#include <nlohmann/json.hpp>

#include "answers.h"
#include "explain_report.h"
#include "rules_text.h"

namespace stig::playground {
namespace {

Cell cell_of(const Json& list) { return {list[0], list[1], list[2]}; }

/// [x, y, z, number of the brick], each as structure files have it.
std::optional<Structure> structure_of(const RuleSet& rules, const Json& cells) {
  Structure out(rules.lattice, {});
  for (const Json& cell : cells) {
    const auto colour = cell[3].get<std::size_t>();
    if (colour < 1 || colour > rules.bricks.size() || out.at(cell_of(cell)) != kEmpty) return {};
    out.place(cell_of(cell), static_cast<Colour>(colour));
  }
  return out;
}

}  // namespace

Json explain_answer(const Json& question) {
  Json out;
  const std::optional<RuleSet> rules = read_rules_text(question, out);
  if (!rules) return out;
  const auto structure = structure_of(*rules, question.at("bricks"));
  const int stage = question.value("stage", 1);
  if (!structure || stage < 1 || stage > rules->stage_count()) {
    // The run on show is one of rules that have been edited since.
    out["problem"] = "these bricks are not those of the rules: run them again";
    return out;
  }
  const ExplainedSite scene = explained_site(*rules, *structure, cell_of(question.at("at")), stage);
  out["explain"] = explain_json(scene, std::nullopt);
  out["text"] = explain_text(scene, std::nullopt, false);
  return out;
}

}  // namespace stig::playground
