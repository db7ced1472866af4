// SPDX-License-Identifier: MIT
// Teleport motion by events. Most jumps end in cells where no rule matches or ever matched, and
// these are not made: an agent there is known to be somewhere among such cells and no more.
//
// Cells where a rule matches or once matched, and those where agents were set, are tracked: it is
// known whether an agent is in them. All other agents are hidden. Given that no jump met a tracked
// cell, the hidden agents are spread uniformly over the cells that are not tracked, one to a cell:
// they start so, and a jump to a uniformly chosen free one of these cells leaves it so. So every
// turn of a hidden agent meets a tracked cell with the same probability, and the number of turns
// until one does is geometric. A cell that comes to be tracked holds a hidden agent with the
// probability that hidden agents have of any cell, and by symmetry any of them.
#include <cassert>
#include <compare>
#include <limits>
#include <queue>

#include "lattice/agent_orders.h"
#include "lattice/cell_marks.h"
#include "lattice/engines.h"

namespace stig::lattice {
namespace {

/// A turn of one agent: the place-th of a step. All turns of a run are so ordered.
struct Turn {
  std::uint64_t step = 0;
  std::uint32_t place = 0;
  auto operator<=>(const Turn&) const = default;
};
constexpr Turn kNever{std::numeric_limits<std::uint64_t>::max(), 0};

/// Numbers below a bound: a list, and each number's place in it. The last takes the place of one
/// that goes.
class AgentSet {
 public:
  explicit AgentSet(std::size_t bound) : place_(bound) {}
  std::size_t size() const { return list_.size(); }
  std::uint32_t operator[](std::size_t i) const { return list_[i]; }
  void add(std::uint32_t agent) {
    place_[agent] = static_cast<std::uint32_t>(list_.size());
    list_.push_back(agent);
  }
  void remove(std::uint32_t agent) {
    assert(list_[place_[agent]] == agent);
    place_[list_.back()] = place_[agent];
    list_[place_[agent]] = list_.back();
    list_.pop_back();
  }

 private:
  std::vector<std::uint32_t> list_;
  std::vector<std::uint32_t> place_;
};

/// How many trials fail before one succeeds, if each fails with probability `fails` < 1: the most
/// n with fails^n > u, for u uniform in [0, 1). Products alone, no logarithm: those are the same
/// on every machine.
std::uint64_t failures(double fails, double u) {
  constexpr std::size_t kPowers = 46;   // beyond 2^46 failures nothing is left but rounding
  std::array<double, kPowers> power{};  // fails^(2^i)
  std::size_t known = 0;
  for (double p = fails; known < kPowers && p > u; p *= p) power[known++] = p;
  std::uint64_t count = 0;
  double all = 1;
  while (known-- > 0) {
    if (all * power[known] <= u) continue;
    all *= power[known];
    count += std::uint64_t{1} << known;
  }
  return count;
}

class TeleportRun {
 public:
  TeleportRun(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks);
  SwarmResult run();

 private:
  struct Due {
    Turn turn;
    std::uint32_t agent;
    bool operator>(const Due& other) const { return turn > other.turn; }
  };

  void fill();
  Terminated turns();
  Turn next_meeting(Random& random) const;
  void meet(Random& random);
  void act(std::uint32_t agent, Random& random);
  void stimulate(std::uint32_t agent);
  void jump(std::uint32_t agent, Random& random);
  void arrive(std::uint32_t agent, Cell cell);
  void track(Cell cell);
  void schedule(std::uint32_t agent);
  /// Random numbers of one event, or of one look at a cell, in the order in which they come.
  Random next_stream() { return Random(config_->seed, config_->run, Purpose::move, 0, streams_++); }
  std::uint64_t untracked() const { return empty_ - free_.size() - taken_.size(); }
  /// Cells without brick and agent that are not tracked.
  std::uint64_t untracked_free() const { return untracked() - hidden_.size(); }

