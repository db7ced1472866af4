// SPDX-License-Identifier: MIT
// Replay: a swarm's trace is run again and compared event by event; a given order
// of events is checked against the rules.
#include <algorithm>
#include <atomic>

#include "lattice/trace.h"
#include "lattice/world.h"
#include "rules/rule_printer.h"

namespace stig::lattice {
namespace {

std::string to_text(const Deposit& d, const RuleSet& rules) {
  const std::string rule =
      d.match.rule < rules.rules.size() ? "'" + rules.rules[d.match.rule].name + "'" : "unknown";
  return "brick " + std::to_string(d.colour) + " at (" + std::to_string(d.site.x) + ", " +
         std::to_string(d.site.y) + ", " + std::to_string(d.site.z) + ") by rule " + rule +
         ", agent " + std::to_string(d.agent) + ", step " + std::to_string(d.step);
}

/// What is wrong with an event in the structure as it stands, in words; empty: nothing.
std::string problem_of(const Deposit& event, const RuleSet& rules, const Structure& structure) {
  if (event.colour > rules.bricks.size()) return "places a brick that its rules do not have";
  if (event.match.rule >= rules.rules.size()) return "is of a rule that there is not";
  const bool far = std::max({std::abs(event.site.x), std::abs(event.site.y),
                             std::abs(event.site.z)}) > kMaxCoordinate;
  if (far) return "is too far away";
  return structure.at(event.site) != kEmpty ? "is in a cell that has a brick" : "";
}

/// Compares a stream of events with the trace's, hashes included. Only the first difference
/// is kept: everything after it follows from it.
class Comparison {
 public:
  Comparison(const Trace& trace, const RuleSet& rules) : trace_(trace), rules_(rules) {
    for (const PlacedBrick& b : rules.start) hash_ += placement_hash(b.at, b.brick);
  }

  void event(const Deposit& d) {
    if (!report_.difference.empty()) return;
    const std::uint64_t number = ++report_.compared;
    if (number > trace_.events.size()) {
      return differ("the trace ends after " + std::to_string(number - 1) +
                    " events, the run goes on with " + to_text(d, rules_));
    }
    const Deposit& expected = trace_.events[number - 1];
    if (!(d == expected)) {
      return differ("event " + std::to_string(number) + ": the trace has " +
                    to_text(expected, rules_) + "; the run has " + to_text(d, rules_));
    }
    hash_ += placement_hash(d.site, d.colour);
    if (number % kTraceHashEvery != 0) return;
    const std::uint64_t at = number / kTraceHashEvery - 1;
    if (at >= trace_.hashes.size() || trace_.hashes[at] != hash_) {
      differ("the state hash after event " + std::to_string(number) + " differs");
    }
  }

  ReplayReport finish() {
    if (report_.difference.empty() && report_.compared < trace_.events.size()) {
      differ("the run ends after " + std::to_string(report_.compared) + " events, the trace has " +
             std::to_string(trace_.events.size()));
    }
    if (trace_.hashes.size() != trace_.events.size() / kTraceHashEvery) {
      differ("the trace has " + std::to_string(trace_.hashes.size()) + " state hashes for " +
             std::to_string(trace_.events.size()) + " events");
    }
    if (hash_ != trace_.final_hash) differ("the final hash differs");
    if (rule_set_hash(rules_) != trace_.rule_set_hash) differ("the rule set's hash differs");
    report_.identical = report_.difference.empty();
    return std::move(report_);
  }
  void differ(std::string what) {
    if (report_.difference.empty()) report_.difference = std::move(what);
  }
  /// What was stopped after a difference has its verdict.
  void interrupt() {
    report_.interrupted = report_.difference.empty();
    differ("replay was interrupted");
  }
  bool differs() const { return !report_.difference.empty(); }

