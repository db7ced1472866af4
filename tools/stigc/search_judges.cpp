// SPDX-License-Identifier: MIT
#include "search_judges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/hash.h"
#include "base/load.h"
#include "base/text.h"
#include "compiler/compile.h"
#include "lua/lua_score.h"
#include "robot_input.h"
#include "robots/robot_reader.h"
#include "scene_input.h"
#include "search/objectives.h"
#include "search/plan_reader.h"

namespace stig::cli {
namespace {

/// Structures that the compiler may walk for a candidate: a fraction of a second.
constexpr std::size_t kMostWalked = 10'000;
/// Fillings that its proof may hold, as that of the search.
constexpr std::uint64_t kMostFillings = 100'000;

/// A name in a plan, as a path from where the command works.
std::string beside(const std::string& plan, const std::string& name) {
  return (std::filesystem::path(plan).parent_path() / name).string();
}

std::optional<Abilities> read_robot_of(SearchTask& task, const std::string& plan, App& app) {
  const std::string path = beside(plan, task.plan.robot);
  auto robot = read_abilities({path, std::nullopt}, app);
  if (!robot) return std::nullopt;
  FileError error;
  const std::string name = std::filesystem::path(path).filename().string();
  const auto text = scene_loader(path)(name, kMaxRobotFileBytes, error);
  task.plan.outside = combine(task.plan.outside, hash_text(text.value_or("")));
  return robot;
}

std::optional<LuaProgram> read_program_of(SearchTask& task, const std::string& plan, App& app) {
  const std::string path = beside(plan, task.plan.score_program);
  Diagnostics diagnostics;
  const SourceRef source = load_source(path, kMostLuaSource, diagnostics);
  app.report(diagnostics);
  if (!source) return std::nullopt;
  task.plan.outside = combine(task.plan.outside, hash_text(source->text()));
  return LuaProgram{.path = path, .text = std::string(source->text()), .whole = true};
}

SourceRange line_in(const SourceRef& source, std::size_t failed) {
  // Of no line in particular: the first.
  const std::size_t line = std::max<std::size_t>(failed, 1), begin = source->line_start(line);
  return {source, static_cast<std::uint32_t>(begin),
          static_cast<std::uint32_t>(begin + source->line(line).size())};
}

int code_number(const Diagnostics& diagnostics) {
  for (const Diagnostic& one : diagnostics.all()) {
    if (one.severity != Severity::error) continue;
    return std::atoi(std::string(info(one.code).name.substr(1)).c_str());
  }
  return 0;
}

/// More than one robot on a side is nothing that the compiler proves (P715).
search::RobotWork asked(const SearchTask& task, const search::Genome& genome) {
  CompileOptions options;
  options.verify.work = task.plan.proof;
  options.verify.states = kMostFillings;
  options.limits.states = kMostWalked;
  const RuleSet rules = rule_set_of(genome);
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(rules, *task.robot, options, diagnostics);
  if (!compiled.decision) return {0, code_number(diagnostics)};
  const bool together = compiled.concurrency.conflicts.empty();
  return {together ? static_cast<int>(compiled.sides.size()) : 1, 0};
}

ScoredStructure shown(const search::Scored& one) {
  ScoredStructure out;
  out.id = one.id;
  for (std::size_t k = 0; k < one.values.size(); ++k) {
    out.measures.emplace_back(search::objectives()[k].name, one.values[k]);
  }
  for (const PlacedBrick& brick : one.bricks) {
    out.cells.push_back({brick.at.x, brick.at.y, brick.at.z, brick.brick});
  }
  return out;
}

}  // namespace

std::optional<SearchTask> read_search_task(const std::string& path, App& app) {
  Diagnostics diagnostics;
  auto plan = search::read_search_plan_file(path, diagnostics);
  app.report(diagnostics);
  if (!plan || app.invalid(diagnostics)) return std::nullopt;
  SearchTask task{std::move(*plan), std::nullopt, std::nullopt};
  if (!task.plan.robot.empty()) {
    task.robot = read_robot_of(task, path, app);
    if (!task.robot) return std::nullopt;
  }
  if (!task.plan.score_program.empty()) {
    task.program = read_program_of(task, path, app);
    if (!task.program) return std::nullopt;
  }
  return task;
}

search::Judges judges_of(const SearchTask& task) {
  search::Judges judges;
  if (task.robot) {
    judges.compile = [&task](const search::Genome& genome) { return asked(task, genome); };
  }
  if (!task.program) return judges;
  judges.score = [&task](const search::Scored& one, std::string& problem) {
    LuaFailure failure;
    const auto score = lua_score(*task.program, shown(one), failure);
    if (!score) problem = failure.what;
    return score;
  };
  return judges;
}

void report_unscored(const SearchTask& task, const search::Individual& one, const App& app) {
  LuaFailure failure;
  // Asked again, since it says the same again, and now with its line.
  if (lua_score(*task.program, shown({one.id, one.values, one.bricks}), failure)) return;
  const auto source = std::make_shared<const SourceFile>(task.program->path, task.program->text);
  Diagnostics diagnostics;
  diagnostics.add(Code::C501, line_in(source, failure.line), failure.what)
      .note(fmt::format("it was asked about individual {}, of {}", one.id,
                        counted(one.bricks.size(), "brick")));
  app.report(diagnostics);
}

}  // namespace stig::cli
