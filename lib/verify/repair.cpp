// SPDX-License-Identifier: MIT
// Searches for a small change that makes a refuted set provable. Candidates come from the
// refutation: where one order halts and the other has a brick, a rule with exactly the
// halted site's surroundings is added; or one of the two rules at odds is removed. Each
// candidate is verified in full, so a printed repair is a theorem about the repaired set
// and not a heuristic. The breadth-first search tries at most 2 x 8 additions for each
// refutation, three levels deep, within the budget.
#include "verify/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "rules/rule_checks.h"

namespace stig::verify {
namespace {

constexpr std::size_t kMostAdded = 3;    ///< rules of one repair
constexpr std::size_t kMostMissing = 8;  ///< sites tried where an order came to a halt

/// A structure at the end of the stage in which two orders part.
Structure at_stage_end(const RuleSet& rules, const std::vector<Deposit>& order, std::size_t end) {
  assert(end <= order.size());
  Structure structure(rules.lattice, rules.start);
  for (std::size_t i = 0; i < end; ++i) structure.place(order[i].site, order[i].colour);
  return structure;
}

/// An exact pattern matches in this view alone and so disturbs as little else as possible.
/// Users may generalise it.
Rule rule_for(const RuleSet& rules, const View& view, Colour colour, int stage) {
  Rule rule;
  rule.place = colour;
  rule.stage = rules.stage_count() > 1 ? stage : 0;
  const Neighbourhood& n = neighbourhood(rules.lattice);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    rule.pattern.allowed[i] = StateSet::of(view.at[i]);
  }
  // Names must be unique in a rule set; "repair 1" could be the name of an earlier repair.
  std::size_t number = 1;
  const auto taken = [&](const std::string& name) {
    return std::any_of(rules.rules.begin(), rules.rules.end(),
                       [&](const Rule& other) { return other.name == name; });
  };
  do {
    rule.name = fmt::format("repair {}", number++);
  } while (taken(rule.name));
  return rule;
}

class Repairer {
 public:
  Repairer(const RuleSet& rules, const VerifyOptions& options, const Budget& budget)
      : rules_(rules), options_(options), budget_(budget) {}

  std::optional<Repair> find(const VerifyResult& refuted) {
    stage_ = refuted.stage;
    const DivergingOrders& found = *refuted.refutation;
    least_ = rules_.start.size() + std::min(found.first_stage_end, found.second_stage_end);
    std::optional<Repair> repair = search(refuted);
    if (repair && stage_ < repair->repaired.stage_count()) extend_to_the_end(*repair);
    return repair;
  }

 private:
  /// Breadth first: fewer new rules before more. Removals are tried after single additions
  /// and before pairs, since a set that lacks a rule is the more frequent fault.
  std::optional<Repair> search(const VerifyResult& refuted) {
    struct Candidate {
      Repair repair;
      VerifyResult result;
    };
    std::vector<Candidate> level(1);
    level[0].repair.repaired = rules_;
    level[0].result = refuted;
    for (std::size_t added = 0; added < kMostAdded && !level.empty(); ++added) {
      std::vector<Candidate> next;
      for (const Candidate& candidate : level) {
        // A candidate that is refuted again leads on, from its own refutation. One that is
        // unknown or endless is given up.
        for (Repair& repair : additions(candidate.repair, candidate.result)) {
          if (budget_.spent()) return std::nullopt;
          VerifyResult result = verify_up_to(stage_, repair.repaired);
          if (holds(result, repair)) return repair;
          if (result.refutation) next.push_back({std::move(repair), std::move(result)});
        }
      }
      if (added == 0) {
        if (auto repair = removals(*refuted.refutation)) return repair;
      }
      level = std::move(next);
    }
    return std::nullopt;
  }

  /// Proves it for the stages that follow too, if that can be done.
  void extend_to_the_end(Repair& repair) const {
    repair.whole = false;
    if (budget_.spent()) return;
    const VerifyResult result = verify_within(repair.repaired, options_, budget_);
    if (result.verdict != ProofVerdict::proved) return;
    repair.whole = true;
    repair.bricks = result.structure->size();
  }