 private:
  const Trace& trace_;
  const RuleSet& rules_;
  std::uint64_t hash_ = 0;
  ReplayReport report_;
};

ReplayReport rerun(const Trace& trace, const RuleSet& rules, const SwarmHooks& outer) {
  Comparison comparison(trace, rules);
  const RuleTable table(rules);
  SwarmConfig config = trace.config;
  // Traces do not store the floor; it is a property of the rules.
  if (config.box) config.box->floor = rules.floor;
  // An interrupted run is repeated as far as it went. The number of steps that it had done
  // bounds the repetition, which then ends by its limit.
  if (trace.terminated == Terminated::interrupted) config.max_steps = trace.steps;
  const std::string problem = config_problem(table, rules.start, config);
  if (!problem.empty()) {
    comparison.differ("the recorded run is not possible: " + problem);
    return comparison.finish();
  }
  // Ends at the first difference, or when stopped from outside. The hook for deposits
  // cannot stop a run by itself; the flag is polled by the engine.
  std::atomic<bool> halt{false};
  const auto poll = [&] { halt = comparison.differs() || (outer.stop && outer.stop->load()); };
  SwarmHooks hooks;
  hooks.stop = &halt;
  hooks.progress = [&](std::uint64_t steps, std::uint64_t deposits) {
    poll();
    if (outer.progress) outer.progress(steps, deposits);
  };
  hooks.deposit = [&](const Deposit& d) { comparison.event(d); };
  const SwarmResult result = run_swarm(table, rules.start, config, hooks);
  const bool recorded_end =
      result.terminated == trace.terminated || trace.terminated == Terminated::interrupted;
  if (result.terminated == Terminated::interrupted) {
    comparison.interrupt();
  } else if (!recorded_end || result.steps != trace.steps) {
    comparison.differ("the run ends after " + std::to_string(result.steps) + " steps (" +
                      std::string(to_string(result.terminated)) + "), the trace after " +
                      std::to_string(trace.steps) + " (" +
                      std::string(to_string(trace.terminated)) + ")");
  }
  return comparison.finish();
}

/// Advances through stages until the event is open; false when it never is. A given order
/// names no stages. A stage may be left when it has nothing open or has had its deposits;
/// if the event is not open then, the order breaks the rules.
bool open_at(LatticeWorld& world, const Deposit& event) {
  std::vector<Match> matches;
  do {
    if (world.is_site(event.site)) {
      world.rules().matches(world.view(event.site), event.site.z, world.stage(), matches);
      const bool first_acts = world.rules().conflicts() == Conflicts::first;
      if (first_acts && matches.size() > 1) matches.resize(1);
      const bool found = std::find(matches.begin(), matches.end(), event.match) != matches.end() &&
                         world.rules().place(event.match.rule) == event.colour;
      if (found && !world.stage_spent()) return true;
    }
    if (!world.stage_spent() && !world.enabled_sites().empty()) return false;
  } while (world.next_stage());
  return false;
}

/// The hash is compared at the same events as in a run, so a damaged trace is found close
/// to the damage.
ReplayReport check_given(const Trace& trace, const RuleSet& rules, const SwarmHooks& hooks) {
  Comparison comparison(trace, rules);
  const RuleTable table(rules);
  SwarmConfig config = trace.config;
  config.motion = Motion::event;  // no agents: the order is given
  if (config.box) config.box->floor = rules.floor;
  const std::string problem = config_problem(table, rules.start, config);
  if (!problem.empty()) {
    comparison.differ("the recorded world is not possible: " + problem);
    return comparison.finish();
  }
  LatticeWorld world(table, rules.start, config.box);
  for (const Deposit& event : trace.events) {
    if (hooks.stop && hooks.stop->load()) comparison.interrupt();
    if (!comparison.differs() && !open_at(world, event)) {
      comparison.differ("no rule allows " + to_text(event, rules));
    }
    if (comparison.differs()) break;
    world.deposit(event.site, event.colour, [](Cell, const View&) {});
    comparison.event(event);
  }
  return comparison.finish();
}

}  // namespace

std::optional<std::string> problem_of_events(const Trace& trace, const RuleSet& rules) {
  Structure structure(rules.lattice, rules.start);
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    const std::string problem = problem_of(trace.events[i], rules, structure);
    // Events are counted from 1 in messages.
    if (!problem.empty()) return "event " + std::to_string(i + 1) + " " + problem;
    structure.place(trace.events[i].site, trace.events[i].colour);
  }
  return std::nullopt;
}

ReplayReport replay(const Trace& trace, const RuleSet& rules, const SwarmHooks& hooks) {
  return trace.kind == "given" ? check_given(trace, rules, hooks) : rerun(trace, rules, hooks);
}

}  // namespace stig::lattice
