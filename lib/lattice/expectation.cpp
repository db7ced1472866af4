// SPDX-License-Identifier: MIT
// Compares what a rule set does with what its file expects of it, and says by which method.
// Sampling can refute "coordinated" and prove "order-dependent"; only an exhausted search
// proves the former. The words of the report are chosen so that no sample passes for a
// proof.
#include "lattice/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/text.h"
#include "lattice/swarm.h"

namespace stig::lattice {
namespace {

/// What sampling and searching found.
struct Findings {
  std::vector<Structure> ends;  ///< distinct, at absolute places
  std::uint32_t samples = 0;    ///< orders sampled
  std::uint32_t growing = 0;    ///< of these, still growing at the limit on deposits
  std::uint32_t cut_short = 0;  ///< of these, stopped by the limit on steps
  bool exhausted = false;       ///< `ends` are the ends of all orders
  std::uint64_t states = 0;
  bool interrupted = false;

  std::string method() const {
    if (exhausted) return fmt::format("all {} reachable states", states);
    const std::string sampled = fmt::format("{} sampled orders", samples);
    if (states == 0) return sampled;
    return fmt::format("{}; trying all was given up after {} states", sampled, states);
  }
};

/// A box bounds growth by its cells, so every order ends within it and it needs no limit.
/// Without one, growth has to be given up on.
std::optional<std::uint64_t> deposit_limit(const RuleSet& rules, const ExpectationLimits& limits) {
  return rules.box ? std::nullopt : std::optional(limits.deposits);
}

/// Few ends are ever kept, so a linear search is enough.
void add_end(Findings& findings, Structure structure) {
  for (const Structure& end : findings.ends) {
    if (end == structure) return;
  }
  findings.ends.push_back(std::move(structure));
}

SwarmConfig event_config(const RuleSet& rules, const ExpectationLimits& limits) {
  SwarmConfig config;
  config.motion = Motion::event;
  if (rules.box) config.box = lay_box(*rules.box, rules.start, rules.floor);
  config.seed = limits.seed;
  config.max_deposits = deposit_limit(rules, limits);
  config.max_steps = limits.steps;
  return config;
}

/// Two ends are enough to refute. Orders that come to no end prove nothing, be they ever so
/// many; after eight of them more would cost time and say nothing new. The number is fixed
/// and counted in orders, so reports do not depend on the machine.
bool sampled_enough(const Findings& findings) {
  constexpr std::uint32_t kEnoughWithoutEnd = 8;
  return findings.ends.size() >= 2 || findings.growing + findings.cut_short >= kEnoughWithoutEnd;
}

/// Was the run still growing at the limit on deposits? A last stage that ends by a number of
/// deposits of its own has come to its end.
bool still_growing(const SwarmResult& result, const SwarmConfig& config) {
  return result.terminated == Terminated::deposits && config.max_deposits &&
         result.deposits >= *config.max_deposits;
}

void sample(const RuleTable& table, const RuleSet& rules, SwarmConfig config,
            const ExpectationLimits& limits, const EventOrdersHooks& hooks, Findings& findings) {
  SwarmHooks run_hooks;
  run_hooks.stop = hooks.stop;
  for (config.run = 0; config.run < limits.samples && !sampled_enough(findings); ++config.run) {
    SwarmResult result = run_swarm(table, rules.start, config, run_hooks);
    if (result.terminated == Terminated::interrupted) {
      findings.interrupted = true;
      return;
    }
    ++findings.samples;
    if (still_growing(result, config)) {
      ++findings.growing;
    } else if (result.terminated == Terminated::steps) {
      ++findings.cut_short;
    } else {
      add_end(findings, std::move(result.structure));
    }
  }
}

void search(const RuleTable& table, const RuleSet& rules, const SwarmConfig& config,
            const ExpectationLimits& limits, const EventOrdersHooks& hooks, Findings& findings) {
  EventOrders orders = explore_event_orders(table, rules.start, config.box, limits.search, hooks);
  findings.states = orders.states;
  findings.interrupted = hooks.stop != nullptr && *hooks.stop;
  findings.exhausted = orders.complete;
  for (Structure& end : orders.ends) add_end(findings, std::move(end));
}

std::string no_end_in_words(const Findings& findings, const ExpectationLimits& limits) {
  if (findings.growing > 0) {
    return fmt::format("no end found; {} of {} sampled orders still growing after {} deposits",
                       findings.growing, findings.samples, limits.deposits);
  }
  if (findings.cut_short == 0) return "no end found";
  return fmt::format("no end found; {} of {} sampled orders stopped after {} steps",
                     findings.cut_short, findings.samples, limits.steps);
}

std::string ends_in_words(const Findings& findings, const ExpectationLimits& limits) {
  if (findings.ends.empty()) return no_end_in_words(findings, limits);
  std::size_t least = findings.ends.front().size(), most = least;
  for (const Structure& end : findings.ends) {
    least = std::min(least, end.size());
    most = std::max(most, end.size());
  }
  const std::string bricks =
      least == most ? counted(least, "brick") : fmt::format("{} to {} bricks", least, most);
  if (findings.ends.size() == 1) return "one end, " + bricks;
  return fmt::format("{}{} different ends, {}", findings.exhausted ? "" : "at least ",
                     findings.ends.size(), bricks);
}

/// A claim about every end, all of those found agreeing with it. If a sample was cut short,
/// it may have been on its way to another end.
Standing standing_of_agreement(const Findings& findings) {
  if (findings.exhausted) return Standing::held;
  if (findings.ends.empty() || findings.growing > 0 || findings.cut_short > 0) {
    return Standing::undecided;
  }
  return Standing::not_contradicted;
}

/// Two different ends settle two of the verdicts at once, each in its own direction.
void assess_verdict(Verdict expected, const Findings& findings, const ExpectationLimits& limits,
                    ExpectationItem& item) {
  item.found = ends_in_words(findings, limits);
  item.method = findings.method();
  switch (expected) {
    case Verdict::coordinated:
      item.standing = findings.ends.size() > 1 ? Standing::failed : standing_of_agreement(findings);
      return;
    case Verdict::order_dependent:
      if (findings.ends.size() > 1) {
        item.standing = Standing::held;
        item.method = findings.exhausted ? findings.method() : "two orders that end differently";
      } else {
        item.standing = findings.exhausted ? Standing::failed : Standing::undecided;
      }
      return;
    // "Endless" is never proved here; `stigc verify` can (docs/proofs.md, "Growth without
    // end").
    case Verdict::endless:
      item.standing = !findings.ends.empty() ? Standing::failed
                      : findings.growing > 0 ? Standing::not_contradicted
                                             : Standing::undecided;
      return;
  }
}

void assess_bricks(std::int64_t expected, const Findings& findings, const ExpectationLimits& limits,
                   ExpectationItem& item) {
  const auto fits = [&](const Structure& end) {
    return end.size() == static_cast<std::size_t>(expected);
  };
  item.found = ends_in_words(findings, limits);
  item.method = findings.method();
  item.standing = std::all_of(findings.ends.begin(), findings.ends.end(), fits)
                      ? standing_of_agreement(findings)
                      : Standing::failed;
}

/// Where two structures at the origin differ first, in words. The first difference in cell
/// order is the same on every run, and usually enough to see what went wrong.
std::string first_difference(const RuleSet& rules, const Structure& wanted, const Structure& got) {
  const auto name = [&](State state) {
    return state == kEmpty ? std::string("empty") : "brick " + rules.brick(state).symbol;
  };
  std::vector<PlacedBrick> cells = wanted.bricks();
  const auto more = got.bricks();
  cells.insert(cells.end(), more.begin(), more.end());
  std::sort(cells.begin(), cells.end());
  for (const PlacedBrick& cell : cells) {
    const State want = wanted.at(cell.at), have = got.at(cell.at);
    if (want == have) continue;
    return fmt::format("at ({}, {}, {}) from the lowest corner {}, not {}", cell.at.x, cell.at.y,
                       cell.at.z, name(have), name(want));
  }
  return "nothing";
}

void assess_structure(const RuleSet& rules, const Findings& findings,
                      const ExpectationLimits& limits, ExpectationItem& item) {
  // Structures are compared up to translation, as files draw them at the origin.
  const Structure wanted = to_origin(Structure(rules.lattice, rules.expect->structure));
  item.method = findings.method();
  for (const Structure& end : findings.ends) {
    const Structure got = to_origin(end);
    if (got == wanted) continue;
    item.standing = Standing::failed;
    item.found =
        fmt::format("{}; {}", counted(got.size(), "brick"), first_difference(rules, wanted, got));
    return;
  }
  item.standing = standing_of_agreement(findings);
  item.found = findings.ends.empty() ? no_end_in_words(findings, limits) : "as drawn";
}

std::vector<ExpectationItem> assess(const RuleSet& rules, const Findings& findings,
                                    const ExpectationLimits& limits) {
  assert(rules.expect);
  const Expectation& expect = *rules.expect;
  std::vector<ExpectationItem> items;
  if (expect.bricks) {
    items.push_back({"bricks", {}, fmt::to_string(*expect.bricks), {}, {}, expect.bricks_range});
    assess_bricks(*expect.bricks, findings, limits, items.back());
  }
  if (expect.verdict) {
    items.push_back(
        {"verdict", {}, std::string(to_string(*expect.verdict)), {}, {}, expect.verdict_range});
    assess_verdict(*expect.verdict, findings, limits, items.back());
  }
  if (!expect.structure.empty()) {
    items.push_back({"structure",
                     {},
                     counted(expect.structure.size(), "brick") + " as drawn",
                     {},
                     {},
                     expect.structure_range});
    assess_structure(rules, findings, limits, items.back());
  }
  return items;
}

}  // namespace

std::string_view to_string(Standing standing) {
  switch (standing) {
    case Standing::held:
      return "held";
    case Standing::not_contradicted:
      return "not-contradicted";
    case Standing::failed:
      return "failed";
    case Standing::undecided:
      return "undecided";
  }
  assert(false);
  return "";
}

bool ExpectationReport::passed() const {
  return problem.empty() && !interrupted &&
         std::all_of(items.begin(), items.end(), [](const ExpectationItem& item) {
           return item.standing == Standing::held || item.standing == Standing::not_contradicted;
         });
}

ExpectationReport verify_expectation(const RuleSet& rules, const ExpectationLimits& limits,
                                     const EventOrdersHooks& hooks) {
  ExpectationReport report;
  if (!rules.expect) return report;
  const RuleTable table(rules);
  const SwarmConfig config = event_config(rules, limits);
  report.problem = config_problem(table, rules.start, config);
  if (!report.problem.empty()) return report;
  Findings findings;
  sample(table, rules, config, limits, hooks, findings);
  // Growth has no finite set of states, and two ends have settled the matter: no search
  // then.
  if (!findings.interrupted && findings.ends.size() < 2 && findings.growing == 0) {
    search(table, rules, config, limits, hooks, findings);
  }
  report.states = findings.states;
  report.interrupted = findings.interrupted;
  if (!report.interrupted) report.items = assess(rules, findings, limits);
  return report;
}

}  // namespace stig::lattice
