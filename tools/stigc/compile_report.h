// SPDX-License-Identifier: MIT
// What `stigc compile` prints of a rule set that a robot can build.
#pragma once

#include <string>

#include <string_view>
#include <vector>

#include "app.h"
#include "compiler/controller_lua.h"
#include "options.h"
#include "uses.h"

namespace stig::cli {

/// What the reports are about.
struct CompileJob {
  const RuleSet* rules = nullptr;
  const Abilities* robot = nullptr;
  const CompiledRules* compiled = nullptr;
  ControllerPlan plan;
};

/// The pictures that go with what is reported, on standard error; none where a program reads it.
void show_drawings(const CompiledRules& compiled, const App& app);

std::string compile_table(const CompileJob& job);
/// Two graphs: the decision, and the chart.
std::string compile_dot(const CompileJob& job);
std::string compile_ir(const CompileJob& job);
/// Which lines of the program stand for which lines of the rules, as JSON.
std::string line_map_json(const CompileJob& job, const ControllerText& program);

}  // namespace stig::cli
