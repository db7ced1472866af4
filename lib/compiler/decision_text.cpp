// SPDX-License-Identifier: MIT
// Decisions as text and as a graph. Colours are named as the blocks' LEDs show them, so
// that a reader can compare with what robots do.
#include "compiler/decision_text.h"

#include <fmt/format.h>

#include <cstdlib>

namespace stig::compiler {

namespace {

/// A set that was never given LED colours is named by its symbols.
std::string led(const RuleSet& rules, Colour colour) {
  const Brick& brick = rules.brick(colour);
  return brick.led.empty() ? brick.symbol : brick.led;
}

/// Places are described as seen by the robot: before is towards it, left is its left.
std::string place_text(const WindowCell& cell) {
  const char* depth = cell.du < 0 ? "behind" : cell.du > 0 ? "before" : "";
  const char* side = cell.dv > 0 ? "left of" : cell.dv < 0 ? "right of" : "";
  std::string where = fmt::format("{}{}{}", depth, *depth && *side ? " and " : "", side);
  if (where.empty()) where = "in";
  return fmt::format("the cell {} the column, level {}", where, cell.z);
}

/// Depth-first, answers in the order of the tree, so the text has the tree's shape.
void print(const RuleSet& rules, const DecisionNode& node, int indent, std::string& out) {
  const std::string space(static_cast<std::size_t>(indent), ' ');
  if (!node.question) {
    out += placement_text(rules, node.placement) + "\n";
    return;
  }
  out += question_text(*node.question) + "?\n";
  for (const auto& [answers, child] : node.branches) {
    out += fmt::format("{}  {}: ", space, answers_text(rules, *node.question, answers));
    print(rules, *child, indent + 2, out);
  }
}

/// Returns the node's number. Numbers are given in order of visits; each run prints the
/// same graph.
int print_dot(const RuleSet& rules, const DecisionNode& node, int& next, std::string& out) {
  const int number = next++;
  if (!node.question) {
    out += fmt::format("  n{} [shape=box, label=\"{}\"];\n", number,
                       placement_text(rules, node.placement));
    return number;
  }
  out += fmt::format("  n{} [label=\"{}?\"];\n", number, question_text(*node.question));
  for (const auto& [answers, child] : node.branches) {
    const int to = print_dot(rules, *child, next, out);
    out += fmt::format("  n{} -> n{} [label=\"{}\"];\n", number, to,
                       answers_text(rules, *node.question, answers));
  }
  return number;
}

}  // namespace

std::string placement_text(const RuleSet& rules, const std::optional<Placement>& placement) {
  if (!placement) return "nothing";
  const std::string colour = led(rules, placement->colour);
  switch (kind_of(*placement)) {
    case PlacementKind::raise:
      return fmt::format("raise with {}", colour);
    case PlacementKind::extend:
      return placement->at.z == 0
                 ? fmt::format("extend with {}", colour)
                 : fmt::format("extend on level {} with {}", placement->at.z, colour);
    case PlacementKind::beside:
      return fmt::format("put {} to the {} on level {}", colour,
                         placement->at.dv > 0 ? "left" : "right", placement->at.z);
  }
  return {};
}

std::string question_text(const Question& question) {
  switch (question.kind) {
    case Question::Kind::top_colour:
      return "colour of the column's top";
    case Question::Kind::top_level:
      return "level of the column's top";
    case Question::Kind::cell:
      return place_text(question.cell);
    case Question::Kind::side:
      return "side that the robot works from";
  }
  return {};
}

std::string answers_text(const RuleSet& rules, const Question& question,
                         const std::vector<int>& answers) {
  std::string out;
  for (const int answer : answers) {
    if (!out.empty()) out += ", ";
    switch (question.kind) {
      case Question::Kind::top_colour:
        out += led(rules, static_cast<Colour>(answer));
        break;
      case Question::Kind::top_level:
        out += std::to_string(answer);
        break;
      case Question::Kind::cell:
        out +=
            answer == kSeenEmpty ? "empty" : led(rules, static_cast<Colour>(answer - kSeenBrick));
        break;
      case Question::Kind::side:
        out += to_string(static_cast<ApproachSide>(answer));
        break;
    }
  }
  return out;
}

std::string decision_text(const RuleSet& rules, const DecisionNode& root) {
  std::string out;
  print(rules, root, 0, out);
  return out;
}

std::string decision_dot(const RuleSet& rules, const DecisionNode& root) {
  std::string out = "digraph decision {\n  node [fontname=\"DejaVu Sans\"];\n";
  int next = 0;
  print_dot(rules, root, next, out);
  return out + "}\n";
}

}  // namespace stig::compiler
