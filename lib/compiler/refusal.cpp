// SPDX-License-Identifier: MIT
// Explains why there is no complete policy. Of the many withdrawals that led there, the one
// is chosen that the author can act on: a brick that no robot can ever place, a structure
// from which there is no way on, or two situations that a robot cannot tell apart. Each is
// shown by drawings of the structures that it is about.
#include "compiler/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>

#include "base/text.h"
#include "compiler/decision_text.h"
#include "rules/cell_text.h"
#include "rules/pattern_text.h"

namespace stig::compiler {

namespace {

void add_never(const Rule& rule, Cell at, Code code, const std::vector<std::string>& notes,
               Diagnostics& out) {
  Diagnostic& diagnostic =
      out.add(code, rule.range,
              fmt::format("rule '{}' places the brick at {}, which {}", rule.name, cell_text(at),
                          code == Code::P709 ? "nothing would hold"
                                             : "no robot can put there in any order of work"));
  for (const std::string& note : notes) diagnostic.note(note);
}

/// The brick that keeps a robot of this side from a site; nothing where it is none that does.
std::optional<RefusalMark> mark_of(const ReachResult& result, ApproachSide side) {
  const bool stands = result.obstruction == Obstruction::body_blocked ||
                      result.obstruction == Obstruction::effector_blocked ||
                      result.obstruction == Obstruction::held_off ||
                      result.obstruction == Obstruction::covered;
  if (!stands) return std::nullopt;
  return RefusalMark{RefusalMark::Kind::in_the_way, result.where,
                     fmt::format("from {}: {}", to_string(side), explain(result))};
}

/// The site of a brick that is wanted, with the rule that wants it.
RefusalMark wanted_mark(Cell at, const std::string& text) {
  return {RefusalMark::Kind::wanted, at, text};
}

class Explainer {
 public:
  Explainer(const RuleSet& rules, const Abilities& robot, CompiledRules& compiled, Diagnostics& out)
      : rules_(rules),
        robot_(robot),
        compiled_(compiled),
        policy_(compiled.policy),
        target_(*compiled.target),
        out_(out) {}

  void explain() {
    if (policy_.out_of_reach) {
      explain_reach();
    } else {
      explain_sight();
    }
  }

 private:
  /// The fullest structure from which nothing goes on; the policy has set it.
  const BrickSet& stuck() const {
    assert(policy_.stuck);
    return policy_.states[*policy_.stuck];
  }

  std::string draw(const BrickSet& state) const {
    return draw_structure(rules_, target_.structure(state).bricks());
  }
  void show(std::string title, const BrickSet& state, std::vector<RefusalMark> marks = {}) {
    compiled_.drawings.push_back(
        {std::move(title), draw(state), target_.structure(state).bricks(), std::move(marks)});
  }
  const Rule& rule_of(const BrickSet& state, std::uint32_t brick) const {
    return rules_.rules[target_.rule_for(state, brick).value_or(0)];
  }

  /// Bricks that some situation places. A brick that no explored structure contains cannot
  /// be placed in any order of work.
  std::vector<bool> ever_placed() const {
    std::vector<bool> out(target_.bricks(), false);
    for (const BrickSet& state : policy_.states) {
      for (std::size_t i = 0; i < out.size(); ++i) out[i] = out[i] || state.has(i);
    }
    return out;
  }

  /// Would a robot that is stuck place the brick next to a column that it faces from this side?
  bool faced(std::uint32_t brick, ApproachSide side) const {
    for (std::size_t i = policy_.first[*policy_.stuck]; i < policy_.first[*policy_.stuck + 1];
         ++i) {
      const Situation& situation = policy_.situations[i];
      if (situation.side != side) continue;
      for (const auto& [placement, to] : situation.placements) {
        if (policy_.states[to].has(brick)) return true;
      }
    }
    return false;
  }

  /// Why a brick cannot be placed from any of the sides, when a robot is stuck; notes of each.
  struct Blocked {
    bool unsupported = true;
    std::vector<std::string> notes;
    std::vector<RefusalMark> marks;
  };
  /// Sides are listed with a reason each, so that it is seen which of them comes closest.
  Blocked blocked(std::uint32_t brick) const {
    Blocked out;
    for (const ApproachSide side : compiled_.sides) {
      const ReachResult result = reach(target_, stuck(), target_.cell(brick), side, robot_);
      out.unsupported = out.unsupported && is_unheld(result.obstruction);
      const bool alone = result.obstruction == Obstruction::none && !faced(brick, side);
      out.notes.push_back(fmt::format(
          "from {}: {}", to_string(side),
          alone ? "it is not on, before or beside any column that the robot can drive up to"
                : compiler::explain(result)));
      if (const auto mark = mark_of(result, side)) out.marks.push_back(*mark);
    }
    out.marks.push_back(
        wanted_mark(target_.cell(brick), "wanted here: " + rule_of(stuck(), brick).name));
    return out;
  }

