// SPDX-License-Identifier: MIT
#include "lattice/firing_graph.h"

#include <doctest/doctest.h>

#include "lattice/swarm.h"
#include "support/shipped.h"
#include "support/small_sets.h"
#include "support/uses.h"

namespace stig {
namespace {

using Edges = std::vector<FiringEdge>;

TEST_CASE("an edge goes from the rule that places a colour to the rule that asks for it") {
  const FiringGraph graph = firing_graph(small_set(east_of("1", "2") + east_of("2", "3")));
  CHECK(graph.edges == Edges{{0, 1}});
  CHECK(graph.from_start == std::vector<std::uint32_t>{0});
  CHECK(graph.nodes[0].level == 0);
  CHECK(graph.nodes[1].level == 1);
  CHECK(graph.cycles.empty());
}

TEST_CASE("a rule that feeds itself, and rules that feed each other, are cycles") {
  const FiringGraph graph =
      firing_graph(small_set(east_of("1", "2") + east_of("2", "3") + east_of("3", "2")));
  REQUIRE(graph.cycles.size() == 1);
  CHECK(graph.cycles[0] == std::vector<std::uint32_t>{1, 2});
  CHECK_FALSE(graph.nodes[0].cycle.has_value());
  CHECK(firing_graph(small_set(east_of("1", "1"))).cycles.size() == 1);
}

TEST_CASE("a rule that waits for what nobody places has no level") {
  const FiringGraph graph = firing_graph(small_set(east_of("1", "2") + east_of("3", "3")));
  CHECK(graph.nodes[0].level == 0);
  CHECK_FALSE(graph.nodes[1].level.has_value());
}

TEST_CASE("a cell that may be empty asks for nothing") {
  const std::string maybe =
      "  - name: maybe\n    place: 2\n    when: |\n      ? ? ?   ? ? ?   ? ? ?\n"
      "      ? ? ?   m * 1   ? ? ?\n      ? ? ?   ? ? ?   ? ? ?\n";
  const FiringGraph graph =
      firing_graph(small_set(maybe + east_of("1", "3"), "legend:\n  m: [., 3]\n"));
  CHECK(graph.edges.empty());
}

TEST_CASE("a count with a least number asks for its colours") {
  const std::string count = "    count: [{of: [3], among: all, min: 1}]\n";
  const FiringGraph graph =
      firing_graph(small_set(east_of("1", "3") + east_of("1", "2", count), "conflicts: first\n"));
  CHECK(graph.edges == Edges{{0, 1}});
  CHECK(graph.nodes[1].level == 1);
}

TEST_CASE("what a later stage places is of no use to an earlier one") {
  const FiringGraph graph = firing_graph(
      small_set(east_of("1", "2", "    stage: 2\n") + east_of("2", "3", "    stage: 1\n")));
  CHECK(graph.edges.empty());
  CHECK_FALSE(graph.nodes[1].level.has_value());
}

TEST_CASE("every rule that fires in a run has a level") {
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    const RuleSet rules = shipped(name);
    SwarmConfig config;
    config.motion = Motion::event;
    if (rules.box) config.box = lay_box(*rules.box, rules.start, rules.floor);
    config.max_deposits = 2000;
    const SwarmResult run = run_swarm(RuleTable(rules), rules.start, config);
    const FiringGraph graph = firing_graph(rules);
    for (std::size_t r = 0; r < rules.rules.size(); ++r) {
      if (run.rules[r].fired > 0) CHECK(graph.nodes[r].level.has_value());
    }
  }
}

TEST_CASE("a set that grows for ever has a cycle") {
  CHECK_FALSE(firing_graph(shipped("tiling")).cycles.empty());
}

TEST_CASE("names are escaped for DOT") {
  RuleSet rules = small_set(east_of("1", "2"));
  rules.rules[0].name = "a \"quoted\" \\ name\nand more";
  const std::string dot = to_dot(firing_graph(rules), rules);
  CHECK(dot.find(R"(label="a \"quoted\" \\ name and more → 2")") != std::string::npos);
}

TEST_CASE("sets too large for a graph are refused with words") {
  RuleSet rules = small_set(east_of("1", "1"));
  const Rule rule = rules.rules[0];
  rules.rules.assign(1000, rule);
  CHECK(firing_graph_problem(rules).empty());
  rules.rules.push_back(rule);
  CHECK(firing_graph_problem(rules) ==
        "1002001 edges between 1001 rules are too many for a graph: at most 1000000");
  rules.rules.assign(2001, rule);
  CHECK(firing_graph_problem(rules) == "2001 rules are too many for a graph: at most 2000");
}

}  // namespace
}  // namespace stig
