// SPDX-License-Identifier: MIT
#include "lattice/swarm.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "base/random.h"
#include "lattice/walk_kernel.h"
#include "support/shipped.h"
#include "support/uses.h"

using namespace stig;

namespace {

struct Outcome {
  std::vector<Deposit> log;
  SwarmResult result;
};

Outcome run(const RuleSet& rules, const SwarmConfig& config) {
  const RuleTable table(rules);
  Outcome out;
  SwarmHooks hooks;
  hooks.deposit = [&](const Deposit& d) { out.log.push_back(d); };
  INFO(config_problem(table, rules.start, config));
  REQUIRE(config_problem(table, rules.start, config).empty());
  out.result = run_swarm(table, rules.start, config, hooks);
  return out;
}

SwarmConfig walkers(const RuleSet& rules, int side, int agents, std::uint64_t seed = 1) {
  SwarmConfig config;
  config.box = lay_box({{side, side, side}, std::nullopt, false}, rules.start, rules.floor);
  config.agents = agents;
  config.moves = neighbourhood(rules.lattice).size;
  config.seed = seed;
  config.max_steps = 4000;
  return config;
}

/// The walk model as swarm.h words it, agent by agent, with views taken afresh.
std::vector<Deposit> walk_oracle(const RuleSet& rules, const SwarmConfig& config,
                                 std::vector<Cell> at) {
  const RuleTable table(rules);
  const Neighbourhood& n = table.neighbours();
  Structure s(rules.lattice, rules.start);
  std::vector<Offset> moves;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    if (config.moves == n.size || n.is_face[i] || (config.moves == 18 && n.is_edge[i])) {
      moves.push_back(n.offsets[i]);
    }
  }
  std::vector<std::uint32_t> strides;
  const auto agents = static_cast<std::uint32_t>(at.size());
  for (std::uint32_t i = 1; i <= agents; ++i) {
    if (std::gcd(i, agents) == 1) strides.push_back(i);
  }
  std::vector<Deposit> log;
  std::vector<Match> matches;
  for (std::uint64_t step = 1; step <= *config.max_steps; ++step) {
    const auto order =
        philox(random_address(config.run, Purpose::order, 0, step / 2), random_key(config.seed));
    const auto below = [](std::uint32_t word, std::uint64_t bound) {
      return static_cast<std::size_t>((word * bound) >> 32);
    };
    std::uint64_t agent = below(order[step % 2 * 2], agents);
    const std::uint64_t stride = strides[below(order[step % 2 * 2 + 1], strides.size())];
    for (std::uint32_t k = 0; k < agents; ++k, agent = (agent + stride) % agents) {
      Cell& here = at[agent];
      const View view = view_at(s, table, config.box, here);
      table.matches(view, here.z, 1, matches);
      if (s.at(here) == kEmpty && !matches.empty()) {
        Random random(config.seed, config.run, Purpose::deposit, static_cast<std::uint32_t>(agent),
                      step);
        const double p = table.probability(matches[0].rule);
        if (p >= 1 || random.unit() < p) {
          const Colour colour = table.place(matches[0].rule);
          s.place(here, colour);
          log.push_back({here, colour, matches[0], static_cast<std::int32_t>(agent), step});
          if (enabled_sites(s, table, config.box, 1).empty()) return log;
        }
      }
      const auto words = philox(
          random_address(config.run, Purpose::move, static_cast<std::uint32_t>(agent), step / 4),
          random_key(config.seed));
      const Cell to = config.box->wrap(here + moves[below(words[step % 4], moves.size())]);
      const bool free = config.box->contains(to) && !(rules.floor && to.z < 0) &&
                        s.at(to) == kEmpty && std::find(at.begin(), at.end(), to) == at.end();
      if (free) here = to;
    }
  }
  return log;
}

}  // namespace

