// SPDX-License-Identifier: MIT
// Running a swarm on the lattice.
//
// Agents only choose the order of events. Three motion models:
//   walk      each step every agent acts once, in an order drawn for that step:
//             if its site is stimulating it deposits, then it moves to a uniformly
//             chosen neighbour (6, 18 or 26; hexagonal 8 or 20), staying put when
//             that cell is outside, a brick or another agent's. An agent that sits
//             in the brick it placed keeps trying to leave. (Theraulaz & Bonabeau
//             1995, J. theor. Biol. 177:381-400.)
//   teleport  the same, but the move is a jump to a uniformly chosen empty cell
//             without an agent.
//   event     no agents: each step picks one of the enabled sites uniformly.
// When rules of several kinds match a site, one is chosen (the first in the file,
// or by weight under `conflicts: random`); it then fires with its probability.
//
// Determinism: every random number is a Philox word addressed by (seed, run,
// purpose, agent, step), so a run is a function of its config alone, whatever
// else runs beside it.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "lattice/box.h"
#include "lattice/structure.h"
#include "lattice/uses.h"
#include "rules/rule_table.h"

namespace stig::lattice {

enum class Motion : std::uint8_t { walk, teleport, event };
/// saturated: no site is enabled, in this stage or a later one. deposits: the run's limit
/// on them, or that of its last stage, is reached.
enum class Terminated : std::uint8_t { saturated, steps, deposits, interrupted };

std::string_view to_string(Motion motion);
std::string_view to_string(Terminated terminated);

struct SwarmConfig {
  Motion motion = Motion::walk;
  std::optional<Box> box;       ///< walk and teleport need one; event may grow freely
  int agents = 10;              ///< >= 1; ignored by event
  int moves = 26;               ///< 6 | 18 | 26, hexagonal 8 | 20
  std::vector<Cell> agents_at;  ///< first agents' cells; the rest start uniformly
  std::uint64_t seed = 1;
  std::uint32_t run = 0;  ///< number of the run within an ensemble
  bool vectorise = true;  ///< use vector instructions; results are the same
  std::optional<std::uint64_t> max_steps;
  std::optional<std::uint64_t> max_deposits;
};

/// One brick placed.
struct Deposit {
  Cell site;
  Colour colour = 0;
  Match match;              ///< rule and orientation
  std::int32_t agent = -1;  ///< -1: event motion
  std::uint64_t step = 0;   ///< 1-based
  bool operator==(const Deposit&) const = default;
};

struct RuleStatistics {
  std::uint64_t fired = 0;
};

struct SwarmResult {
  Structure structure;      ///< start included
  std::uint64_t steps = 0;  ///< steps done
  std::uint64_t deposits = 0;
  Terminated terminated = Terminated::saturated;
  int stage = 1;                      ///< stage reached
  std::vector<RuleStatistics> rules;  ///< by rule index
  std::uint64_t enabled_left = 0;     ///< sites with a match at the end (of the stage reached)
  std::uint64_t out_of_reach = 0;     ///< of these, how many no agent can walk to
};

/// Called during a run, all optional.
struct SwarmHooks {
  std::function<void(const Deposit&)> deposit;
  /// Now and then (every few milliseconds at most): steps and deposits so far.
  std::function<void(std::uint64_t steps, std::uint64_t deposits)> progress;
  const std::atomic<bool>* stop = nullptr;  ///< set: finish soon, Terminated::interrupted
};

/// What is wrong with a config for this rule set and start, in words; empty: nothing.
std::string config_problem(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                           const SwarmConfig& config);

/// The config must have no problem (asserted).
SwarmResult run_swarm(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                      const SwarmConfig& config, const SwarmHooks& hooks = {});

/// Runs config.run = 0 … runs-1 on `threads` threads; results in order of run, the
/// same for any number of threads. Hooks other than `stop` must be thread-safe.
/// `done` is called with the number of finished runs, under a lock.
std::vector<SwarmResult> run_ensemble(const RuleTable& rules, const std::vector<PlacedBrick>& start,
                                      const SwarmConfig& config, int runs, int threads,
                                      const std::function<void(int)>& done = {},
                                      const std::atomic<bool>* stop = nullptr);

/// What an agent at `site` sees: neighbours of `structure`, with floor and box.
View view_at(const Structure& structure, const RuleTable& rules, const std::optional<Box>& box,
             Cell site);
/// All sites that some rule of `stage` matches, in cell order.
std::vector<Cell> enabled_sites(const Structure& structure, const RuleTable& rules,
                                const std::optional<Box>& box, int stage);

}  // namespace stig::lattice
