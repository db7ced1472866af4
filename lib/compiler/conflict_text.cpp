// SPDX-License-Identifier: MIT
// Words and drawings for conflicts between robots. A conflict is reported at the rule that
// the second robot follows, with the structures at the moments of both decisions, since the
// point of most conflicts is that a decision was right when it was made.
#include "compiler/conflict_text.h"

#include <cassert>

#include <fmt/format.h>

#include "base/text.h"
#include "rules/cell_text.h"
#include "rules/pattern_text.h"

namespace stig::compiler {

namespace {

/// "the brick at (1, 0, 0) from +x": how all messages name a piece of work.
std::string work_text(const TargetStates& target, const Work& work) {
  return fmt::format("the brick at {} from {}", cell_text(target.cell(work.brick)),
                     to_string(work.side));
}

/// The rule that speaks of the work that the conflict is about.
SourceRange range_of(const RuleSet& rules, const CompiledRules& compiled) {
  assert(!compiled.concurrency.conflicts.empty());
  const Conflict& conflict = compiled.concurrency.conflicts.front();
  const auto& work = conflict.other ? conflict.other : conflict.placed;
  if (!work) return {rules.file, 0, 0};
  const auto since = conflict.other ? conflict.other_decided_in : conflict.decided_in;
  const auto rule = compiled.target->rule_for(compiled.policy.states[since], work->brick);
  return rules.rules[rule.value_or(0)].range;
}

/// Drawings are collected and printed after the diagnostic.
void draw(const RuleSet& rules, CompiledRules& compiled, std::string title, std::uint32_t state) {
  const TargetStates& target = *compiled.target;
  const Conflict& conflict = compiled.concurrency.conflicts.front();
  const std::vector<PlacedBrick> bricks = target.structure(compiled.policy.states[state]).bricks();
  std::vector<RefusalMark> marks;
  for (const auto& work : {conflict.placed, conflict.other}) {
    if (!work || compiled.policy.states[state].has(work->brick)) continue;
    marks.push_back(
        {RefusalMark::Kind::wanted, target.cell(work->brick), work_text(target, *work)});
  }
  if (conflict.column) {
    marks.push_back({RefusalMark::Kind::in_the_way, *conflict.column, "a robot stands before it"});
  }
  compiled.drawings.push_back(
      {std::move(title), draw_structure(rules, bricks), bricks, std::move(marks)});
}

void add_drawings(const RuleSet& rules, CompiledRules& compiled) {
  const Conflict conflict = compiled.concurrency.conflicts.front();
  const TargetStates& target = *compiled.target;
  if (conflict.other && conflict.other_decided_in != conflict.state) {
    draw(rules, compiled, "when one decided on " + work_text(target, *conflict.other),
         conflict.other_decided_in);
  }
  if (conflict.placed && conflict.decided_in != conflict.state) {
    draw(rules, compiled, "when one decided on " + work_text(target, *conflict.placed),
         conflict.decided_in);
  }
  const bool before = conflict.kind != ConflictKind::stuck && conflict.kind != ConflictKind::misled;
  draw(rules, compiled,
       before ? "before one puts " + work_text(target, *conflict.placed)
       : conflict.kind == ConflictKind::stuck ? std::string("stuck")
                                              : std::string("what stands then"),
       conflict.state);
}

}  // namespace

/// Every kind of conflict says what both robots do, in the order in which they do it.
std::string conflict_text(const CompiledRules& compiled, const Conflict& conflict) {
  const TargetStates& target = *compiled.target;
  const auto placed = [&] { return work_text(target, *conflict.placed); };
  const auto stands = [&] {
    return fmt::format("at {}, {}", cell_text(*conflict.column), to_string(conflict.stands_at));
  };
  switch (conflict.kind) {
    case ConflictKind::outdated:
      return fmt::format("one robot decides on {}; another puts {}, and no rule wants the first",
                         work_text(target, *conflict.other), placed());
    case ConflictKind::barred:
      return fmt::format("one robot decides on {}; another puts {}, and the first is out of reach",
                         work_text(target, *conflict.other), placed());
    case ConflictKind::stuck:
      return fmt::format("robots that decide at the same time get stuck: {} bricks of {}",
                         compiled.policy.states[conflict.state].count(), target.bricks());
    case ConflictKind::misled:
      return fmt::format(
          "robots that decide at the same time come to a structure that one alone never sees, in "
          "which one {} does what is wrong",
          stands());
    case ConflictKind::unwalked:
      return fmt::format("a robot puts {} so late that nothing is known of what stands then",
                         placed());
    case ConflictKind::walled_in:
      return fmt::format("a robot {}, is walled in when another puts {}", stands(), placed());
  }
  return {};
}

/// A refusal, a warning or a plain report have the same wording.
std::string robots_text(const CompiledRules& compiled) {
  const Concurrency& found = compiled.concurrency;
  if (found.one_a_side && compiled.robots != 1 && robots_may_work(compiled)) {
    return fmt::format("{} at once, each with sides of its own: no conflict", *compiled.robots);
  }
  if (!found.conflicts.empty()) {
    return "one alone: " + conflict_text(compiled, found.conflicts.front());
  }
  std::string out =
      compiled.local_situations > 0
          ? fmt::format("any number at once: {} decisions that last, whatever others put meanwhile",
                        found.pairs)
          : fmt::format("any number at once: {} pairs of decisions in {} structures, no conflict",
                        found.pairs, found.structures);
  if (found.ways_cross) out += "; ways out cross";
  return out;
}

/// One robot alone never meets a conflict; with an unknown number it is a warning.
bool report_conflict(const RuleSet& rules, CompiledRules& compiled, Diagnostics& diagnostics) {
  if (robots_may_work(compiled)) return false;
  assert(compiled.target != nullptr);
  const Conflict& conflict = compiled.concurrency.conflicts.front();
  const TargetStates& target = *compiled.target;
  Diagnostic& diagnostic =
      diagnostics.add(compiled.robots ? Code::P713 : Code::P714, range_of(rules, compiled),
                      conflict_text(compiled, conflict));
  if (conflict.kind == ConflictKind::barred) diagnostic.note(explain(conflict.reach));
  if (conflict.placed && conflict.decided_in != conflict.state) {
    diagnostic.note(fmt::format("{} was right when it was decided on, {} of {} standing",
                                work_text(target, *conflict.placed),
                                compiled.policy.states[conflict.decided_in].count(),
                                counted(target.bricks(), "brick")));
  }
  diagnostic.note("one robot alone completes it: --robots 1, or `physical: {robots: 1}`");
  if (compiled.concurrency.one_a_side) {
    diagnostic.note(fmt::format("so do up to {}, each with sides of its own: --robots {}",
                                counted(compiled.sides.size(), "robot"), compiled.sides.size()));
  }
  add_drawings(rules, compiled);
  return compiled.robots.has_value();
}

}  // namespace stig::compiler