TEST_CASE("the walk engine does what its definition says, event by event") {
  for (const char* name : {"staircase", "stepped-pyramid", "stepped-pyramid-exact", "tiling"}) {
    CAPTURE(name);
    RuleSet rules = shipped(name);
    rules.rules[0].probability = 0.5;
    for (const bool periodic : {false, true}) {
      for (const int moves : {6, 18, 26}) {
        CAPTURE(periodic);
        SwarmConfig config = walkers(rules, 6, 20);
        config.box->periodic = periodic;
        config.box->floor = rules.floor;
        if (rules.lattice == Lattice::cubic)
          config.moves = moves;
        else
          config.moves = moves == 6 ? 8 : 20;
        config.max_steps = 300;
        for (int i = 0; i < 20; ++i) {
          const Cell c = config.box->low + Offset{i % 6, i / 6, 5};
          config.agents_at.push_back(c);
        }
        const auto expected = walk_oracle(rules, config, config.agents_at);
        CHECK(expected.size() >= 2);
        CHECK(run(rules, config).log == expected);
      }
    }
  }
}

TEST_CASE("vector instructions change nothing") {
  if (!vector_moves_available())
    MESSAGE("no AVX-512 here: the scalar path is compared with itself");
  for (const char* name : {"architecture-4c", "stepped-pyramid", "tiling"}) {
    for (const int agents : {15, 16, 17, 100, 400}) {
      for (const bool periodic : {false, true}) {
        const RuleSet rules = shipped(name);
        SwarmConfig config = walkers(rules, 8, agents, static_cast<std::uint64_t>(agents));
        config.box->periodic = periodic;
        config.box->floor = rules.floor;
        CAPTURE(name);
        CAPTURE(agents);
        const Outcome vector = run(rules, config);
        config.vectorise = false;
        const Outcome scalar = run(rules, config);
        CHECK(vector.log == scalar.log);
        CHECK(vector.result.steps == scalar.result.steps);
        CHECK(vector.result.out_of_reach == scalar.result.out_of_reach);
      }
    }
  }
}

TEST_CASE("two bits a cell, as large boxes have them, change nothing") {
  for (const char* name : {"architecture-4c", "coral", "stepped-pyramid", "tiling", "plate"}) {
    for (const bool periodic : {false, true}) {
      RuleSet rules = shipped(name);
      rules.rules[0].probability = 0.7;
      SwarmConfig config = walkers(rules, 6, 120);
      // Of 2^18 cells and more, and yet so narrow that agents meet sides, bricks and each other.
      config.box = lay_box({{6, 6, 4200}, std::nullopt, periodic}, rules.start, rules.floor);
      for (int i = 0; i < 90; ++i) {
        const Offset o{i % 6, i / 6 % 6, rules.start.front().at.z - config.box->low.z + 3 + i / 36};
        config.agents_at.push_back(config.box->low + o);
      }
      CAPTURE(name);
      CAPTURE(periodic);
      const Outcome packed = run(rules, config);
      config.vectorise = false;
      const Outcome bytes = run(rules, config);
      CHECK(packed.log.size() >= 5);
      CHECK(packed.log == bytes.log);
      CHECK(packed.result.steps == bytes.result.steps);
      CHECK(packed.result.enabled_left == bytes.result.enabled_left);
      CHECK(packed.result.out_of_reach == bytes.result.out_of_reach);
    }
  }
}

TEST_CASE("moves are drawn from the random streams") {
  Moves moves;
  moves.count = 26;
  for (std::size_t i = 0; i < 26; ++i) moves.step[i] = static_cast<std::int32_t>(100 + i);
  std::array<std::vector<std::int32_t>, 4> drawn;
  for (const bool vectorise : {false, true}) {
    for (auto& row : drawn) row.assign(50, 0);
    draw_moves(0x123456789abcdefULL, 77, (1ULL << 40) + 5, moves, vectorise, drawn);
    for (std::uint32_t agent = 0; agent < 50; ++agent) {
      Random random(0x123456789abcdefULL, 77, Purpose::move, agent, (1ULL << 40) + 5);
      for (std::size_t w = 0; w < 4; ++w) {
        const std::uint64_t move = (std::uint64_t{random.next()} * 26) >> 32;
        REQUIRE(drawn[w][agent] == static_cast<std::int32_t>(100 + move));
      }
    }
  }
}