  /// Verifies a set without its later stages: whether those can be proved is another
  /// question, and proving them costs the budget that the search needs.
  VerifyResult verify_up_to(int stage, RuleSet rules) const {
    std::erase_if(rules.rules, [&](const Rule& rule) { return rule.stage > stage; });
    return verify_within(rules, options_, budget_);
  }
  /// A repair that builds less than either order did is none, nor is one that the reader of
  /// rule sets would refuse. Without the bound on bricks, removing the rule that starts all
  /// growth would repair every set.
  bool holds(const VerifyResult& result, Repair& repair) const {
    if (result.verdict != ProofVerdict::proved || result.structure->size() < least_) return false;
    if (!reaches_stage(repair.repaired)) return false;
    Diagnostics problems;
    check_rule_set(repair.repaired, CheckScope::certain, problems);
    if (problems.has_errors()) return false;
    repair.bricks = result.structure->size();
    return true;
  }
  /// What is proved of the stages up to `stage_` says how that stage ends only if one of its
  /// own rules is left: without any it would not have been run.
  bool reaches_stage(const RuleSet& repaired) const {
    return stage_ == 1 || repaired.stage_count() <= stage_ ||
           std::any_of(repaired.rules.begin(), repaired.rules.end(),
                       [&](const Rule& rule) { return rule.stage == stage_; });
  }

  /// A rule more for each way in which an order can come to a halt before the other.
  std::vector<Repair> additions(const Repair& so_far, const VerifyResult& result) const {
    std::vector<Repair> out;
    // An order that was cut short has no halted sites to begin from.
    if (!result.refutation || !result.refutation->second_ended) return out;
    const DivergingOrders& found = *result.refutation;
    const RuleSet& rules = so_far.repaired;
    const Structure a = at_stage_end(rules, found.first, found.first_stage_end);
    const Structure b = at_stage_end(rules, found.second, found.second_stage_end);
    const RuleTable table(rules);
    for (const auto& [less, more] : {std::pair(&b, &a), std::pair(&a, &b)}) {
      std::vector<View> seen;
      for (const PlacedBrick& brick : more->bricks()) {
        if (less->at(brick.at) != kEmpty || seen.size() >= kMostMissing) continue;
        const View view = view_at(*less, table, options_.box, brick.at);
        // Equal views ask for the same rule. Where a view is empty no brick is beside the
        // cell, and no rule can fire there.
        if (view == View{} || std::find(seen.begin(), seen.end(), view) != seen.end()) continue;
        seen.push_back(view);
        Repair repair = so_far;
        repair.added.push_back(rule_for(rules, view, brick.brick, result.stage));
        repair.repaired.rules.push_back(repair.added.back());
        out.push_back(std::move(repair));
      }
    }
    return out;
  }

  std::optional<Repair> removals(const DivergingOrders& found) const {
    const std::uint32_t rules[] = {found.second[found.common].match.rule, found.rival.match.rule};
    for (const std::uint32_t rule : rules) {
      if (budget_.spent() || rules_.rules.size() < 2) return std::nullopt;
      Repair repair;
      repair.removed = {rule};
      repair.repaired = rules_;
      repair.repaired.rules.erase(repair.repaired.rules.begin() +
                                  static_cast<std::ptrdiff_t>(rule));
      if (holds(verify_up_to(stage_, repair.repaired), repair)) return repair;
    }
    return std::nullopt;
  }

  const RuleSet& rules_;
  const VerifyOptions& options_;
  const Budget& budget_;
  int stage_ = 1;          ///< in which orders part
  std::size_t least_ = 0;  ///< bricks that each order had at its end
};

}  // namespace

std::optional<Repair> find_repair(const RuleSet& rules, const VerifyOptions& options,
                                  const VerifyResult& refuted, const Budget& budget) {
  if (!refuted.refutation) return std::nullopt;
  return Repairer(rules, options, budget).find(refuted);
}

}  // namespace stig::verify