  LatticeWorld world_;
  const SwarmConfig* config_;
  RunLog log_;
  AgentOrders orders_;
  std::uint64_t empty_;  ///< number of cells without brick
  CellMarks enabled_;    ///< all of them tracked
  CellMarks free_;       ///< tracked, without agent
  CellMarks taken_;      ///< tracked, with one
  AgentSet hidden_;
  std::vector<Cell> at_;  ///< of agents that are not hidden
  std::priority_queue<Due, std::vector<Due>, std::greater<>> due_;  ///< their next turns
  Turn now_;
  std::uint64_t streams_ = 0;
};

std::uint64_t empty_cells(const LatticeWorld& world) {
  const Box& box = *world.box();
  std::int64_t levels = 0;
  for (std::int32_t z = 0; z < box.size.z; ++z) {
    levels += world.placeable(box.low + Offset{0, 0, z}) ? 1 : 0;
  }
  return static_cast<std::uint64_t>(levels * box.size.x * box.size.y) - world.structure().size();
}

TeleportRun::TeleportRun(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks)
    : world_(std::move(world)),
      config_(&config),
      log_(config, hooks, world_.rules().rule_count()),
      orders_(config.seed, config.run, static_cast<std::uint32_t>(config.agents)),
      empty_(empty_cells(world_)),
      hidden_(static_cast<std::size_t>(config.agents)),
      at_(static_cast<std::size_t>(config.agents)),
      now_{0, static_cast<std::uint32_t>(config.agents) - 1} {
  std::uint32_t agent = 0;
  for (const Cell cell : config.agents_at) arrive(agent++, cell);
  for (; agent < static_cast<std::uint32_t>(config.agents); ++agent) hidden_.add(agent);
}

SwarmResult TeleportRun::run() {
  fill();
  const Terminated end = turns();
  return log_.finish(world_, end, enabled_.size(), 0);
}

/// Enables the sites of the present stage, or of the next that has any.
void TeleportRun::fill() {
  do {
    enabled_.clear();
    for (const Cell site : world_.enabled_sites()) {
      enabled_.set(site, 1);
      track(site);
    }
  } while ((enabled_.size() == 0 || world_.stage_spent()) && world_.next_stage());
}

Terminated TeleportRun::turns() {
  while (true) {
    if (enabled_.size() == 0) return Terminated::saturated;
    if (log_.deposits_spent() || world_.stage_spent()) return Terminated::deposits;
    Random random = next_stream();
    const Turn meeting = next_meeting(random);
    // A turn that is due is no hidden agent's. What was drawn beyond it is forgotten, as the
    // geometric distribution has no memory.
    const bool is_due = !due_.empty() && due_.top().turn <= meeting;
    const Turn next = is_due ? due_.top().turn : meeting;
    assert(next != kNever);
    if (next.step > now_.step && !log_.go_to_step(next.step)) return log_.why();
    now_ = next;
    if (is_due) {
      const std::uint32_t agent = due_.top().agent;
      due_.pop();
      act(agent, random);
    } else {
      meet(random);
    }
  }
}

/// The first turn in which a hidden agent jumps to a tracked cell, if all turns are theirs.
Turn TeleportRun::next_meeting(Random& random) const {
  if (hidden_.size() == 0 || free_.size() == 0) return kNever;
  // The agent that jumps may stay where it is.
  const auto misses = static_cast<double>(untracked_free() + 1);
  const auto meets = static_cast<double>(free_.size());
  const std::uint64_t turns = now_.place + 1 + failures(misses / (misses + meets), random.unit());
  const auto agents = static_cast<std::uint64_t>(config_->agents);
  return {now_.step + turns / agents, static_cast<std::uint32_t>(turns % agents)};
}

void TeleportRun::meet(Random& random) {
  const std::uint32_t agent = agent_at(orders_.of_step(now_.step), now_.place);
  hidden_.remove(agent);
  arrive(agent, free_[random.below(free_.size())]);
}

void TeleportRun::act(std::uint32_t agent, Random& random) {
  if (enabled_.contains(at_[agent])) stimulate(agent);
  jump(agent, random);
}

/// The agent's site matches: deposit, with the rule's probability.
void TeleportRun::stimulate(std::uint32_t agent) {
  const Cell site = at_[agent];
  Random random(config_->seed, config_->run, Purpose::deposit, agent, now_.step);
  const Match match = world_.choose(site, random);
  const double probability = world_.rules().probability(match.rule);
  if (probability < 1 && random.unit() >= probability) return;
  const Colour colour = world_.rules().place(match.rule);
  enabled_.set(site, 0);
  taken_.set(site, 0);
  --empty_;
  world_.deposit(site, colour, [&](Cell neighbour, const View& view) {
    const bool open = world_.rules().enabled(view, neighbour.z, world_.stage());
    enabled_.set(neighbour, open ? 1 : 0);
    if (open) track(neighbour);
  });
  log_.record({site, colour, match, static_cast<std::int32_t>(agent), now_.step});
  if (enabled_.size() == 0 || world_.stage_spent()) fill();
}

/// Moves an agent that is not hidden, from a tracked cell or out of the brick that it placed.
void TeleportRun::jump(std::uint32_t agent, Random& random) {
  if (taken_.set(at_[agent], 0)) free_.set(at_[agent], 1);
  const std::uint64_t tracked = free_.size(), targets = tracked + untracked_free();
  if (targets == 0) return schedule(agent);  // in a brick, and nowhere to go
  const std::uint64_t target = random.below(targets);
  target < tracked ? arrive(agent, free_[target]) : hidden_.add(agent);
}

void TeleportRun::arrive(std::uint32_t agent, Cell cell) {
  free_.set(cell, 0);
  taken_.set(cell, 1);
  at_[agent] = cell;
  schedule(agent);
}

/// From now on it is known whether an agent is in this cell.
void TeleportRun::track(Cell cell) {
  if (free_.contains(cell) || taken_.contains(cell)) return;
  Random random = next_stream();
  const std::uint64_t who = random.below(untracked());
  if (who >= hidden_.size()) {
    free_.set(cell, 1);
    return;
  }
  const std::uint32_t agent = hidden_[who];
  hidden_.remove(agent);
  arrive(agent, cell);
}

/// The agent's next turn: in this step, unless it has had it.
void TeleportRun::schedule(std::uint32_t agent) {
  const std::uint32_t place = place_in(orders_.of_step(now_.step), agent);
  if (place > now_.place) {
    due_.push({{now_.step, place}, agent});
  } else {
    due_.push({{now_.step + 1, place_in(orders_.of_step(now_.step + 1), agent)}, agent});
  }
}

}  // namespace

SwarmResult run_teleport(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks) {
  return TeleportRun(std::move(world), config, hooks).run();
}

}  // namespace stig::lattice
