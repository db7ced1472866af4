// SPDX-License-Identifier: MIT
// Emits the program. It is meant to be read: decisions come first, each with the rule's
// name and place in the file, then the chart and the task, then the library's modules. The
// same input gives the same bytes, and a map from lines to rules lets tools show which rule
// a robot follows.
#include "compiler/controller_lua.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/led_name.h"
#include "compiler/decision_text.h"
#include "robots/robot_description.h"

namespace stig::compiler {

namespace {

/// For a comment: one line. Names come from a file and must not end a comment.
std::string plain(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return out;
}

int led_number(const RuleSet& rules, Colour colour) {
  const auto kind = kind_named(rules.brick(colour).led);
  assert(kind && *kind > 0);
  return *kind;
}

std::string cell_text(const WindowCell& cell) {
  return fmt::format("{}, {}, {}", cell.du, cell.dv, cell.z);
}

/// The name that the last line of a module returns: by convention, that of its table.
std::string_view returned_name(std::string_view text) {
  constexpr std::string_view kReturn = "\nreturn ";
  const std::size_t at = text.rfind(kReturn);
  assert(at != text.npos);
  text.remove_prefix(at + kReturn.size());
  return text.substr(0, text.find('\n'));
}

class Printer {
 public:
  Printer(const RuleSet& rules, std::string_view file, const CompiledRules& compiled)
      : rules_(rules), file_(plain(file)), compiled_(compiled) {}

  ControllerText take() { return std::move(out_); }

