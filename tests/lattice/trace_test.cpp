// SPDX-License-Identifier: MIT
#include "lattice/trace.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <atomic>

#include "rules/rule_printer.h"
#include "support/shipped.h"
#include "support/uses.h"

using namespace stig;

namespace {

struct Recorded {
  std::vector<Deposit> log;
  std::string bytes;
};

Recorded record(const RuleSet& rules, const SwarmConfig& config,
                const std::string& kind = "swarm") {
  Recorded out;
  TraceWriter writer(rules, config, kind);
  SwarmHooks hooks;
  hooks.deposit = [&](const Deposit& d) {
    out.log.push_back(d);
    writer.deposit(d);
  };
  const auto result = run_swarm(RuleTable(rules), rules.start, config, hooks);
  out.bytes = writer.finish(result.steps, result.terminated);
  return out;
}

SwarmConfig events(std::uint64_t deposits) {
  SwarmConfig config;
  config.motion = Motion::event;
  config.seed = 0xffffffffffffffffULL;
  config.max_deposits = deposits;
  return config;
}

std::optional<Trace> read_whole(const std::string& bytes) {
  Diagnostics diagnostics;
  auto trace = read_trace("t.stigt", bytes, diagnostics);
  CHECK(trace.has_value() != diagnostics.has_errors());
  return trace;
}

}  // namespace

TEST_CASE("a trace gives back the run and the rule set") {
  const RuleSet rules = shipped("tiling");
  const Recorded recorded = record(rules, events(5000));
  const auto trace = read_whole(recorded.bytes);
  REQUIRE(trace);
  CHECK(trace->events == recorded.log);
  CHECK(trace->hashes.size() == 4);
  CHECK(trace->rule_set_hash == rule_set_hash(rules));
  CHECK(trace->rule_set_yaml == print_rule_set(rules));
  CHECK(trace->config.seed == 0xffffffffffffffffULL);
  CHECK(trace->terminated == Terminated::deposits);
  CHECK(recorded.bytes.size() < 5000 * 12);
  CHECK(replay(*trace, rules).identical);
}

TEST_CASE("replay repeats every motion, box and agents included") {
  const RuleSet rules = shipped("stepped-pyramid");
  for (const Motion motion : {Motion::walk, Motion::teleport, Motion::event}) {
    SwarmConfig config;
    config.motion = motion;
    config.box = lay_box({{7, 7, 5}, std::nullopt, true}, rules.start, rules.floor);
    config.agents = 3;
    config.agents_at = {{2, 2, 2}};
    config.moves = 18;
    config.run = 5;
    config.max_steps = 100000;
    const auto trace = read_whole(record(rules, config).bytes);
    REQUIRE(trace);
    const ReplayReport report = replay(*trace, rules);
    INFO(report.difference);
    CHECK(report.identical);
    CHECK(report.compared == 14);
  }
}

TEST_CASE("replay names the first difference") {
  const RuleSet rules = shipped("stepped-pyramid");
  Trace trace = *read_whole(record(rules, events(14)).bytes);
  Trace other = trace;
  other.events[3].step += 1;
  CHECK(replay(other, rules).difference.starts_with("event 4: the trace has brick"));
  other = trace;
  other.final_hash ^= 1;
  CHECK(replay(other, rules).difference == "the final hash differs");
  other = trace;
  other.events.pop_back();
  CHECK(replay(other, rules).difference.starts_with("the trace ends after 13 events"));
  other = trace;
  other.events.push_back(other.events.back());
  CHECK(replay(other, rules).difference.starts_with("the run ends after 14 events"));
  RuleSet changed = rules;
  changed.rules.erase(changed.rules.begin());
  CHECK_FALSE(replay(trace, changed).identical);
}

TEST_CASE("a replay that is stopped tells a difference from an interruption") {
  const RuleSet rules = shipped("tiling");
  // A stop is only looked for after thousands of events.
  const Trace trace = *read_whole(record(rules, events(20'000)).bytes);
  const std::atomic<bool> stop{true};
  SwarmHooks hooks;
  hooks.stop = &stop;
  const ReplayReport stopped = replay(trace, rules, hooks);
  CHECK_FALSE(stopped.identical);
  CHECK(stopped.interrupted);
  CHECK(stopped.compared < 20'000);
  Trace other = trace;
  other.events[0].step += 1;
  const ReplayReport differs = replay(other, rules, hooks);
  CHECK_FALSE(differs.interrupted);
  CHECK(differs.difference.starts_with("event 1: "));
}

TEST_CASE("a given order is held to the rules, event by event") {
  const RuleSet rules = shipped("architecture-4n");
  SwarmConfig config;
  config.motion = Motion::event;
  Trace trace = *read_whole(record(rules, config, "given").bytes);
  CHECK(trace.kind == "given");
  CHECK(replay(trace, rules).identical);
  std::swap(trace.events[1], trace.events[5]);
  const ReplayReport report = replay(trace, rules);
  CHECK_FALSE(report.identical);
  CHECK(report.difference.starts_with("no rule allows"));
}

TEST_CASE("a given trace must name the rule that fits, and a world that can be") {
  const RuleSet rules = shipped("stepped-pyramid");
  SwarmConfig config;
  config.motion = Motion::event;
  const Trace trace = *read_whole(record(rules, config, "given").bytes);
  Trace other = trace;
  other.events[0].match.rule = (other.events[0].match.rule + 1) % 4;
  CHECK_FALSE(replay(other, rules).identical);
  other = trace;
  other.config.box = Box{{0, 0, 0}, {0, 0, 0}, true, false};
  CHECK(replay(other, rules).difference.starts_with("the recorded world is not possible"));
  other = trace;
  other.hashes.push_back(1);
  CHECK_FALSE(replay(other, rules).identical);
  other = trace;
  other.rule_set_hash ^= 1;
  CHECK(replay(other, rules).difference == "the rule set's hash differs");
}

TEST_CASE("damaged traces are refused") {
  const std::string bytes = record(shipped("staircase"), events(5)).bytes;
  CHECK_FALSE(read_whole(""));
  CHECK_FALSE(read_whole("stigtrc1"));
  CHECK_FALSE(read_whole("stigtrc2" + bytes.substr(8)));
  CHECK_FALSE(read_whole(bytes + "x"));
  for (std::size_t cut = 0; cut < bytes.size(); ++cut)
    CHECK_FALSE(read_whole(bytes.substr(0, cut)));
  CHECK(rc::check("a changed byte never crashes", [&] {
    std::string changed = bytes;
    const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
    changed[at] = *rc::gen::arbitrary<char>();
    read_whole(changed);
  }));
}