TEST_CASE("coordinated sets end in the same structure under every motion") {
  for (const char* name : {"staircase", "stepped-pyramid", "staircase-exact",
                           "stepped-pyramid-exact", "wall", "plate", "architecture-4c"}) {
    CAPTURE(name);
    const RuleSet rules = shipped(name);
    std::optional<Structure> first;
    for (const Motion motion : {Motion::event, Motion::walk, Motion::teleport}) {
      CAPTURE(to_string(motion));
      SwarmConfig config = walkers(rules, 14, 50);
      if (rules.box) config.box = lay_box(*rules.box, rules.start, rules.floor);
      config.motion = motion;
      config.max_steps = 5'000'000;
      const SwarmResult result = run(rules, config).result;
      CHECK(result.terminated == Terminated::saturated);
      CHECK(result.enabled_left == 0);
      if (!first) first = result.structure;
      CHECK(result.structure == *first);
      CHECK(result.deposits + rules.start.size() == result.structure.size());
    }
  }
}

TEST_CASE("an ensemble is the same on any number of threads") {
  const RuleSet rules = shipped("order-dependent");
  const RuleTable table(rules);
  SwarmConfig config = walkers(rules, 10, 5);
  config.max_steps = 100000;
  const auto one = run_ensemble(table, rules.start, config, 12, 1);
  std::set<std::uint64_t> distinct;
  for (const int threads : {2, 5}) {
    const auto many = run_ensemble(table, rules.start, config, 12, threads);
    REQUIRE(many.size() == one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      CHECK(many[i].structure == one[i].structure);
      CHECK(many[i].steps == one[i].steps);
      distinct.insert(structure_hash(one[i].structure));
    }
  }
  CHECK(distinct.size() > 1);  // the runs do differ among themselves
  config.run = 7;
  CHECK(run_swarm(table, rules.start, config).structure == one[7].structure);
}

TEST_CASE("limits end a run where they say") {
  const RuleSet rules = shipped("tiling");
  SwarmConfig config;
  config.motion = Motion::event;
  config.max_deposits = 100;
  Outcome out = run(rules, config);
  CHECK(out.result.terminated == Terminated::deposits);
  CHECK(out.result.deposits == 100);
  CHECK(out.log.size() == 100);
  CHECK(out.result.enabled_left > 0);

  config.max_deposits.reset();
  config.max_steps = 50;
  out = run(rules, config);
  CHECK(out.result.terminated == Terminated::steps);
  CHECK(out.result.steps == 50);

  config.max_steps = 0;
  CHECK(run(rules, config).result.deposits == 0);
}

TEST_CASE("a stop request ends an endless run") {
  const RuleSet rules = shipped("tiling");
  const RuleTable table(rules);
  const std::atomic<bool> stop{true};
  SwarmConfig config;
  config.motion = Motion::event;
  SwarmHooks hooks;
  hooks.stop = &stop;
  const SwarmResult result = run_swarm(table, rules.start, config, hooks);
  CHECK(result.terminated == Terminated::interrupted);
  CHECK(result.deposits > 0);
}

TEST_CASE("an enabled site behind walls is out of reach") {
  // The agent is walled into a corner by a start that leaves it one cell.
  RuleSet rules = shipped("staircase");
  SwarmConfig config = walkers(rules, 5, 1);
  config.max_steps = 1000;
  config.moves = 6;
  const Cell corner = config.box->low;
  for (const Offset o : {Offset{1, 0, 0}, Offset{0, 1, 0}, Offset{0, 0, 1}}) {
    rules.start.push_back({corner + o, 1});
  }
  config.agents_at = {corner};
  const SwarmResult result = run(rules, config).result;
  CHECK(result.terminated == Terminated::steps);
  CHECK(result.enabled_left >= 1);
  CHECK(result.out_of_reach == result.enabled_left);
}

