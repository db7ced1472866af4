// SPDX-License-Identifier: MIT
// A refusal that ends in "no" leaves its reader alone. Where the structure itself could be built by
// other rules, or by none, a short search finds that out, and the last error says it.
#include "other_rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "assembly/assemble.h"
#include "base/text.h"
#include "compiler/precedence.h"
#include "robot_input.h"

namespace stig::cli {
namespace {

/// A tenth of synth's own effort: enough for what compile is usually asked about.
constexpr double kEffort = 0.1;

/// The structure with its lowest level on the floor, whatever its colours.
Target shape_of(const Structure& structure) {
  Target out;
  const std::int32_t floor = structure.bounds()->low.z;
  for (const PlacedBrick& brick : structure.bricks()) {
    out.cells.push_back({brick.at.x, brick.at.y, brick.at.z - floor});
  }
  out.colours.assign(out.cells.size(), StateSet::anything());
  return out;
}

// In the words of synth --robot, which has the drawings.
std::string why_not(const Target& target, const AssemblyObstacle& obstacle) {
  const std::string all = counted(target.cells.size(), "brick");
  switch (obstacle.kind) {
    case AssemblyObstacle::Kind::apart:
      return fmt::format("{} of {} share no face with the rest",
                         target.cells.size() - obstacle.part.count(), all);
    case AssemblyObstacle::Kind::remainder:
      return fmt::format("of {}, {} are left of which none can be put last", all,
                         obstacle.remainder.bricks.count());
    case AssemblyObstacle::Kind::stretch:
      return fmt::format("of {}, {} slices are alike, more than {} tell apart", all,
                         obstacle.stretch.last - obstacle.stretch.first + 1,
                         counted(static_cast<std::size_t>(obstacle.colours), "colour"));
    case AssemblyObstacle::Kind::runs:
      return fmt::format("of {}, {} stand alone in a row, more than {} tell apart", all,
                         obstacle.runs.front().size(),
                         counted(static_cast<std::size_t>(obstacle.colours), "colour"));
    case AssemblyObstacle::Kind::rules:
      return fmt::format("{} are too few, whatever the rules and the decisions",
                         counted(static_cast<std::size_t>(obstacle.colours), "colour"));
    case AssemblyObstacle::Kind::exhausted:
      break;
  }
  return fmt::format("every order of {} leaves one out of reach", all);
}

/// Tried before it is said; nothing where nothing is known.
std::optional<std::string> note_on_other_rules(const RuleSet& rules, const CompiledRules& compiled,
                                               const Abilities& robot,
                                               const std::optional<std::string>& robot_file) {
  // Only of a structure that is proved there is something to say.
  if (rules.lattice != Lattice::cubic || compiled.proof.verdict != ProofVerdict::proved) return {};
  const std::size_t bricks = compiled.proof.structure->size();
  // Beyond, synth --robot would refuse it.
  if (bricks < 2 || bricks > kMostOrderedBricks) return std::nullopt;
  AssemblyTask task;
  task.target = shape_of(*compiled.proof.structure);
  task.robot = robot;
  task.robots = compiled.robots;
  task.wording.name = "other";
  AssemblyHooks hooks;
  // No time limit: its effort is small, and counted.
  hooks.deadline.stop = &stop_requested();
  const Assembly made = assemble(task, kEffort, hooks);
  if (made.obstacle) {
    return fmt::format("no rules would do: {}; `stigc synth STRUCTURE --robot` shows it",
                       why_not(task.target, *made.obstacle));
  }
  if (!made.plan) return std::nullopt;
  const std::string robots = task.robots ? fmt::format("--robots {} ", *task.robots) : "";
  return fmt::format(
      "other rules build the same structure with this robot: `stigc explore {} -o structure.txt`, "
      "then `stigc synth structure.txt --robot {} {}-o rules.yaml`",
      printable(rules.file ? rules.file->path() : "FILE"),
      printable(robot_file.value_or(kPaperRobot)), robots);
}

}  // namespace

void note_other_rules(const RuleSet& rules, const CompiledRules& compiled, const Abilities& robot,
                      const std::optional<std::string>& robot_file, Diagnostics& diagnostics) {
  Diagnostic* const error = diagnostics.last_error();
  if (compiled.decision || stop_requested() || error == nullptr) return;
  if (auto note = note_on_other_rules(rules, compiled, robot, robot_file)) {
    error->note(std::move(*note));
  }
}

}  // namespace stig::cli
