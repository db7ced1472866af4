// SPDX-License-Identifier: MIT
// A controller as readable Lua in one file: the library of programs/, the task with the rules'
// decisions, and the chart.
//
// Lines that decide name the rule that they stand for, and a line map says so for programs:
// rule sets come back from a robot as line numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/controller_plan.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// Where a line of the program comes from.
struct LineOrigin {
  std::size_t line = 0;    ///< of the program, from 1
  std::uint32_t rule = 0;  ///< index in the rule set
  std::size_t source = 0;  ///< line of the YAML on which the rule begins, from 1
};

struct ControllerText {
  std::string text;
  std::vector<LineOrigin> lines;  ///< rising
};

/// The module of programs/ that a controller calls, as `require` has it; it requires the others.
inline constexpr std::string_view kRuntimeRoot = "mission.builder";

/// `file` is what comments call the rule set's file. `library` are the texts of modules, each after
/// those that it requires. The last line of a module returns a table, and the others know it by the
/// name that this table has there.
ControllerText controller_lua(const RuleSet& rules, std::string_view file,
                              const ControllerPlan& plan, const CompiledRules& compiled,
                              const std::vector<std::string>& library);

/// What stands between the library and ARGoS, and the program of blocks there.
inline constexpr std::string_view kArgosAdapter = "argos", kArgosBlock = "argos_block";

/// The same program for ARGoS 3: `adapter` is the text of kArgosAdapter, `description` the robot's
/// (robots/robot_description.h), which ARGoS does not have.
ControllerText controller_argos(const RuleSet& rules, std::string_view file,
                                const ControllerPlan& plan, const CompiledRules& compiled,
                                std::string_view description, std::string_view adapter,
                                const std::vector<std::string>& library);

}  // namespace stig::compiler
