// SPDX-License-Identifier: MIT
// The state chart of a robot that builds: what it does, and what follows what.
//
// After figures 8 and 10 of Allwright et al. 2017: search an unused block, approach it, pick it
// up, search the structure, wait, stand before a column and look, approach the site, attach,
// reverse, begin again. Each state is a behaviour of programs/mission, which takes the time
// that it takes and ends with an event; the chart is emitted as data, so what is drawn is what
// runs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/uses.h"

namespace stig::compiler {

struct ChartStep {
  std::string_view event, to;
};
struct ChartState {
  std::string_view name;
  std::string_view behaviour;  ///< of programs/mission/builder.lua
  std::vector<ChartStep> steps;
};
struct Chart {
  std::vector<ChartState> states;  ///< the first is where a robot begins
};

const Chart& building_chart();
/// As Graphviz DOT.
std::string chart_dot(const Chart& chart);

}  // namespace stig::compiler
