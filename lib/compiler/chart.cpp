// SPDX-License-Identifier: MIT
// The mission's state chart as data. Lua executes what is emitted from this table, so its
// events are those that the behaviours of programs/mission return; a behaviour's ends and
// its state's transitions have to agree.
#include "compiler/chart.h"

#include <fmt/format.h>

namespace stig::compiler {

const Chart& building_chart() {
  static const Chart chart{{
      {"search block", "search_block", {{"found", "approach block"}, {"none", "search block"}}},
      {"approach block", "approach_block", {{"near", "pick up"}, {"lost", "search block"}}},
      {"pick up",
       "pick_up",
       {{"holds", "search structure"}, {"mute", "lay aside"}, {"failed", "search block"}}},
      {"lay aside", "lay_aside", {{"done", "search block"}, {"useless", "sleep"}}},
      {"sleep", "sleep", {{"done", "search block"}}},
      {"search structure",
       "search_structure",
       {{"found", "wait"},
        {"none", "search structure"},
        {"lost", "find cache"},
        {"dropped", "search block"}}},
      {"find cache", "find_cache", {{"found", "search structure"}, {"none", "search structure"}}},
      {"wait", "wait", {{"done", "choose row"}}},
      {"choose row",
       "choose_row",
       {{"chosen", "stand before"},
        {"none", "next side"},
        {"lost", "search structure"},
        {"dropped", "search block"}}},
      {"next side", "next_side", {{"there", "choose row"}, {"lost", "search structure"}}},
      {"stand before", "stand_before", {{"there", "look"}, {"blocked", "choose row"}}},
      {"look",
       "look",
       {{"decided", "approach site"},
        {"faulty", "approach brick"},
        {"nothing", "choose row"},
        {"unseen", "choose row"},
        {"dropped", "search block"}}},
      {"approach site",
       "approach_site",
       {{"near", "attach"},
        {"busy", "wait"},
        {"lost", "search structure"},
        {"dropped", "search block"}}},
      {"approach brick",
       "approach_site",
       {{"near", "recolour"},
        {"busy", "wait"},
        {"lost", "search structure"},
        {"dropped", "search block"}}},
      {"recolour", "recolour", {{"done", "choose row"}, {"dropped", "search block"}}},
      {"attach", "attach", {{"placed", "search block"}, {"failed", "let go"}}},
      {"let go", "let_go", {{"done", "search block"}}},
  }};
  return chart;
}

/// For the documentation: Graphviz lays the chart out.
std::string chart_dot(const Chart& chart) {
  std::string out =
      "digraph chart {\n  node [shape=box, style=rounded, fontname=\"DejaVu Sans\"];\n";
  out += "  edge [fontname=\"DejaVu Sans\", fontsize=10];\n  begin [shape=point];\n";
  out += fmt::format("  begin -> \"{}\";\n", chart.states.front().name);
  for (const ChartState& state : chart.states) {
    for (const ChartStep& step : state.steps) {
      out += fmt::format("  \"{}\" -> \"{}\" [label=\"{}\"];\n", state.name, step.to, step.event);
    }
  }
  return out + "}\n";
}

}  // namespace stig::compiler
