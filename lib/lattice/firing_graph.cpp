// SPDX-License-Identifier: MIT
// The graph of which rule's brick another can need, by colours and stages alone. It
// over-approximates: an edge may exist without ever being used, but what lies outside is
// impossible. Levels are the rounds of a least fixed point, cycles the strongly connected
// components (R. Tarjan 1972, from Boost Graph).
#include "lattice/firing_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <cassert>
#include <cstdlib>
#include <map>

namespace stig::lattice {
namespace {

/// What a rule asks of the bricks around its site: of each set one colour. Cells
/// that take emptiness, or the floor where there is one, ask for nothing.
struct Needs {
  std::vector<StateSet> sets;
  StateSet any;  ///< their union
};

/// A cell that accepts "empty" (or floor) can be satisfied without a brick, so it asks for
/// nothing.
Needs needs_of(const RuleSet& rules, const Rule& rule) {
  const StateSet bricks = StateSet::bricks(rules.colours());
  const StateSet given =
      rules.floor ? StateSet::empty_cell() | StateSet::floor() : StateSet::empty_cell();
  Needs needs;
  const auto add = [&](StateSet wanted) {
    if (!(wanted & given).none()) return;
    wanted = wanted & bricks;
    if (std::find(needs.sets.begin(), needs.sets.end(), wanted) != needs.sets.end()) return;
    needs.sets.push_back(wanted);
    needs.any = needs.any | wanted;
  };
  const auto size = static_cast<std::size_t>(neighbourhood(rules.lattice).size);
  for (std::size_t i = 0; i < size; ++i) add(rule.pattern.allowed[i]);
  for (const CountCondition& count : rule.counts) {
    if (count.min >= 1) add(count.of);
  }
  return needs;
}

/// Can a brick of a rule of stage `from` stand when one of stage `to` fires? A brick stays
/// for good, so one of an earlier stage can serve any later one.
bool in_time(int from, int to) { return from == 0 || to == 0 || from <= to; }

/// Colours that may stand in each stage, given the rules that have a level;
/// [0] is for rules of every stage, which wait for whatever comes.
std::vector<StateSet> at_hand(const RuleSet& rules, const FiringGraph& graph) {
  StateSet start;
  for (const PlacedBrick& brick : rules.start) start = start | StateSet::of(brick.brick);
  // Index 0 collects all colours, for rules that act in every stage: they can wait until
  // the last.
  std::vector<StateSet> by_stage(static_cast<std::size_t>(rules.stage_count()) + 1, start);
  for (std::size_t r = 0; r < rules.rules.size(); ++r) {
    if (!graph.nodes[r].level) continue;
    const StateSet placed = StateSet::of(rules.rules[r].place);
    const auto stage = static_cast<std::size_t>(rules.rules[r].stage);
    by_stage[0] = by_stage[0] | placed;
    const std::size_t first = std::max<std::size_t>(stage, 1);
    by_stage[first] = by_stage[first] | placed;
  }
  // What stands in a stage still stands in the next.
  for (std::size_t s = 2; s < by_stage.size(); ++s) by_stage[s] = by_stage[s] | by_stage[s - 1];
  return by_stage;
}

/// Levels as the rounds of a fixed point: colours at hand, then rules they satisfy.
void set_levels(const RuleSet& rules, const std::vector<Needs>& needs, FiringGraph& graph) {
  bool more = true;
  // Each round but the last gives a rule its level; in practice there are few.
  for (int level = 0; more; ++level) {
    more = false;
    const std::vector<StateSet> colours = at_hand(rules, graph);
    for (std::size_t r = 0; r < rules.rules.size(); ++r) {
      if (graph.nodes[r].level) continue;
      const StateSet here = colours[static_cast<std::size_t>(rules.rules[r].stage)];
      const auto met = [&](StateSet wanted) { return !(wanted & here).none(); };
      if (!std::all_of(needs[r].sets.begin(), needs[r].sets.end(), met)) continue;
      graph.nodes[r].level = level;
      more = true;
    }
  }
}

/// An edge from a rule to itself makes a component of one cyclic too.
void set_cycles(FiringGraph& graph) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> g(graph.nodes.size());
  for (const FiringEdge& edge : graph.edges) boost::add_edge(edge.from, edge.to, g);
  std::vector<int> component(graph.nodes.size());
  boost::strong_components(
      g, boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, g)));
  // A component is cyclic when an edge stays inside it.
  std::vector<bool> cyclic(graph.nodes.size(), false);
  for (const FiringEdge& edge : graph.edges) {
    if (component[edge.from] == component[edge.to]) {
      cyclic[static_cast<std::size_t>(component[edge.from])] = true;
    }
  }
  // Numbered by the lowest rule, so that output does not depend on the order in which
  // components are found.
  std::map<int, int> number;  // component -> cycle, counted by lowest rule
  for (std::uint32_t r = 0; r < graph.nodes.size(); ++r) {
    if (!cyclic[static_cast<std::size_t>(component[r])]) continue;
    const auto [it, fresh] = number.emplace(component[r], static_cast<int>(number.size()));
    if (fresh) graph.cycles.emplace_back();
    graph.cycles[static_cast<std::size_t>(it->second)].push_back(r);
    graph.nodes[r].cycle = it->second;
  }
}

/// A DOT string literal; control characters become spaces.
std::string dot_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  }
  return out + '"';
}

