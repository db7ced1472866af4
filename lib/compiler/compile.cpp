// SPDX-License-Identifier: MIT
// The order of the compiler's steps and the diagnostics of each (compile.h). Everything
// that can be refused without walking structures is refused first: the proof, the form of
// the rules, colours, heights. Then a policy is sought, by the local proof first where
// structures are many, and by the walk first where they are few: the walk finds more, and
// its number of structures can double with each brick.
#include "compiler/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/led_name.h"
#include "base/text.h"
#include "compiler/conflict_text.h"
#include "compiler/local_policy.h"
#include "compiler/refusal.h"
#include "rules/rule_printer.h"
#include "sensing/led_code.h"

namespace stig::compiler {

namespace {

SourceRange whole(const RuleSet& rules) { return {rules.file, 0, 0}; }

/// A box of the file plays no part: robots cannot perceive where it ends.
bool report_proof(const RuleSet& rules, const VerifyResult& proof, Diagnostics& out) {
  if (proof.verdict == ProofVerdict::proved) return true;
  const char* what =
      proof.verdict == ProofVerdict::refuted
          ? "not every order of events ends in the same structure"
      : proof.verdict == ProofVerdict::endless
          ? "building can go on for ever"
          : "it was not proved that every order of events ends in the same structure";
  Diagnostic& diagnostic = out.add(Code::P701, whole(rules), what);
  if (!proof.open.empty()) diagnostic.note(proof.open);
  if (rules.box) diagnostic.note("the file's box does not count: no robot knows where it ends");
  diagnostic.note(fmt::format("`stigc verify` shows more"));
  return false;
}

/// What no robot of this kind could do, whatever its measures. Every such reason is
/// reported, not only the first, except for stages, of which one says it all.
bool report_form(const RuleSet& rules, Diagnostics& out) {
  bool sound = true;
  if (rules.lattice != Lattice::cubic) {
    out.add(Code::P702, whole(rules), "blocks are cubes: robots build on the cubic lattice alone");
    sound = false;
  }
  for (const Rule& rule : rules.rules) {
    if (rule.stage == 0 || rules.stage_count() == 1) continue;
    out.add(Code::P703, rule.range,
            fmt::format("rule '{}' belongs to stage {}, and no robot knows which stage it is",
                        rule.name, rule.stage));
    sound = false;
    break;
  }
  return sound;
}

bool report_colours(const RuleSet& rules, Diagnostics& out) {
  bool sound = true;
  const auto lit = static_cast<std::size_t>(std::max(kBlockColours, rules.colours()));
  for (std::size_t i = 0; i < rules.bricks.size(); ++i) {
    const Brick& brick = rules.bricks[i];
    if (brick.led.empty()) {
      out.add(Code::P704, brick.range,
              fmt::format("brick '{}' has no block colour: give it one with `led: Q1` to {}",
                          brick.symbol, kLedNames[lit]));
      sound = false;
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (brick.led.empty() || rules.bricks[k].led != brick.led) continue;
      out.add(Code::P704, brick.range,
              fmt::format("bricks '{}' and '{}' show the same block colour {}",
                          rules.bricks[k].symbol, brick.symbol, brick.led));
      sound = false;
    }
  }
  return sound;
}

/// The proof's run has every brick with the rule that placed it, so the message can point
/// at that rule.
bool report_height(const RuleSet& rules, const Abilities& robot, const TargetStates& target,
                   const VerifyResult& proof, Diagnostics& out) {
  if (rules.floor && target.floor_level() > 0) {
    out.add(Code::P709, whole(rules),
            fmt::format("the lowest brick is on level {}, and nothing is below it",
                        target.floor_level()));
    return false;
  }
  for (const Deposit& deposit : proof.run) {
    const int level = deposit.site.z - target.floor_level();
    if (level < robot.levels) continue;
    out.add(Code::P705, rules.rules[deposit.match.rule].range,
            fmt::format("rule '{}' places a brick on level {}, and the robot reaches level {}",
                        rules.rules[deposit.match.rule].name, level, robot.levels - 1))
        .note(fmt::format("the lift would have to go to {:.0f} mm, it goes to {:.1f} mm",
                          1e3 * robot.lift_for(level), 1e3 * robot.lift_travel));
    return false;
  }
  return true;
}

/// Rules that hold in all quarter turns make the sides interchangeable.
bool turns(const RuleSet& rules) {
  return std::all_of(rules.rules.begin(), rules.rules.end(),
                     [&](const Rule& rule) { return rules.symmetry_of(rule) != Symmetry::none; });
}

/// The sides' order is part of the program that is emitted, and therefore fixed.
void choose_sides(const RuleSet& rules, const CompileOptions& options, CompiledRules& out) {
  std::vector<ApproachSide> wanted = options.sides;
  if (wanted.empty() && rules.physical) {
    for (const std::string& text : rules.physical->sides) {
      if (const auto side = parse_side(text)) wanted.push_back(*side);
    }
  }
  const bool declared = !wanted.empty();
  // in turn about the structure, whatever order they were named in
  std::copy_if(kAllSides.begin(), kAllSides.end(), std::back_inserter(out.sides),
               [&](ApproachSide side) {
                 return !declared || std::find(wanted.begin(), wanted.end(), side) != wanted.end();
               });
  out.directions = turns(rules) ? KnownDirections::symmetric
                   : declared   ? KnownDirections::declared
                                : KnownDirections::shown;
}

void report_shared_sides(const RuleSet& rules, const CompiledRules& compiled, Diagnostics& out) {
  const std::size_t sides = compiled.sides.size();
  if (!compiled.robots || *compiled.robots <= static_cast<int>(sides)) return;
  out.add(Code::P715, whole(rules),
          fmt::format("{} robots work from {}: some share one, or stand by", *compiled.robots,
                      counted(sides, "side")))
      .note("that robots keep out of each other's way on one side is neither proved nor likely");
}

}  // namespace

Abilities seeing(int kinds, Abilities robot) {
  robot.block.leds_needed = sensing::leds_needed(std::max(1, kinds));
  return robot;
}

std::string_view to_string(KnownDirections directions) {
  switch (directions) {
    case KnownDirections::symmetric:
      return "the rules hold in every turn";
    case KnownDirections::declared:
      return "assumed: robots work from the declared sides alone";
    case KnownDirections::shown:
      return "the structure shows it at every decision";
  }
  return {};
}

bool robots_may_work(const CompiledRules& compiled) {
  if (compiled.robots == 1 || compiled.concurrency.conflicts.empty()) return true;
  return compiled.concurrency.one_a_side && compiled.own_sides && compiled.robots &&
         *compiled.robots <= static_cast<int>(compiled.sides.size());
}

/// Examples of structures that a local proof has collected are not counted as all.
std::size_t structures_on_the_way(const CompiledRules& compiled) {
  if (compiled.local_situations > 0) return 0;
  return static_cast<std::size_t>(
      std::count(compiled.policy.reached.begin(), compiled.policy.reached.end(), true));
}

std::string completion_text(const CompiledRules& compiled) {
  if (compiled.local_situations > 0) {
    return fmt::format("every order of work completes it: {} before a column can occur",
                       counted(compiled.local_situations, "situation"));
  }
  return fmt::format("every order of work completes it: {} can occur on the way",
                     counted(structures_on_the_way(compiled), "structure"));
}

/// What policies may rest on, the least first. What lies straight ahead is enough for most; which
/// side it is, a robot knows only from where it began.
std::vector<PolicyScope> policy_scopes(const CompiledRules& compiled) {
  std::vector<PolicyScope> out = {{PlacementKinds::ahead, false}, {PlacementKinds::all, false}};
  if (compiled.directions == KnownDirections::declared && compiled.sides.size() > 1) {
    out.push_back({PlacementKinds::ahead, true});
    out.push_back({PlacementKinds::all, true});
  }
  return out;
}

namespace {

/// By a walk over all structures; false when there are too many. A scope that knows less is
/// better, since robots then need less; so the first that gives a decision is taken.
bool walk_structures(const Abilities& robot, const CompileOptions& options, CompiledRules& out) {
  for (const PolicyScope& scope : policy_scopes(out)) {
    out.policy = explore(*out.target, robot, out.sides, scope, options.limits);
    if (out.policy.too_large) return false;
    out.decision = settle(*out.target, out.policy);
    if (!out.decision) continue;
    out.decision = simplify(*out.target, out.policy, std::move(out.decision));
    out.concurrency = check_concurrency(*out.target, robot, out.policy, *out.decision);
    break;
  }
  return true;
}

/// What a proof column by column found.
struct LocalProof {
  Policy policy;
  std::unique_ptr<DecisionNode> decision;
  Concurrency concurrency;
  std::size_t situations = 0;
};

LocalProof taken_from(CompiledRules& compiled) {
  LocalProof out{std::move(compiled.policy), std::move(compiled.decision),
                 std::move(compiled.concurrency), compiled.local_situations};
  compiled.policy = {};
  compiled.decision.reset();
  compiled.concurrency = {};
  compiled.local_situations = 0;
  return out;
}

void put_back(LocalProof proof, CompiledRules& compiled) {
  compiled.policy = std::move(proof.policy);
  compiled.decision = std::move(proof.decision);
  compiled.concurrency = std::move(proof.concurrency);
  compiled.local_situations = proof.situations;
}

/// What can be done where, by the one way or the other; false when there are too many structures
/// for either.
bool find_decision(const Abilities& robot, const CompileOptions& options, CompiledRules& out) {
  if (out.target->bricks() <= kMostWalkedFirst) {
    return walk_structures(robot, options, out) || settle_locally(robot, options.limits, out);
  }
  const bool local = settle_locally(robot, options.limits, out);
  if (local && robots_may_work(out)) return true;
  // A walk may find several robots no harm where this does: both err on the side of
  // conflicts between robots, the walk less so.
  LocalProof proof = taken_from(out);
  const bool walked = walk_structures(robot, options, out);
  if (!local || (walked && out.decision)) return walked;
  put_back(std::move(proof), out);
  return true;
}

}  // namespace

CompiledRules compile_rules(const RuleSet& rules, const Abilities& abilities,
                            const CompileOptions& options, Diagnostics& diagnostics) {
  CompiledRules out;
  const Abilities robot = seeing(rules.highest_kind(), abilities);
  choose_sides(rules, options, out);
  out.robots = options.robots;
  out.own_sides = options.own_sides;
  if (!out.robots && rules.physical) out.robots = rules.physical->robots;
  const bool form = report_form(rules, diagnostics);
  if (!report_colours(rules, diagnostics) || !form) return out;
  out.proof = verify::verify(rules, options.verify);
  if (!report_proof(rules, out.proof, diagnostics)) {
    out.unknown = out.proof.verdict == ProofVerdict::unknown;
    return out;
  }
  out.target = std::make_unique<TargetStates>(rules, out.proof);
  if (!report_height(rules, robot, *out.target, out.proof, diagnostics) ||
      report_shut_in(rules, robot, out, diagnostics)) {
    return out;
  }
  const bool known = find_decision(robot, options, out);
  // An interruption is no refusal: nothing is reported.
  if (options.limits.stop != nullptr && options.limits.stop->load()) {
    out.decision.reset();
    return out;
  }
  out.unknown = !known;
  if (!known) {
    diagnostics
        .add(Code::P712, whole(rules),
             fmt::format("more than {} structures can occur on the way; nothing was proved",
                         options.limits.states))
        .note("--states N sets the limit; working from fewer sides leaves fewer");
    return out;
  }
  if (out.decision) {
    if (report_conflict(rules, out, diagnostics)) out.decision.reset();
    if (out.decision) report_shared_sides(rules, out, diagnostics);
    return out;
  }
  explain_refusal(rules, robot, out, diagnostics);
  return out;
}

}  // namespace stig::compiler