  /// Somebody who knew everything could not complete it either. First a brick that is never
  /// placed in any structure, since that is the plainest reason.
  void explain_reach() {
    const std::vector<bool> placed = ever_placed();
    for (const std::uint32_t brick : target_.open(stuck())) {
      if (!placed[brick]) return report_never(brick);
    }
    report_deadlock();
  }

  void report_never(std::uint32_t brick) {
    const Blocked why = blocked(brick);
    add_never(rule_of(stuck(), brick), target_.cell(brick),
              why.unsupported ? Code::P709 : Code::P710, why.notes, out_);
    show("the structure at that moment", stuck(), why.marks);
  }

  void report_deadlock() {
    const std::vector<std::uint32_t> open = target_.open(stuck());
    const Rule& rule = open.empty() ? rules_.rules.front() : rule_of(stuck(), open.front());
    Diagnostic& diagnostic =
        out_.add(Code::P711, rule.range,
                 fmt::format("the structure cannot be completed: {} of {} and no way on",
                             stuck().count(), counted(target_.bricks(), "brick")));
    std::vector<RefusalMark> marks;
    for (const std::uint32_t brick : open) {
      const Blocked why = blocked(brick);
      for (const std::string& note : why.notes) {
        diagnostic.note(fmt::format("the brick at {} {}", cell_text(target_.cell(brick)), note));
      }
      marks.insert(marks.end(), why.marks.begin(), why.marks.end());
    }
    show("stuck", stuck(), std::move(marks));
    if (const Withdrawal* cause = dead_end()) report_dead_end(*cause, diagnostic);
  }

  /// A placement that is within reach of a robot that is stuck, and was given up since it leads to
  /// a dead end where the same is seen.
  const Withdrawal* dead_end() const {
    for (std::size_t i = policy_.first[*policy_.stuck]; i < policy_.first[*policy_.stuck + 1];
         ++i) {
      const Situation& situation = policy_.situations[i];
      for (const auto& [placement, to] : situation.placements) {
        const Withdrawal* found = withdrawal(situation.observation, placement);
        if (found != nullptr && found->reason == Withdrawal::Reason::dead_end) return found;
      }
    }
    return nullptr;
  }

  void report_dead_end(const Withdrawal& cause, Diagnostic& diagnostic) {
    const Situation& there = policy_.situations[cause.here];
    diagnostic.note(fmt::format(
        "what is within reach was given up: elsewhere, from {} before the column at {}, the same "
        "is "
        "seen, and the brick at {} would leave no way on",
        to_string(there.side), column(there), cell_text(site_of(there, cause.placement))));
    show(fmt::format("there, seen from {}", to_string(there.side)), policy_.states[there.state],
         {wanted_mark(site_of(there, cause.placement), "it would leave no way on")});
  }

  /// It could be completed, but not by what a robot sees. Withdrawals at the stuck
  /// structure are what keeps a robot from going on there.
  void explain_sight() {
    const Withdrawal* cause = nullptr;
    for (std::size_t i = policy_.first[*policy_.stuck]; i < policy_.first[*policy_.stuck + 1];
         ++i) {
      const Situation& situation = policy_.situations[i];
      for (const auto& [placement, to] : situation.placements) {
        const Withdrawal* found = withdrawal(situation.observation, placement);
        // Directions first: without them nothing else helps.
        if (found != nullptr && (cause == nullptr || (across(*found) && !across(*cause)))) {
          cause = found;
        }
      }
    }
    if (cause == nullptr || cause->reason == Withdrawal::Reason::dead_end) return report_deadlock();
    report_alike(*cause);
  }

  const Withdrawal* withdrawal(std::uint32_t observation, const Placement& placement) const {
    for (const Withdrawal& one : policy_.withdrawn) {
      if (one.observation == observation && one.placement == placement) return &one;
    }
    return nullptr;
  }

  /// Are the two situations seen from different sides?
  bool across(const Withdrawal& one) const {
    return one.reason != Withdrawal::Reason::dead_end &&
           policy_.situations[one.here].side != policy_.situations[one.there].side;
  }

  /// Sides come first: a robot without a compass is helped by declaring them. A hidden cell
  /// and plain ambiguity are told apart by whether a difference lies within the window.
  Code code_of(const Withdrawal& cause) const {
    if (compiled_.directions != KnownDirections::symmetric && across(cause)) return Code::P706;
    return hidden_cell(cause) ? Code::P708 : Code::P707;
  }

  /// A cell that differs between the two situations and is seen in neither.
  std::optional<WindowCell> hidden_cell(const Withdrawal& cause) const {
    const Situation &a = policy_.situations[cause.here], &b = policy_.situations[cause.there];
    const Observation& seen = policy_.observations[a.observation];
    for (std::size_t i = 0; i < seen.cells.size(); ++i) {
      const WindowCell cell = window_cell(i);
      if (content(a, cell) != content(b, cell)) return cell;
    }
    return std::nullopt;
  }
  Colour content(const Situation& at, const WindowCell& cell) const {
    const std::uint32_t brick = target_.brick_at(
        cell_from(at.side, {at.u + cell.du, at.v + cell.dv, cell.z + target_.floor_level()}));
    const bool there = brick != TargetStates::kNone && policy_.states[at.state].has(brick);
    return there ? target_.colour(brick) : Colour{0};
  }

