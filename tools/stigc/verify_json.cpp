// SPDX-License-Identifier: MIT
// Views and patterns are drawn as in rule files, since a list of 26 states tells nobody anything;
// what a program wants to know of them it reads from traces.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "rules/rule_printer.h"
#include "verify_report.h"

namespace stig::cli {
namespace {

Json rule_json(const RuleSet& rules, std::uint32_t rule) {
  const Rule& r = rules.rules[rule];
  Json json{{"rule", r.name}};
  // Generated rules have no line.
  if (r.range) json["line"] = r.range.file->position(r.range.begin).line;
  return json;
}

// By name and line, not by number: numbers change when a file is edited.
Json rules_json(const RuleSet& rules, const std::vector<std::uint32_t>& some) {
  Json json = Json::array();
  for (const std::uint32_t rule : some) json.push_back(rule_json(rules, rule));
  return json;
}

Json deposit_json(const RuleSet& rules, const Deposit& deposit, const View& view) {
  Json json = rule_json(rules, deposit.match.rule);
  json["brick"] = symbol_of(rules, StateSet::of(deposit.colour));
  json["at"] = to_json(deposit.site);
  json["sees"] = draw_view(rules, view);
  return json;
}

Json end_json(const Structure& structure, bool ended) {
  // `ended` is false where the second order was stopped with a brick that the first never has.
  return {{"bricks", structure.size()},
          {"structure_hash", to_hex(structure_hash(structure))},
          {"ended", ended}};
}

Json refutation_json(const VerifyReport& report) {
  const DivergingOrders& found = *report.result.refutation;
  // Both deposits are possible in the structure after `common`, and each rules the other out.
  return {{"common_deposits", found.common},
          {"stage", report.result.stage},
          {"ends", Json::array({end_json(found.first_end, true),
                                end_json(found.second_end, found.second_ended)})},
          {"at_odds",
           Json::array({deposit_json(report.rules, found.rival, found.rival_view),
                        deposit_json(report.rules, found.second[found.common], found.view)})}};
}

Json repair_json(const RuleSet& rules, const Repair& repair) {
  Json json{{"bricks", repair.bricks},
            {"all_stages", repair.whole},
            {"without", rules_json(rules, repair.removed)}};
  json["with"] = Json::array();
  // Patterns are drawn with the repaired set's symbols.
  for (const Rule& rule : repair.added) {
    json["with"].push_back({{"place", symbol_of(rules, StateSet::of(rule.place))},
                            {"stage", rule.stage},
                            {"when", draw_pattern(repair.repaired, rule.pattern)}});
  }
  return json;
}

Json findings_json(const VerifyReport& report) {
  const Findings& f = report.findings;
  Json json;
  json["dead_rules"] = rules_json(report.rules, f.dead);
  json["redundant_rules"] = rules_json(report.rules, f.redundant);
  // False also where nothing was proved, since redundancy is a property of proofs.
  json["redundant_rules_complete"] =
      report.result.verdict == ProofVerdict::proved && f.untried == 0;
  json["levels"] = f.level_count;
  json["blocking"] = Json::array();
  for (const Blocking& b : f.blocking) {
    json["blocking"].push_back({{"brick_of", report.rules.rules[b.placed].name},
                                {"at", to_json(b.at)},
                                {"closes", report.rules.rules[b.blocked].name},
                                {"site", to_json(b.site)}});
  }
  if (f.parallelism) {
    json["parallelism"] = {{"rounds", f.parallelism->rounds.size()},
                           {"widest", f.parallelism->widest()},
                           {"mean", f.parallelism->mean()},
                           {"profile", f.parallelism->rounds}};
  }
  json["walled_in"] = Json::array();
  for (const WalledIn& walled : f.walled_in) {
    json["walled_in"].push_back({{"site", to_json(walled.site)}, {"after", walled.order.size()}});
  }
  json["reach_not_shown"] = f.maybe_walled_in;
  if (f.repair) json["repair"] = repair_json(report.rules, *f.repair);
  // Only said where it is not complete.
  if (f.repair_cut_short) json["repair_search_complete"] = false;
  return json;
}

Json brick_json(const RuleSet& rules, const PlacedBrick& brick) {
  return {{"at", to_json(brick.at)}, {"brick", symbol_of(rules, StateSet::of(brick.brick))}};
}

Json bricks_json(const RuleSet& rules, const std::vector<PlacedBrick>& bricks) {
  Json json = Json::array();
  for (const PlacedBrick& brick : bricks) json.push_back(brick_json(rules, brick));
  return json;
}

Json losses_json(const LossResult& losses, const RuleSet& rules) {
  Json json{{"verdict", to_string(losses.verdict)}};
  if (losses.verdict == LossVerdict::unknown) {
    json["explored"] = losses.open;
    json["interrupted"] = losses.interrupted;
    return json;
  }
  json["structures"] = losses.reached.size();
  json["structures_after"] = losses.after.size();
  json["losses"] = losses.losses();
  json["restored"] = losses.restored();
  json["bricks"] = Json::array();
  for (const LostBrick& one : losses.bricks) {
    Json brick = brick_json(rules, one.brick);
    brick["losses"] = one.losses;
    brick["restored"] = one.restored;
    json["bricks"].push_back(std::move(brick));
  }
  if (losses.lasting) {
    json["lasting"] = {{"before", bricks_json(rules, losses.lasting->before)},
                       {"lost", brick_json(rules, losses.lasting->lost)},
                       {"end", bricks_json(rules, losses.lasting->end)}};
  }
  return json;
}

}  // namespace

Json to_json(const VerifyReport& report) {
  const VerifyResult& result = report.result;
  Json json;
  json["ruleset"] = report.rules.name;
  json["ruleset_hash"] = to_hex(rule_set_hash(report.rules));
  json["verdict"] = to_string(result.verdict);
  json["box"] = to_json(report.box);
  if (result.structure) {
    json["bricks"] = result.structure->size();
    json["structure_hash"] = to_hex(structure_hash(*result.structure));
  } else {
    // Both keys are always there.
    json["bricks"] = nullptr;
    json["structure_hash"] = nullptr;
  }
  json["local_states"] = result.local_states;
  json["method"] = result.verdict == ProofVerdict::proved ? Json(to_string(result.method)) : Json();
  // Work is what effort is counted in; it is the same on every machine.
  json["work"] = result.work;
  json["stage"] = result.stage;
  json["interrupted"] = result.interrupted;
  // Set where nothing was decided: how far the search came.
  if (!result.open.empty()) json["explored"] = result.open;
  if (result.refutation) json["refutation"] = refutation_json(report);
  if (result.endless) {
    json["endless"] = {{"after", result.endless->run.size()},
                       {"period", result.endless->period},
                       {"step", to_json(result.endless->step)}};
  }
  json["findings"] = findings_json(report);
  if (report.losses) json["losses"] = losses_json(*report.losses, report.rules);
  return json;
}

}  // namespace stig::cli
