// SPDX-License-Identifier: MIT
// Event motion: the sites open in the present stage are kept as a set, and each step
// takes one. What later stages open is kept up to date beside it, so that a stage
// begins without a look at the whole structure.
#include "lattice/cell_marks.h"

#include <cassert>
#include "lattice/engines.h"

namespace stig::lattice {
namespace {

class EventRun {
 public:
  EventRun(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks)
      : world_(std::move(world)),
        config_(&config),
        log_(config, hooks, world_.rules().rule_count()),
        staged_(world_.rules().stage_count() > 1) {}

  SwarmResult run() {
    for (const Cell site : world_.candidates()) mark(site, world_.view(site));
    settle();
    const Terminated end = steps();
    const std::uint64_t left = open_.size();
    return log_.finish(world_, end, left, 0);
  }

 private:
  std::uint64_t present() const { return 1 | std::uint64_t{1} << world_.stage(); }

  // A deposit changes the views of at most 26 sites, which world_.deposit reports; all
  // other marks stay right. The cost of an event is therefore independent of the
  // structure's size.
  void mark(Cell site, const View& view) {
    const std::uint64_t stages = world_.rules().open_stages(view, site.z, world_.stage());
    // With one stage alone, a second record would only repeat the first.
    if (staged_ && !all_.set(site, stages)) return;  // nothing before, nothing now
    open_.set(site, stages & present());
  }

  /// Goes on to the next stage that has something open, if the present one has not. A stage
  /// that has nothing open when it begins ends at once, so several may be passed over.
  void settle() {
    while ((open_.size() == 0 || world_.stage_spent()) && world_.next_stage()) {
      open_.clear();
      for (const Cell site : all_.cells_with(present())) open_.set(site, present());
    }
  }

  Terminated steps() {
    while (true) {
      if (open_.size() == 0) return Terminated::saturated;
      if (log_.deposits_spent() || world_.stage_spent()) return Terminated::deposits;
      if (log_.limit_reached()) return log_.why();
      step();
    }
  }

  void step() {
    assert(open_.size() > 0);
    const std::uint64_t step = log_.begin_step();
    // One stream of random numbers for each step, addressed by its number: the choice of a
    // site, of a rule and of its firing come from it in this order, which traces and their
    // replay rely on.
    Random random(config_->seed, config_->run, Purpose::event, 0, step);
    const Cell site = open_[random.below(open_.size())];
    const Match match = world_.choose(site, random);
    const double probability = world_.rules().probability(match.rule);
    // A rule that does not fire leaves the site open; the step counts all the same.
    if (probability < 1 && random.unit() >= probability) return;
    const Colour colour = world_.rules().place(match.rule);
    open_.set(site, 0);
    if (staged_) all_.set(site, 0);
    world_.deposit(site, colour, [&](Cell neighbour, const View& view) { mark(neighbour, view); });
    log_.record({site, colour, match, -1, step});
    settle();
  }

  LatticeWorld world_;
  const SwarmConfig* config_;
  RunLog log_;
  CellMarks open_;  ///< sites of the present stage
  CellMarks all_;   ///< sites of this and later stages, with the stages as marks
  bool staged_;     ///< are there later stages at all?
};

}  // namespace

SwarmResult run_event(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks) {
  return EventRun(std::move(world), config, hooks).run();
}

}  // namespace stig::lattice
