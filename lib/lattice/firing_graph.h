// SPDX-License-Identifier: MIT
// The firing graph of a rule set: which rule's brick can another rule need?
//
// Nodes are rules. There is an edge A -> B when some cell of B's pattern (or a
// count with min >= 1) asks for a brick and takes the colour that A places, and
// B's stage does not lie before A's. The graph says nothing of geometry, so it
// errs on one side only: what it calls unreachable never fires, and growth
// without end needs one of its cycles.
//
//   level    0: the start alone can satisfy every such cell of the rule; k: the
//            start and the rules of levels below k can, and not fewer levels.
//            Unset: no order of events ever fires the rule.
//   cycle    number of the strongly connected component when it has a cycle
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lattice/uses.h"
#include "rules/rule_set.h"

namespace stig::lattice {

struct FiringNode {
  std::optional<int> level;
  std::optional<int> cycle;  ///< 0, 1, … by the lowest rule in it
};

struct FiringEdge {
  std::uint32_t from = 0, to = 0;  ///< rule indices
  auto operator<=>(const FiringEdge&) const = default;
};

struct FiringGraph {
  std::vector<FiringNode> nodes;                   ///< by rule index
  std::vector<FiringEdge> edges;                   ///< sorted
  std::vector<std::uint32_t> from_start;           ///< rules that can need a brick of the start
  std::vector<std::vector<std::uint32_t>> cycles;  ///< rules of each cyclic component, sorted
};

/// Edges grow with the square of the rules, and no layout of so many ends.
inline constexpr std::size_t kMostGraphRules = 2000;
inline constexpr std::size_t kMostGraphEdges = 1'000'000;

/// Why the set is too large for a graph, in words; empty: it is not.
std::string firing_graph_problem(const RuleSet& rules);
/// There must be no problem (asserted).
FiringGraph firing_graph(const RuleSet& rules);

/// Graphviz text: names and bricks' colours in the nodes, stages as clusters,
/// edges within a cycle drawn heavy, rules that never fire dashed.
std::string to_dot(const FiringGraph& graph, const RuleSet& rules);

}  // namespace stig::lattice
