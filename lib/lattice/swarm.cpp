// SPDX-License-Identifier: MIT
// What all engines share of a run: the checks of its configuration, the record of steps and
// deposits with its limits, and ensembles. Limits are looked at before each step; the clock
// is never asked, so a run is a function of its configuration.
#include "lattice/swarm.h"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <set>

#include "base/parallel.h"
#include "lattice/engines.h"
#include "rules/cell_text.h"

namespace stig::lattice {
namespace {

constexpr std::int64_t kMostBoxCells = std::int64_t{1} << 30;
constexpr std::uint64_t kWorkBetweenHooks = 1U << 14;

/// 6, 18 and 26 are the neighbours by faces, by faces and edges, and all; of the hexagonal
/// lattice 8 and 20.
bool moves_exist(Lattice lattice, int moves) {
  return lattice == Lattice::cubic ? moves == 6 || moves == 18 || moves == 26
                                   : moves == 8 || moves == 20;
}

bool box_fits(const Box& box) {
  const auto side = [](std::int32_t s) { return s >= 1 && s <= kMaxCoordinate; };
  if (!side(box.size.x) || !side(box.size.y) || !side(box.size.z)) return false;
  // Engines pad a box by one cell all round. The padded box is an array of one byte per
  // cell in the walk engine, which bounds its size.
  const std::int64_t slice = (std::int64_t{box.size.x} + 2) * (std::int64_t{box.size.y} + 2);
  return slice <= kMostBoxCells && slice * (std::int64_t{box.size.z} + 2) <= kMostBoxCells;
}

/// The first problem is enough: the command line is corrected one step at a time.
std::string start_problem(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                          const std::optional<Box>& box) {
  std::set<Cell> cells;
  for (const PlacedBrick& b : start) {
    if (box && !box->contains(b.at))
      return "the start's brick at " + cell_text(b.at) + " is outside the box";
    if (rules.floor() && b.at.z < 0)
      return "the start's brick at " + cell_text(b.at) + " is below the floor";
    if (!cells.insert(b.at).second) return "the start has two bricks at " + cell_text(b.at);
  }
  return {};
}

/// Agents are placed by rejection later on, so it has to be certain that there is room for
/// all.
std::string agents_problem(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                           const SwarmConfig& config) {
  if (!config.box) return "agents need a box to move in";
  if (config.agents < 1) return "at least one agent is needed";
  if (!moves_exist(rules.lattice(), config.moves)) {
    return rules.lattice() == Lattice::cubic
               ? "on the cubic lattice an agent has 6, 18 or 26 moves"
               : "on the hexagonal lattice an agent has 8 or 20 moves";
  }
  // Cells below the floor count to the box and hold no agents.
  const std::int64_t below =
      rules.floor() && config.box->low.z < 0
          ? std::min<std::int64_t>(-std::int64_t{config.box->low.z}, config.box->size.z) *
                config.box->size.x * config.box->size.y
          : 0;
  const std::int64_t room = config.box->cells() - below - static_cast<std::int64_t>(start.size());
  if (config.agents > room) {
    return std::to_string(config.agents) + " agents do not fit: the box has " +
           std::to_string(room) + " empty cells";
  }
  if (config.agents_at.size() > static_cast<std::size_t>(config.agents)) {
    return "more cells for agents were given than there are agents";
  }
  std::set<Cell> taken;
  for (const PlacedBrick& b : start) taken.insert(b.at);
  for (const Cell c : config.agents_at) {
    if (!config.box->contains(c) || (rules.floor() && c.z < 0)) {
      return "the agent's cell " + cell_text(c) + " is outside the box";
    }
    if (!taken.insert(c).second) return "the agent's cell " + cell_text(c) + " is taken";
  }
  return {};
}

}  // namespace

std::string_view to_string(Motion motion) {
  switch (motion) {
    case Motion::walk:
      return "walk";
    case Motion::teleport:
      return "teleport";
    case Motion::event:
      return "event";
  }
  assert(false);
  return "";
}

std::string_view to_string(Terminated terminated) {
  switch (terminated) {
    case Terminated::saturated:
      return "saturated";
    case Terminated::steps:
      return "steps";
    case Terminated::deposits:
      return "deposits";
    case Terminated::interrupted:
      return "interrupted";
  }
  assert(false);
  return "";
}

RunLog::RunLog(const SwarmConfig& config, const SwarmHooks& hooks, std::size_t rules)
    : config_(&config), hooks_(&hooks) {
  result_.rules.resize(rules);
}

void RunLog::record(const Deposit& deposit) {
  assert(deposit.match.rule < result_.rules.size());
  ++result_.deposits;
  ++result_.rules[deposit.match.rule].fired;
  if (hooks_->deposit) hooks_->deposit(deposit);
}

bool RunLog::limit_reached(std::uint64_t work) {
  // The order matters where several limits are met at once: the number of steps is named
  // first.
  if (config_->max_steps && result_.steps >= *config_->max_steps) {
    why_ = Terminated::steps;
    return true;
  }
  // Hooks are called every few milliseconds, by counted work: a look at the clock would
  // cost more than a step of few agents.
  work_since_hooks_ += work;
  if (work_since_hooks_ < kWorkBetweenHooks) return false;
  work_since_hooks_ = 0;
  if (hooks_->progress) hooks_->progress(result_.steps, result_.deposits);
  if (!hooks_->stop || !hooks_->stop->load(std::memory_order_relaxed)) return false;
  why_ = Terminated::interrupted;
  return true;
}

bool RunLog::go_to_step(std::uint64_t step) {
  assert(step > result_.steps);
  const std::uint64_t passed = step - 1;
  result_.steps = config_->max_steps ? std::min(passed, *config_->max_steps) : passed;
  if (limit_reached()) return false;
  result_.steps = step;
  return true;
}

SwarmResult RunLog::finish(LatticeWorld& world, Terminated terminated, std::uint64_t enabled_left,
                           std::uint64_t out_of_reach) {
  result_.terminated = terminated;
  result_.enabled_left = enabled_left;
  result_.out_of_reach = out_of_reach;
  result_.stage = world.stage();
  result_.structure = world.take_structure();
  return std::move(result_);
}

std::string config_problem(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                           const SwarmConfig& config) {
  // The stream of random numbers has 24 bits for the run, and counts steps in blocks
  // (base/random.h).
  if (config.run >= 1U << 24) return "the number of a run is at most 16777215";
  if (config.max_steps && *config.max_steps >= std::uint64_t{1} << 43) {
    return "a run has at most 2^43 steps";
  }
  if (config.box && !box_fits(*config.box)) {
    return "the box is too large: at most " + std::to_string(kMostBoxCells) + " cells";
  }
  const std::string problem = start_problem(rules, start, config.box);
  if (!problem.empty() || config.motion == Motion::event) return problem;
  return agents_problem(rules, start, config);
}

SwarmResult run_swarm(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                      const SwarmConfig& config, const SwarmHooks& hooks) {
  assert(config_problem(rules, start, config).empty());
  LatticeWorld world(rules, start, config.box);
  switch (config.motion) {
    case Motion::walk:
      return run_walk(std::move(world), config, hooks);
    case Motion::teleport:
      return run_teleport(std::move(world), config, hooks);
    case Motion::event:
      break;
  }
  return run_event(std::move(world), config, hooks);
}

std::vector<SwarmResult> run_ensemble(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                                      const SwarmConfig& config, int runs, int threads,
                                      const std::function<void(int)>& done,
                                      const std::atomic<bool>* stop) {
  assert(runs >= 0);
  std::vector<SwarmResult> results(static_cast<std::size_t>(runs));
  // Each run writes its own slot of the results, so their order does not depend on threads.
  std::mutex mutex;
  int finished = 0;
  run_parallel(results.size(), threads, [&](std::size_t run) {
    SwarmConfig own = config;
    own.run = config.run + static_cast<std::uint32_t>(run);
    SwarmHooks hooks;
    hooks.stop = stop;
    results[run] = run_swarm(rules, start, own, hooks);
    // `done` runs under the lock, so callers need no other.
    const std::lock_guard lock(mutex);
    ++finished;
    if (done) done(finished);
  });
  return results;
}

/// Builds a world for one look: meant for single questions, not for loops.
View view_at(const Structure& structure, const RuleTable& rules, const std::optional<Box>& box,
             Cell site) {
  return LatticeWorld(rules, structure.bricks(), box).view(site);
}

std::vector<Cell> enabled_sites(const Structure& structure, const RuleTable& rules,
                                const std::optional<Box>& box, int stage) {
  LatticeWorld world(rules, structure.bricks(), box);
  while (world.stage() < stage && world.next_stage()) {
  }
  return world.enabled_sites();
}

}  // namespace stig::lattice
