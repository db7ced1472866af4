// SPDX-License-Identifier: MIT
// The event engine for solid boxes against the one for all worlds.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "lattice/box_sites.h"
#include "lattice/engines.h"
#include "support/random_rules.h"
#include "support/shipped.h"
#include "support/small_worlds.h"
#include "support/uses.h"

using namespace stig;

namespace {

struct EventLog {
  std::vector<Deposit> deposits;
  SwarmResult result;
};

template <class Engine>
EventLog run_by(const Engine& engine, const RuleSet& rules, const SwarmConfig& config) {
  const RuleTable table(rules);
  EventLog log;
  SwarmHooks hooks;
  hooks.deposit = [&](const Deposit& d) { log.deposits.push_back(d); };
  log.result = engine(LatticeWorld(table, rules.start, config.box), config, hooks);
  return log;
}

SwarmConfig config_of(const RuleSet& rules, Offset size, std::uint64_t seed) {
  SwarmConfig config;
  config.motion = Motion::event;
  config.box = lay_box({size, std::nullopt, false}, rules.start, rules.floor);
  config.seed = seed;
  config.max_steps = 2000;
  return config;
}

/// Is the start in the box, so that there is a run?
bool can_run(const RuleSet& rules, const SwarmConfig& config) {
  return config_problem(RuleTable(rules), rules.start, config).empty();
}

/// The number of deposits, or nothing where the engines differ.
std::optional<std::size_t> same_runs(const RuleSet& rules, const SwarmConfig& config) {
  const EventLog one = run_by(run_event, rules, config);
  const EventLog other = run_by(run_event_anywhere, rules, config);
  bool same = one.deposits == other.deposits && one.result.steps == other.result.steps;
  same = same && one.result.terminated == other.result.terminated;
  same = same && one.result.stage == other.result.stage;
  same = same && one.result.enabled_left == other.result.enabled_left;
  same = same && one.result.structure == other.result.structure;
  if (!same) return std::nullopt;
  return one.deposits.size();
}

}  // namespace

TEST_CASE("shipped sets grow alike by both event engines") {
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    const RuleSet rules = shipped(name);
    for (const Offset size : {Offset{20, 20, 20}, Offset{9, 14, 7}}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const SwarmConfig config = config_of(rules, size, seed);
        if (!can_run(rules, config)) continue;
        const auto deposits = same_runs(rules, config);
        REQUIRE(deposits.has_value());
        CHECK(*deposits > 0);
      }
    }
  }
}

TEST_CASE("small worlds of all kinds grow alike by both event engines") {
  std::size_t deposits = 0, staged = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    CAPTURE(seed);
    for (RuleSet rules : {small_world(seed), staged_small_world(seed)}) {
      const auto extent = [&](int turn) { return 3 + static_cast<int>((seed >> turn) % 6); };
      SwarmConfig config = config_of(rules, {extent(0), extent(3), extent(6)}, seed);
      if (seed % 4 == 0) config.box->low.z -= 2;  // partly below the floor, where there is one
      if (!can_run(rules, config)) continue;
      const auto found = same_runs(rules, config);
      REQUIRE(found.has_value());
      deposits += *found;
      staged += rules.stage_count() > 1 ? *found : 0;
    }
  }
  CHECK(deposits > 10000);
  CHECK(staged > 3000);
}

TEST_CASE("law: any rule set grows alike by both event engines") {
  CHECK(rc::check("deposits, steps and the end", [] {
    const RuleSet rules = random_rule_set();
    const auto side = [] { return *rc::gen::inRange(1, 12); };
    const Offset size{side(), side(), side()};
    SwarmConfig config = config_of(rules, size, *rc::gen::arbitrary<std::uint64_t>());
    config.max_steps = 300;
    RC_PRE(can_run(rules, config));
    RC_ASSERT(same_runs(rules, config).has_value());
  }));
}

TEST_CASE("a run within a run, in the same box, changes neither") {
  const RuleSet rules = shipped("coral");
  const RuleTable table(rules);
  const SwarmConfig config = config_of(rules, {12, 12, 12}, 3);
  const EventLog alone = run_by(run_event, rules, config);
  REQUIRE(alone.deposits.size() > 50);
  std::size_t inner = 0;
  EventLog outer;
  SwarmHooks hooks;
  hooks.deposit = [&](const Deposit& d) {
    outer.deposits.push_back(d);
    if (outer.deposits.size() % 20 == 0) {
      inner += run_by(run_event, rules, config).deposits == alone.deposits ? 1 : 0;
    }
  };
  run_event(LatticeWorld(table, rules.start, config.box), config, hooks);
  CHECK(outer.deposits == alone.deposits);
  CHECK(inner == alone.deposits.size() / 20);
}

TEST_CASE("only solid boxes of a moderate size have the faster engine") {
  CHECK_FALSE(BoxSites::fit(std::nullopt));
  CHECK(BoxSites::fit(Box{{}, {20, 20, 20}}));
  CHECK(BoxSites::fit(Box{{}, {100, 100, 100}}));
  CHECK_FALSE(BoxSites::fit(Box{{}, {20, 20, 20}, true}));
  CHECK_FALSE(BoxSites::fit(Box{{}, {1000, 1000, 1000}}));
  CHECK_FALSE(BoxSites::fit(Box{{}, {INT32_MAX / 2, 1, 1}}));
}
