// SPDX-License-Identifier: MIT
// Event motion: the enabled sites are kept as a set, and each step takes one.
#include "lattice/enabled_set.h"
#include "lattice/engines.h"

namespace stig {
namespace {

class EventRun {
 public:
  EventRun(World world, const SwarmConfig& config, const SwarmHooks& hooks)
      : world_(std::move(world)),
        config_(&config),
        log_(config, hooks, world_.rules().rule_count()) {}

  SwarmResult run() {
    fill();
    const Terminated end = steps();
    const std::uint64_t left = enabled_.size();
    return log_.finish(world_, end, left, 0);
  }

 private:
  /// Enables the sites of the present stage, or of the next that has any.
  void fill() {
    do {
      enabled_.clear();
      if (!world_.stage_spent()) {
        for (const Cell site : world_.enabled_sites()) enabled_.insert(site);
      }
    } while (enabled_.size() == 0 && world_.next_stage());
  }

  Terminated steps() {
    while (true) {
      if (enabled_.size() == 0) return Terminated::saturated;
      if (log_.deposits_spent()) return Terminated::deposits;
      if (log_.limit_reached()) return log_.why();
      step();
    }
  }

  void step() {
    const std::uint64_t step = log_.begin_step();
    Random random(config_->seed, config_->run, Purpose::event, 0, step);
    const Cell site = enabled_[random.below(enabled_.size())];
    const Match match = world_.choose(site, random, scratch_);
    const double probability = world_.rules().probability(match.rule);
    if (probability < 1 && random.unit() >= probability) return;
    const Colour colour = world_.rules().place(match.rule);
    enabled_.erase(site);
    world_.deposit(site, colour, [&](Cell neighbour, bool enabled) {
      enabled ? enabled_.insert(neighbour) : enabled_.erase(neighbour);
    });
    log_.record({site, colour, match, -1, step});
    if (enabled_.size() == 0 || world_.stage_spent()) fill();
  }

  World world_;
  const SwarmConfig* config_;
  RunLog log_;
  EnabledSet enabled_;
  std::vector<Match> scratch_;
};

}  // namespace

SwarmResult run_event(World world, const SwarmConfig& config, const SwarmHooks& hooks) {
  return EventRun(std::move(world), config, hooks).run();
}

}  // namespace stig
