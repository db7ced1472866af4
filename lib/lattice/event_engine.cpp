// SPDX-License-Identifier: MIT
// Event motion: the sites open in the present stage are kept as a set, and each step
// takes one. What later stages open is kept up to date beside it, so that a stage
// begins without a look at the whole structure. The set is that of BoxSites where the box
// fits it, else one for all worlds; both give the same runs.
#include <cassert>

#include "lattice/box_sites.h"
#include "lattice/cell_marks.h"
#include "lattice/engines.h"

namespace stig::lattice {
namespace {

/// Open sites in any box or none, with the interface of BoxSites.
class CellSites {
 public:
  using Site = Cell;

  explicit CellSites(LatticeWorld& world)
      : world_(&world), staged_(world.rules().stage_count() > 1) {
    for (const Cell site : world.candidates()) mark(site, world.view(site));
  }

  std::size_t size() const { return open_.size(); }
  Cell operator[](std::size_t i) const { return open_[i]; }
  static Cell cell(Cell site) { return site; }
  Match choose(Cell site, Random& random) { return world_->choose(site, random); }
  void deposit(Cell site, Cell, Colour colour) {
    open_.set(site, 0);
    if (staged_) all_.set(site, 0);
    world_->deposit(site, colour, [&](Cell near, const View& view) { mark(near, view); });
  }
  void begin_stage() {
    open_.clear();
    for (const Cell site : all_.cells_with(present())) open_.set(site, present());
  }

 private:
  std::uint64_t present() const { return 1 | std::uint64_t{1} << world_->stage(); }

  // A deposit changes the views of at most 26 sites, which world_.deposit reports; all
  // other marks stay right. The cost of an event is therefore independent of the
  // structure's size.
  void mark(Cell site, const View& view) {
    const std::uint64_t stages = world_->rules().open_stages(view, site.z, world_->stage());
    // With one stage alone, a second record would only repeat the first.
    if (staged_ && !all_.set(site, stages)) return;  // nothing before, nothing now
    open_.set(site, stages & present());
  }

  LatticeWorld* world_;
  CellMarks open_;  ///< sites of the present stage
  CellMarks all_;   ///< sites of this and later stages, with the stages as marks
  bool staged_;     ///< are there later stages at all?
};

template <class Sites>
class EventRun {
 public:
  EventRun(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks)
      : world_(std::move(world)),
        config_(&config),
        log_(config, hooks, world_.rules().rule_count()),
        open_(world_) {}

  SwarmResult run() {
    settle();
    const Terminated end = steps();
    const std::uint64_t left = open_.size();
    return log_.finish(world_, end, left, 0);
  }

 private:
  /// Goes on to the next stage that has something open, if the present one has not. A stage
  /// that has nothing open when it begins ends at once, so several may be passed over.
  void settle() {
    while ((open_.size() == 0 || world_.stage_spent()) && world_.next_stage()) open_.begin_stage();
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
    const typename Sites::Site site = open_[random.below(open_.size())];
    const Match match = open_.choose(site, random);
    const double probability = world_.rules().probability(match.rule);
    // A rule that does not fire leaves the site open; the step counts all the same.
    if (probability < 1 && random.unit() >= probability) return;
    const Colour colour = world_.rules().place(match.rule);
    const Cell cell = open_.cell(site);
    open_.deposit(site, cell, colour);
    log_.record({cell, colour, match, -1, step});
    settle();
  }

  LatticeWorld world_;
  const SwarmConfig* config_;
  RunLog log_;
  Sites open_;
};

}  // namespace

SwarmResult run_event(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks) {
  if (!BoxSites::fit(config.box)) return run_event_anywhere(std::move(world), config, hooks);
  return EventRun<BoxSites>(std::move(world), config, hooks).run();
}

SwarmResult run_event_anywhere(LatticeWorld world, const SwarmConfig& config,
                               const SwarmHooks& hooks) {
  return EventRun<CellSites>(std::move(world), config, hooks).run();
}

}  // namespace stig::lattice