/// Black or white, whichever reads better on "#rrggbb" (ITU-R BT.601 luma).
std::string_view text_colour(const std::string& colour) {
  if (colour.size() != 7) return "black";
  const auto part = [&](std::size_t at) {
    return std::strtol(colour.substr(at, 2).c_str(), nullptr, 16);
  };
  return 299 * part(1) + 587 * part(3) + 114 * part(5) > 140000 ? "black" : "white";
}

std::string rule_label(const RuleSet& rules, std::size_t index) {
  const Rule& rule = rules.rules[index];
  const std::string name = rule.name.empty() ? fmt::format("rule {}", index + 1) : rule.name;
  return fmt::format("{} → {}", name, rules.brick(rule.place).symbol);
}

std::string node_line(const FiringGraph& graph, const RuleSet& rules, std::size_t index) {
  const std::string& colour = rules.brick(rules.rules[index].place).color;
  const auto& level = graph.nodes[index].level;
  return fmt::format("r{} [label={}, tooltip={}, fillcolor={}, fontcolor={}{}];\n", index + 1,
                     dot_string(rule_label(rules, index)),
                     dot_string(level ? fmt::format("level {}", *level) : "never fires"),
                     dot_string(colour.empty() ? "#dddddd" : colour), text_colour(colour),
                     level ? "" : ", style=\"filled,dashed\"");
}

/// The nodes: rules of every stage first, then one cluster a stage.
void write_nodes(const FiringGraph& graph, const RuleSet& rules, std::string& out) {
  std::map<int, std::vector<std::size_t>> by_stage;
  for (std::size_t i = 0; i < rules.rules.size(); ++i) {
    by_stage[rules.rules[i].stage].push_back(i);
  }
  for (const auto& [stage, members] : by_stage) {
    const char* indent = stage == 0 ? "  " : "    ";
    if (stage != 0) {
      out += fmt::format("  subgraph cluster_stage_{} {{\n    label=\"stage {}\";\n", stage, stage);
    }
    for (const std::size_t i : members) out += indent + node_line(graph, rules, i);
    if (stage != 0) out += "  }\n";
  }
}

std::vector<Needs> needs_of(const RuleSet& rules) {
  std::vector<Needs> needs;
  for (const Rule& rule : rules.rules) needs.push_back(needs_of(rules, rule));
  return needs;
}

bool feeds(const Rule& a, const Rule& b, const Needs& needs_of_b) {
  return in_time(a.stage, b.stage) && needs_of_b.any.contains(a.place);
}

}  // namespace

/// The size is tested before anything quadratic is stored.
std::string firing_graph_problem(const RuleSet& rules) {
  const std::size_t count = rules.rules.size();
  if (count > kMostGraphRules) {
    return fmt::format("{} rules are too many for a graph: at most {}", count, kMostGraphRules);
  }
  const std::vector<Needs> needs = needs_of(rules);
  std::size_t edges = 0;
  for (const Rule& rule : rules.rules) {
    for (std::size_t b = 0; b < count; ++b) edges += feeds(rule, rules.rules[b], needs[b]);
  }
  if (edges <= kMostGraphEdges) return {};
  return fmt::format("{} edges between {} rules are too many for a graph: at most {}", edges, count,
                     kMostGraphEdges);
}

FiringGraph firing_graph(const RuleSet& rules) {
  assert(firing_graph_problem(rules).empty());
  FiringGraph graph;
  graph.nodes.resize(rules.rules.size());
  const std::vector<Needs> needs = needs_of(rules);
  for (std::uint32_t a = 0; a < rules.rules.size(); ++a) {
    for (std::uint32_t b = 0; b < rules.rules.size(); ++b) {
      if (feeds(rules.rules[a], rules.rules[b], needs[b])) graph.edges.push_back({a, b});
    }
  }
  for (std::uint32_t b = 0; b < rules.rules.size(); ++b) {
    const auto wanted = [&](const PlacedBrick& brick) {
      return needs[b].any.contains(brick.brick);
    };
    if (std::any_of(rules.start.begin(), rules.start.end(), wanted)) graph.from_start.push_back(b);
  }
  set_levels(rules, needs, graph);
  set_cycles(graph);
  return graph;
}

std::string to_dot(const FiringGraph& graph, const RuleSet& rules) {
  assert(graph.nodes.size() == rules.rules.size());
  const std::string& title = rules.title.empty() ? rules.name : rules.title;
  std::string out = fmt::format("digraph {} {{\n", dot_string(rules.name));
  out += fmt::format("  label={};\n  labelloc=t;\n  rankdir=LR;\n", dot_string(title));
  out += "  node [shape=box, style=\"filled,rounded\", fontname=\"sans-serif\"];\n";
  out += "  start [shape=circle, label=\"start\", fillcolor=\"white\"];\n";
  write_nodes(graph, rules, out);
  for (const std::uint32_t rule : graph.from_start) {
    out += fmt::format("  start -> r{};\n", rule + 1);
  }
  for (const FiringEdge& edge : graph.edges) {
    const auto cycle = graph.nodes[edge.from].cycle;
    const bool heavy = cycle && cycle == graph.nodes[edge.to].cycle;
    out +=
        fmt::format("  r{} -> r{}{};\n", edge.from + 1, edge.to + 1, heavy ? " [penwidth=2]" : "");
  }
  return out + "}\n";
}

}  // namespace stig::lattice