  void report_alike(const Withdrawal& cause) {
    const Situation &here = policy_.situations[cause.here],
                    &there = policy_.situations[cause.there];
    const Cell site = site_of(here, cause.placement);
    const std::uint32_t brick = target_.brick_at(site);
    const Rule& rule = rule_of(policy_.states[here.state], brick);
    const Code code = code_of(cause);
    Diagnostic& diagnostic = out_.add(code, rule.range, sentence(code, rule, cause));
    diagnostic.note(fmt::format("from {} before the column at {}: right at {}",
                                to_string(here.side), column(here), cell_text(site)));
    diagnostic.note(fmt::format("from {} before the column at {}: wrong, and it looks the same",
                                to_string(there.side), column(there)));
    if (code == Code::P706) {
      diagnostic.note(
          "`physical: {sides: [+x]}` in the file, or --sides +x, says that robots work "
          "from that side alone; `symmetry: rotations` makes the rules hold on all");
    }
    show(fmt::format("seen from {}", to_string(here.side)), policy_.states[here.state],
         {wanted_mark(site, "right here: " + rule.name)});
    show(fmt::format("seen from {}", to_string(there.side)), policy_.states[there.state],
         {wanted_mark(site_of(there, cause.placement), "wrong here, and it looks the same")});
  }

  Cell site_of(const Situation& at, const Placement& placement) const {
    SideCell site{at.u + placement.at.du, at.v + placement.at.dv,
                  placement.at.z + target_.floor_level()};
    // The level of a placement on top is that of the first free cell.
    if (kind_of(placement) == PlacementKind::raise) {
      while (target_.filled(policy_.states[at.state], cell_from(at.side, site))) ++site.z;
    }
    return cell_from(at.side, site);
  }

  std::string sentence(Code code, const Rule& rule, const Withdrawal& cause) const {
    if (code == Code::P706) {
      return fmt::format(
          "a robot has no compass: rule '{}' is right from {} and wrong from {}, "
          "which looks the same",
          rule.name, to_string(policy_.situations[cause.here].side),
          to_string(policy_.situations[cause.there].side));
    }
    if (code == Code::P708) {
      const WindowCell cell = *hidden_cell(cause);
      return fmt::format(
          "rule '{}' depends on a cell that the robot cannot see from where it stands: {}",
          rule.name, question_text({Question::Kind::cell, cell}));
    }
    return fmt::format(
        "rule '{}' is right in one structure and wrong in another that looks the "
        "same from where the robot stands",
        rule.name);
  }

  std::string column(const Situation& at) const {
    const Cell cell = cell_from(at.side, {at.u, at.v, target_.floor_level()});
    return fmt::format("({}, {})", cell.x, cell.y);
  }

  const RuleSet& rules_;
  const Abilities& robot_;
  CompiledRules& compiled_;
  const Policy& policy_;
  const TargetStates& target_;
  Diagnostics& out_;
};

}  // namespace

/// Bricks of the start never go away, so what they obstruct is obstructed for good;
/// overhangs may get support later.
bool report_shut_in(const RuleSet& rules, const Abilities& robot, CompiledRules& compiled,
                    Diagnostics& diagnostics) {
  assert(compiled.target != nullptr);
  const TargetStates& target = *compiled.target;
  const BrickSet start = target.start();
  for (std::size_t i = target.start_bricks(); i < target.bricks(); ++i) {
    std::vector<std::string> notes;
    std::vector<RefusalMark> marks;
    for (const ApproachSide side : compiled.sides) {
      const ReachResult result = reach(target, start, target.cell(i), side, robot);
      if (result.obstruction == Obstruction::none || is_unheld(result.obstruction)) break;
      notes.push_back(fmt::format("from {}: {}", to_string(side), explain(result)));
      if (const auto mark = mark_of(result, side)) marks.push_back(*mark);
    }
    if (notes.size() < compiled.sides.size()) continue;
    const std::size_t placed = i - target.start_bricks();
    const Rule& rule = rules.rules[compiled.proof.run[placed].match.rule];
    add_never(rule, target.cell(i), Code::P710, notes, diagnostics);
    marks.push_back(wanted_mark(target.cell(i), "wanted here: " + rule.name));
    compiled.policy.out_of_reach = true;
    const std::vector<PlacedBrick> bricks = target.structure(start).bricks();
    compiled.drawings.push_back({"the start", draw_structure(rules, bricks), bricks, marks});
    return true;
  }
  return false;
}

void explain_refusal(const RuleSet& rules, const Abilities& robot, CompiledRules& compiled,
                     Diagnostics& diagnostics) {
  assert(compiled.target != nullptr);
  Explainer(rules, robot, compiled, diagnostics).explain();
}

}  // namespace stig::compiler