  void line(const std::string& text = "") {
    out_.text += text + "\n";
    ++lines_;
  }
  void lines(std::string_view text) {
    out_.text += text;
    lines_ += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  /// A file of the library as a table of this one; what it requires is here already.
  /// Requires are dropped because all modules stand in one file, each after those that it
  /// needs.
  void module(std::string_view module) {
    line(fmt::format("local {} = (function()", returned_name(module)));
    for (std::size_t at = 0; at < module.size();) {
      const std::size_t end = std::min(module.find('\n', at), module.size());
      const std::string_view text = module.substr(at, end - at);
      const bool required =
          text.starts_with("local ") && text.find(" = require '") != std::string_view::npos;
      if (!required) line(std::string(text));
      at = end + 1;
    }
    line("end)()");
    line();
  }

  void decide(const DecisionNode& root) {
    line("-- What to do before a column. A rule's name stands where it is followed.");
    line(fmt::format("local function decide({})", root.question ? "column" : "_"));
    node(root, 1);
    line("end");
    line();
  }

 private:
  /// The tree becomes nested ifs; a branch that leads to nothing is left out, so falling
  /// through means that nothing is done.
  void node(const DecisionNode& one, int depth) {
    const std::string space(static_cast<std::size_t>(3 * depth), ' ');
    if (!one.question) {
      if (one.placement) leaf(one, space);
      return;
    }
    std::string_view word = "if";
    for (const auto& [answers, child] : one.branches) {
      if (!child->question && !child->placement) continue;
      std::string condition;
      for (const int answer : answers) {
        if (!condition.empty()) condition += " or ";
        condition += comparison(*one.question, answer);
      }
      line(fmt::format("{}{} {} then", space, word, condition));
      node(*child, depth + 1);
      word = "elseif";
    }
    if (word == "elseif") line(space + "end");
  }

  std::string comparison(const Question& question, int answer) const {
    switch (question.kind) {
      case Question::Kind::top_colour:
        return fmt::format("column.top_colour == {}",
                           led_number(rules_, static_cast<Colour>(answer)));
      case Question::Kind::top_level:
        return fmt::format("column.top_level == {}", answer);
      case Question::Kind::side:
        return fmt::format("column.side == {}",
                           lua_quoted(to_string(static_cast<ApproachSide>(answer))));
      case Question::Kind::cell:
        break;
    }
    const std::string shown =
        answer == kSeenEmpty
            ? "'empty'"
            : std::to_string(led_number(rules_, static_cast<Colour>(answer - kSeenBrick)));
    return fmt::format("column.cell({}) == {}", cell_text(question.cell), shown);
  }

  void leaf(const DecisionNode& one, const std::string& space) {
    const Placement& p = *one.placement;
    constexpr const char* kWhat[] = {"raise", "extend", "beside"};
    std::string text =
        fmt::format("what = '{}', colour = {}", kWhat[static_cast<std::size_t>(kind_of(p))],
                    led_number(rules_, p.colour));
    if (kind_of(p) != PlacementKind::raise) text += fmt::format(", level = {}", p.at.z);
    if (p.at.dv != 0) text += fmt::format(", left = {}", p.at.dv);
    // Its number by which the robot tells those who watch what it has decided.
    text += fmt::format(", branch = {}", ++branches_);
    // A leaf may stand for several rules; each is named, and both its comment and its
    // return are mapped.
    const std::vector<std::uint32_t> names = rules_of(compiled_, one);
    for (const std::uint32_t rule : names) {
      const std::size_t source = source_line(rule);
      line(fmt::format("{}-- {}:{} {}", space, file_, source, plain(rules_.rules[rule].name)));
      out_.lines.push_back({lines_, rule, source});
    }
    line(fmt::format("{}return {{ {} }}", space, text));
    for (const std::uint32_t rule : names) {
      out_.lines.push_back({lines_, rule, source_line(rule)});
    }
  }

  std::size_t source_line(std::uint32_t rule) const {
    const SourceRange& range = rules_.rules[rule].range;
    return range.file ? range.file->position(range.begin).line : 0;
  }

  const RuleSet& rules_;
  std::string file_;
  const CompiledRules& compiled_;
  ControllerText out_;
  std::size_t lines_ = 0;
  int branches_ = 0;
};

void print_chart(Printer& out, const Chart& chart) {
  out.line("-- What follows what: state, what is done in it, and where each of its ends leads.");
  out.line("local CHART = {");
  out.line(fmt::format("   first = {},", lua_quoted(chart.states.front().name)));
  for (const ChartState& state : chart.states) {
    std::string steps;
    for (const ChartStep& step : state.steps) {
      steps += fmt::format("{}{} = {}", steps.empty() ? "" : ", ", step.event, lua_quoted(step.to));
    }
    out.line(fmt::format("   [{}] = {{ does = '{}',", lua_quoted(state.name), state.behaviour));
    out.line(fmt::format("      on = {{ {} }} }},", steps));
  }
  out.line("}");
  out.line();
}

/// Figures with fixed digits, so that the text does not depend on how a number is printed
/// shortest.
void print_task(Printer& out, const ControllerPlan& plan) {
  out.line("local TASK = {");
  out.line("   decide = decide,");
  std::string list;
  for (const WindowCell& cell : plan.asks) list += fmt::format("{{ {} }}, ", cell_text(cell));
  out.line(
      fmt::format("   asks = {{ {}}},  -- cells: towards the robot, to its left, level", list));
  out.line("   looks = {  -- m: from the camera to the column, height of the lift");
  for (const Viewpoint& viewpoint : plan.viewpoints) {
    out.line(fmt::format("      {{ distance = {:.3f}, lift = {:.4f} }},", viewpoint.distance,
                         viewpoint.lift));
  }
  out.line("   },");
  list.clear();
  for (const ApproachSide side : plan.sides) list += lua_quoted(to_string(side)) + ", ";
  out.line(fmt::format("   sides = {{ {}}}, turns = {},", list, plan.turns));
  out.line(fmt::format("   levels = {}, transport = {}, delay = {:.1f},", plan.levels,
                       plan.transport, plan.longest_wait));
  out.line(fmt::format("   starts = {{ {} }},  -- what bricks show that stand at first",
                       fmt::join(plan.starts, ", ")));
  list.clear();
  for (const auto& [cell, kind] : plan.structure) {
    list += fmt::format("{{ {}, {}, {}, {} }}, ", cell.x, cell.y, cell.z, kind);
  }
  out.line(fmt::format("   structure = {{ {}}},  -- in the end: x, y, level, colour", list));
  if (plan.answers) out.line("   answers = true,  -- blocks, when they are told a colour");
  if (plan.kinds > kBlockColours) {
    out.line(fmt::format("   kinds = {},  -- that blocks show as code words", plan.kinds));
  }
  out.line(
      fmt::format("   widest = {:.4f},  -- rad, between a tag's normal and the line to the camera",
                  plan.widest));
  out.line("}");
  out.line();
}

/// What does not depend on where the program runs.
void print_head(Printer& out, const RuleSet& rules, std::string_view file,
                const ControllerPlan& plan, const CompiledRules& compiled) {
  out.line(fmt::format("-- Builds '{}' from the rules in {}.", plain(rules.name), plain(file)));
  out.line(fmt::format("-- Written by stigc compile. Proved: every order of work completes it; {}.",
                       to_string(compiled.directions)));
  out.line("-- First the rules' decisions, then what a robot follows, then the library.");
  out.line();
  out.decide(*plan.decision);
  print_chart(out, *plan.chart);
  print_task(out, plan);
}

}  // namespace

/// Simulator and ARGoS share the head; only what stands around the library differs.
ControllerText controller_lua(const RuleSet& rules, std::string_view file,
                              const ControllerPlan& plan, const CompiledRules& compiled,
                              const std::vector<std::string>& library) {
  assert(plan.chart != nullptr && plan.decision != nullptr);
  Printer out(rules, file, compiled);
  print_head(out, rules, file, plan, compiled);
  for (const std::string& one : library) out.module(one);
  out.lines(
      "local builder\n"
      "local function start() builder = Builder.new(robot, CHART, TASK) end\n"
      "function init() start() end\n"
      "function reset() start() end\n"
      "function step() builder:step() end\n");
  return out.take();
}

ControllerText controller_argos(const RuleSet& rules, std::string_view file,
                                const ControllerPlan& plan, const CompiledRules& compiled,
                                std::string_view description, std::string_view adapter,
                                const std::vector<std::string>& library) {
  assert(plan.chart != nullptr && plan.decision != nullptr);
  Printer out(rules, file, compiled);
  print_head(out, rules, file, plan, compiled);
  out.module(adapter);
  out.lines(
      fmt::format("-- What the library calls math from here on.\n"
                  "local math = argos.math\n"
                  "argos.describe {}\n\n",
                  description));
  for (const std::string& one : library) out.module(one);
  out.lines(
      "local builder\n"
      "local function start()\n"
      "   argos.start()\n"
      "   builder = Builder.new(argos.robot, CHART, TASK)\n"
      "end\n\n"
      "-- ARGoS calls all four.\n"
      "function init() start() end\n"
      "function reset() start() end\n"
      "function step()\n"
      "   argos.sense()\n"
      "   builder:step()\n"
      "end\n"
      "function destroy() end\n");
  return out.take();
}

}  // namespace stig::compiler