TEST_CASE("probability only delays, weights decide shares") {
  RuleSet rules = shipped("staircase");
  SwarmConfig config;
  config.motion = Motion::event;
  const Structure sure = run(rules, config).result.structure;
  for (Rule& rule : rules.rules) rule.probability = 0.1;
  const SwarmResult slow = run(rules, config).result;
  CHECK(slow.structure == sure);
  CHECK(slow.steps > slow.deposits);

  // Two rules for one site: colour 1 three times as often as colour 2.
  rules.conflicts = Conflicts::random;
  Rule a = rules.rules[0];
  a.probability = 1;
  a.height_max = 1;
  a.place = 1;
  a.weight = 3;
  Rule b = a;
  b.name = "other";
  b.place = 2;
  b.weight = 1;
  rules.rules = {a, b};
  const RuleTable table(rules);
  int ones = 0;
  for (config.run = 0; config.run < 2000; ++config.run) {
    const auto result = run_swarm(table, rules.start, config);
    ones += result.structure.at({0, 0, 1}) == 1 ? 1 : 0;
  }
  CHECK(ones == doctest::Approx(1500).epsilon(0.05));
}

TEST_CASE("stages follow one another, by exhaustion or by deposits") {
  RuleSet rules = shipped("architecture-4n");
  SwarmConfig config;
  config.motion = Motion::event;
  std::vector<Deposit> log = run(rules, config).log;
  int stage = 1;
  for (const Deposit& d : log) {
    CHECK(rules.rules[d.match.rule].stage >= stage);
    stage = rules.rules[d.match.rule].stage;
  }
  CHECK(stage >= 7);
  rules.stages[2] = 3;  // three deposits of stage 2, then stage 3 at once
  log = run(rules, config).log;
  const auto second = std::count_if(log.begin(), log.end(), [&](const Deposit& d) {
    return rules.rules[d.match.rule].stage == 2;
  });
  CHECK(second == 3);
}

TEST_CASE("the last stage's limit ends the run as a limit, not as saturation") {
  RuleSet rules = shipped("tiling");
  for (Rule& rule : rules.rules) rule.stage = 1;
  rules.stages[1] = 5;
  SwarmConfig config = walkers(rules, 9, 30);
  for (const Motion motion : {Motion::event, Motion::walk, Motion::teleport}) {
    config.motion = motion;
    const SwarmResult result = run(rules, config).result;
    CHECK(result.terminated == Terminated::deposits);
    CHECK(result.deposits == 5);
    CHECK(result.enabled_left > 0);
  }
}

TEST_CASE("what cannot run is said in words") {
  const RuleSet rules = shipped("stepped-pyramid");
  const RuleTable table(rules);
  const auto problem = [&](auto change) {
    SwarmConfig config = walkers(rules, 6, 10);
    change(config);
    return config_problem(table, rules.start, config);
  };
  CHECK(problem([](SwarmConfig&) {}) == "");
  CHECK(problem([](SwarmConfig& c) { c.box.reset(); }) == "agents need a box to move in");
  CHECK(problem([](SwarmConfig& c) { c.agents = 0; }) == "at least one agent is needed");
  CHECK(problem([](SwarmConfig& c) { c.moves = 8; }) ==
        "on the cubic lattice an agent has 6, 18 or 26 moves");
  CHECK(problem([](SwarmConfig& c) { c.agents = 216; }) ==
        "216 agents do not fit: the box has 215 empty cells");
  CHECK(problem([](SwarmConfig& c) { c.box->low.x = 1; }) ==
        "the start's brick at (0, 0, 0) is outside the box");
  CHECK(problem([](SwarmConfig& c) { c.box->size.x = 1 << 24; }) ==
        "the box is too large: at most 1073741824 cells");
  CHECK(problem([](SwarmConfig& c) {
          c.agents_at = {{0, 0, 0}};
        }) == "the agent's cell (0, 0, 0) is taken");
  CHECK(problem([](SwarmConfig& c) {
          c.agents_at = {{0, 0, 99}};
        }) == "the agent's cell (0, 0, 99) is outside the box");
}

TEST_CASE("a full box of agents runs") {
  const RuleSet rules = shipped("stepped-pyramid");
  for (const Motion motion : {Motion::walk, Motion::teleport}) {
    SwarmConfig config = walkers(rules, 6, 215);
    config.motion = motion;
    config.max_steps = 2000;
    const SwarmResult result = run(rules, config).result;
    CHECK(result.deposits == 14);
    CHECK(result.terminated == Terminated::saturated);
  }
}
