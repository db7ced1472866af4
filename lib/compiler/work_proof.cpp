// SPDX-License-Identifier: MIT
// Puts the compiler's terms into those of the certificate: sides in turn, answers as colours,
// bricks in the order in which they are certain to go on.
#include "compiler/work_proof.h"

#include <algorithm>
#include <cassert>

#include "compiler/precedence.h"
#include "rules/rule_printer.h"

namespace stig::compiler {

namespace {

int number_of(ApproachSide side) {
  const auto found = std::find(kSideNames.begin(), kSideNames.end(), to_string(side));
  assert(found != kSideNames.end());
  return static_cast<int>(found - kSideNames.begin());
}

int answer_of(const Question& question, int answer) {
  if (question.kind == Question::Kind::side) return number_of(static_cast<ApproachSide>(answer));
  if (question.kind != Question::Kind::cell) return answer;
  return answer == kSeenEmpty ? 0 : answer - kSeenBrick;
}

WorkNode::Kind kind_of_node(Question::Kind kind) {
  switch (kind) {
    case Question::Kind::top_colour:
      return WorkNode::Kind::top_colour;
    case Question::Kind::top_level:
      return WorkNode::Kind::top_level;
    case Question::Kind::cell:
      return WorkNode::Kind::cell;
    case Question::Kind::side:
      break;
  }
  return WorkNode::Kind::side;
}

std::uint32_t add_node(const DecisionNode& from, std::vector<WorkNode>& out) {
  const auto number = static_cast<std::uint32_t>(out.size());
  out.emplace_back();
  WorkNode node;
  if (!from.question) {
    node.kind = from.placement ? WorkNode::Kind::put : WorkNode::Kind::nothing;
    if (from.placement) {
      const Placement& put = *from.placement;
      node.cell = {put.at.du, put.at.dv, put.at.z};
      node.colour = put.colour;
    }
  } else {
    node.kind = kind_of_node(from.question->kind);
    const WindowCell& cell = from.question->cell;
    if (node.kind == WorkNode::Kind::cell) node.cell = {cell.du, cell.dv, cell.z};
    for (const auto& [answers, child] : from.branches) {
      std::vector<int> is;
      for (const int answer : answers) is.push_back(answer_of(*from.question, answer));
      const std::uint32_t to = add_node(*child, out);
      node.branches.emplace_back(std::move(is), to);
    }
  }
  out[number] = std::move(node);
  return number;
}

/// Of the bricks that come before one, those that come before no other of them; rising in `place`.
std::vector<std::uint32_t> just_before(const Precedence& precedence, std::uint32_t brick,
                                       const std::vector<std::uint32_t>& order,
                                       const std::vector<std::uint32_t>& place, std::size_t start) {
  std::vector<std::uint32_t> out;
  BrickSet left = precedence.below(brick);
  left.remove(brick);
  for (std::uint32_t i = place[brick]; i-- > start;) {
    if (!left.has(order[i])) continue;
    out.push_back(i);
    left.remove(precedence.below(order[i]));
  }
  std::reverse(out.begin(), out.end());
  return out;
}

void add_ordered(const CompiledRules& compiled, WorkCertificate& out) {
  const TargetStates& target = *compiled.target;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < target.start_bricks(); ++i) order.push_back(i);
  for (const WayOn& one : compiled.ways_on) order.push_back(one.brick);
  assert(order.size() == target.bricks());
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (std::size_t i = 0; i < order.size(); ++i) {
    WorkBrick one;
    one.brick = {target.cell(order[i]), target.colour(order[i])};
    if (i >= out.start) {
      const WayOn& way = compiled.ways_on[i - out.start];
      one.side = number_of(way.side);
      one.column = {way.du, way.dv, 0};
      one.after = just_before(*compiled.precedence, order[i], order, place, out.start);
    }
    out.bricks.push_back(std::move(one));
  }
}

}  // namespace

WorkCertificate certificate_of_work(const RuleSet& rules, const CompiledRules& compiled,
                                    const ControllerPlan& plan) {
  assert(compiled.decision != nullptr);
  WorkCertificate out;
  out.rule_set_hash = rule_set_hash(rules);
  const Concurrency& found = compiled.concurrency;
  out.crowd = found.conflicts.empty() ? WorkCrowd::any
              : found.one_a_side      ? WorkCrowd::one_a_side
                                      : WorkCrowd::one;
  for (const ApproachSide side : compiled.sides) out.sides.push_back(number_of(side));
  for (const Viewpoint& look : plan.viewpoints) out.looks.push_back({look.distance, look.lift});
  add_node(*compiled.decision, out.nodes);
  out.start = compiled.target->start_bricks();
  out.ordered = compiled.local_situations > 0;
  if (out.ordered) {
    add_ordered(compiled, out);
  } else {
    for (std::size_t i = 0; i < compiled.target->bricks(); ++i) {
      WorkBrick one;
      one.brick = {compiled.target->cell(i), compiled.target->colour(i)};
      out.bricks.push_back(std::move(one));
    }
  }
  return out;
}

}  // namespace stig::compiler
