// SPDX-License-Identifier: MIT
// From a target to a rule set that a robot can follow.
//
//     obstacle   why no order of work builds it, where that can be said at once (obstacle.h)
//     sequence   an order that is within reach (sequence.h), by one liking after another
//     candidate  what then can occur on the way, and what robots see of it (candidate.h)
//     colours    such that rules and robots tell what is to be done where (colours.h)
//     judge      the rule set as a file has it, compiled for this robot (compiler/compile.h)
//
// Candidates are made and judged until one stands; nothing is returned that the compiler has not
// accepted. How much is tried is counted in work, so that the same target gives the same rules.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assembly/obstacle.h"
#include "assembly/sequence.h"
#include "assembly/uses.h"
#include "assembly/work.h"
#include "compiler/compile.h"
#include "synthesis/effort.h"
#include "synthesis/emit.h"
#include "synthesis/target.h"

namespace stig::assembly {

struct AssemblyTask {
  Target target;  ///< cubic, two bricks or more
  Abilities robot;
  std::vector<ApproachSide> sides;   ///< empty: chosen
  std::optional<int> robots;         ///< none: as many as may be, at least one
  std::optional<Cell> start;         ///< of the target; none: chosen
  int kinds = kBlockColours;         ///< of brick that there are
  int most_colours = kBlockColours;  ///< that rules may need, of these
  Wording wording;                   ///< with a name
};

struct AssemblyHooks {
  std::function<void(double fraction, const std::string& what)> progress;
  Deadline deadline;
};

/// What became of the candidates that were made.
struct AssemblyCounts {
  std::size_t candidates = 0;
  std::size_t no_order = 0;    ///< no order within reach was found
  std::size_t looked_at = 0;   ///< that were not known already
  std::size_t too_large = 0;   ///< more structures on the way than are walked
  std::size_t dead_end = 0;    ///< even with a colour for each brick robots could get stuck
  std::size_t no_colours = 0;  ///< the colours do not do
  std::size_t refused = 0;     ///< by the compiler
};

/// A rule set with its proof that the robot can follow it.
struct AssemblyPlan {
  std::string text;                ///< the file
  std::unique_ptr<RuleSet> rules;  ///< as it is read
  CompiledRules compiled;
  Cell start;
  std::vector<WorkStep> work;  ///< one order of it
  bool any_number = false;     ///< of robots may work at once
  /// Otherwise: as many as there are sides may, each with sides of its own.
  bool one_a_side = false;
};

struct Assembly {
  std::optional<AssemblyPlan> plan;
  std::optional<AssemblyObstacle> obstacle;  ///< no robot of this kind builds it from these sides
  /// More bricks than rules are looked for; that there is no obstacle says nothing then.
  bool too_many = false;
  AssemblyCounts counts;
  bool cut_short = false;
};

/// `effort` as in SynthesisOptions.
Assembly assemble(const AssemblyTask& task, double effort, const AssemblyHooks& hooks = {});

}  // namespace stig::assembly
