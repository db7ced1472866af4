// SPDX-License-Identifier: MIT
// What a robot does where, or why it cannot build the structure; the robot's and the block's files
// come with the question, since the page has those that ship.
#include <nlohmann/json.hpp>

#include "answers.h"
#include "compile_report.h"
#include "compiler/block_figures.h"
#include "compiler/compile.h"
#include "robots/robot_reader.h"
#include "rules/worked_from.h"
#include "rules_text.h"
#include "shown_runs.h"
#include "view/lattice_run.h"

namespace stig::playground {
namespace {

std::optional<Abilities> abilities(const Json& question, Json& out) {
  const SourceRef robot_file = source_of(question, "robot"),
                  block_file = source_of(question, "block");
  if (!robot_file || !block_file) return std::nullopt;
  Diagnostics diagnostics;
  const auto robot = read_robot(robot_file, diagnostics);
  const auto block = read_block(block_file, diagnostics);
  add_diagnostics(diagnostics, out);
  if (!robot || !block || !lacking(*robot).empty()) return std::nullopt;
  return abilities_of(*robot, figures_of(*block));
}

/// The moments that a refusal is about, with what is marked in them.
void add_drawings(const RuleSet& rules, const CompiledRules& compiled,
                  const Diagnostics& diagnostics, Json& out) {
  if (compiled.drawings.empty()) return;
  std::vector<std::string> why;
  for (const Diagnostic& one : diagnostics.all()) {
    why.push_back(one.message);
    for (const Note& note : one.notes) why.push_back(note.message);
  }
  PageContent page;
  for (const RefusalDrawing& drawing : compiled.drawings) {
    std::vector<SceneMark> marks;
    for (const RefusalMark& mark : drawing.marks) {
      marks.push_back({mark.at, mark.kind == RefusalMark::Kind::in_the_way, mark.text});
    }
    add_marked_structure(rules, drawing.bricks, drawing.title, marks, why, page);
  }
  add_view(page, out);
}

}  // namespace

Json compile_answer(const Json& question) {
  Json out;
  std::optional<RuleSet> rules = read_rules_text(question, out);
  if (!rules) return out;
  rules = worked_from_own(std::move(*rules), {});
  const std::optional<Abilities> robot = abilities(question, out);
  if (!robot) {
    out["problem"] = "the robot's or the block's file is missing or cannot be used";
    return out;
  }
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(*rules, *robot, {}, diagnostics);
  add_diagnostics(diagnostics, out);
  add_drawings(*rules, compiled, diagnostics, out);
  out["builds"] = compiled.decision != nullptr;
  if (compiled.decision) {
    out["text"] =
        compile_table({&*rules, &*robot, &compiled, plan_controller(*rules, *robot, compiled)});
  }
  return out;
}

}  // namespace stig::playground
