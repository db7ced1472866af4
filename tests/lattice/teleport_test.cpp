// SPDX-License-Identifier: MIT
// The teleport engine, which passes over jumps, against agents that make each of them. Its runs are
// other runs, so what is compared is how often they end how.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "lattice/swarm.h"
#include "lattice/world.h"
#include "support/shipped.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr std::uint64_t kRuns = 4000;

/// What is compared of a run, each a whole number.
struct Figures {
  std::uint64_t steps, first_agent, bricks, hash;
};

Figures figures_of(std::uint64_t steps, std::int32_t first_agent, const Structure& structure) {
  return {steps, static_cast<std::uint64_t>(first_agent + 1), structure.size(),
          structure_hash(structure)};
}

/// Teleport motion as swarm.h words it, jump by jump.
class Plain {
 public:
  Plain(const RuleTable& table, const RuleSet& rules, const SwarmConfig& config, std::uint64_t run)
      : world_(table, rules.start, config.box),
        config_(config),
        random_(977, static_cast<std::uint32_t>(run), Purpose::test, 0, 0) {
    const Box& box = *config.box;
    for (int z = 0; z < box.size.z; ++z)
      for (int y = 0; y < box.size.y; ++y)
        for (int x = 0; x < box.size.x; ++x) cells_.push_back(box.low + Offset{x, y, z});
    at_ = config.agents_at;
    while (at_.size() < static_cast<std::size_t>(config.agents)) at_.push_back(target());
  }

  Figures run() {
    while (!ended() && step_ < *config_.max_steps) {
      ++step_;
      sweep();
    }
    return figures_of(step_, first_, world_.structure());
  }

 private:
  bool enabled(Cell cell) const {
    return world_.at(cell) == kEmpty &&
           world_.rules().enabled(world_.view(cell), cell.z, world_.stage());
  }
  bool ended() {
    while (world_.enabled_sites().empty() || world_.stage_spent()) {
      if (!world_.next_stage()) return true;
    }
    return deposits_ == config_.max_deposits;
  }
  bool free(Cell cell) const {
    return world_.placeable(cell) && world_.at(cell) == kEmpty &&
           std::find(at_.begin(), at_.end(), cell) == at_.end();
  }
  Cell target() {
    while (true) {
      const Cell cell = cells_[random_.below(cells_.size())];
      if (free(cell)) return cell;
    }
  }
  void sweep() {
    const std::size_t n = at_.size(), base = random_.below(n);
    std::size_t stride = 1 + random_.below(n);
    while (std::gcd(stride, n) != 1) stride = 1 + random_.below(n);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t agent = (base + k * stride) % n;
      if (enabled(at_[agent]) && fires(agent) && ended()) return;
      // The agent's own cell is among those that it may jump to.
      const Cell from = at_[agent];
      at_[agent] = Cell{1000, 1000, 1000};
      if (std::any_of(cells_.begin(), cells_.end(), [&](Cell c) { return free(c); })) {
        at_[agent] = target();
      } else {
        at_[agent] = from;
      }
    }
  }
  bool fires(std::size_t agent) {
    const Match match = world_.choose(at_[agent], random_);
    if (random_.unit() >= world_.rules().probability(match.rule)) return false;
    world_.deposit(at_[agent], world_.rules().place(match.rule), [](Cell, const View&) {});
    if (first_ < 0) first_ = static_cast<std::int32_t>(agent);
    ++deposits_;
    return true;
  }

  LatticeWorld world_;
  SwarmConfig config_;
  Random random_;
  std::vector<Cell> cells_, at_;
  std::uint64_t step_ = 0, deposits_ = 0;
  std::int32_t first_ = -1;
};

/// Chi squared of two samples of equal size, in standard deviations above its mean. Values are
/// joined, in their order, until there are fifty of them.
double excess(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  std::map<std::uint64_t, std::pair<double, double>> counts;
  for (const std::uint64_t v : a) ++counts[v].first;
  for (const std::uint64_t v : b) ++counts[v].second;
  double chi = 0, x = 0, y = 0;
  int groups = 0;
  const auto close = [&] {
    if (x + y > 0) chi += (x - y) * (x - y) / (x + y), ++groups;
    x = y = 0;
  };
  for (const auto& [value, count] : counts) {
    x += count.first;
    y += count.second;
    if (x + y >= 50) close();
  }
  close();
  const double freedom = std::max(groups - 1, 1);
  return (chi - freedom) / std::sqrt(2 * freedom);
}

void check_alike(const RuleSet& rules, SwarmConfig config) {
  config.motion = Motion::teleport;
  const RuleTable table(rules);
  REQUIRE(config_problem(table, rules.start, config) == "");
  std::array<std::vector<std::uint64_t>, 4> plain, engine;
  const auto note = [](auto& lists, const Figures& f) {
    lists[0].push_back(f.steps);
    lists[1].push_back(f.first_agent);
    lists[2].push_back(f.bricks);
    lists[3].push_back(f.hash);
  };
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    note(plain, Plain(table, rules, config, run).run());
    config.run = static_cast<std::uint32_t>(run);
    SwarmHooks hooks;
    std::int32_t first = -1;
    hooks.deposit = [&](const Deposit& d) { first = first < 0 ? d.agent : first; };
    const SwarmResult result = run_swarm(table, rules.start, config, hooks);
    note(engine, figures_of(result.steps, first, result.structure));
  }
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CAPTURE(i);
    CHECK(excess(plain[i], engine[i]) < 4);
  }
}

SwarmConfig agents_in(const RuleSet& rules, int side, int agents) {
  SwarmConfig config;
  config.box = lay_box({{side, side, side}, std::nullopt, false}, rules.start, rules.floor);
  config.agents = agents;
  config.max_steps = 400;
  return config;
}

}  // namespace

TEST_CASE("jumps that are passed over change no likelihood: races, rules that rarely fire") {
  RuleSet rules = shipped("order-dependent");
  check_alike(rules, agents_in(rules, 4, 7));
  for (Rule& rule : rules.rules) rule.probability = 0.3;
  SwarmConfig config = agents_in(rules, 3, 5);
  config.agents_at = {{0, 0, 1}, {1, 1, 0}};
  check_alike(rules, config);
}

TEST_CASE("jumps that are passed over change no likelihood: a crowded box") {
  const RuleSet rules = shipped("order-dependent");
  check_alike(rules, agents_in(rules, 3, 25));
}

TEST_CASE("jumps that are passed over change no likelihood: sites that open and close") {
  const RuleSet rules = shipped("coral");
  SwarmConfig config = agents_in(rules, 4, 9);
  config.max_deposits = 8;
  check_alike(rules, config);
}
