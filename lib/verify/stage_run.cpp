// SPDX-License-Identifier: MIT
// Runs one stage under a schedule and records its deposits. In contrast to the engines of
// lib/lattice it ignores weights and probabilities: for a proof, whatever may happen has to
// be considered, and schedules that are unlikely at random (newest first, oldest first, a
// given plan) find orders that random runs miss.
#include "verify/stage_run.h"

#include <cassert>
#include <deque>
#include <set>

#include "lattice/cell_marks.h"

namespace stig::verify {
namespace {

/// A constant, so verdicts do not depend on the user's seeds. Streams are told apart by
/// `run`.
constexpr std::uint64_t kSeed = 0x7665726966790001;  ///< of all runs made for proofs

/// The open sites, in the order a schedule wants them. Sites that closed again stay in
/// `waiting_` and are skipped when their turn comes: deleting from the middle of a deque
/// would cost linear time.
class OpenSites {
 public:
  explicit OpenSites(const StageRunConfig& config)
      : schedule_(config.schedule), plan_(config.plan) {}

  void set(Cell site, bool open) {
    if (schedule_ == RunOrder::planned) return set_planned(site, open);
    if (open && schedule_ != RunOrder::random && !marks_.contains(site)) waiting_.push_back(site);
    marks_.set(site, open ? 1 : 0);
  }
  bool empty() const { return marks_.size() == 0 && planned_.empty(); }
  Cell next(Random& random) {
    if (schedule_ == RunOrder::planned) return planned_.begin()->second;
    if (schedule_ == RunOrder::random) return marks_[random.below(marks_.size())];
    while (true) {
      const Cell site = schedule_ == RunOrder::newest ? waiting_.back() : waiting_.front();
      schedule_ == RunOrder::newest ? waiting_.pop_back() : waiting_.pop_front();
      if (marks_.contains(site)) return site;
    }
  }

 private:
  void set_planned(Cell site, bool open) {
    const std::pair<std::uint32_t, Cell> entry{plan_->rank(site), site};
    if (open) {
      planned_.insert(entry);
    } else {
      planned_.erase(entry);
    }
  }

  RunOrder schedule_;
  const Plan* plan_;
  CellMarks marks_;
  std::set<std::pair<std::uint32_t, Cell>> planned_;
  std::deque<Cell> waiting_;  ///< sites once open, some no more
};

/// The rule that places what the plan says, if there is one that acts; else any of those
/// that do, whatever their weights: what is unlikely happens too. With `conflicts: first`
/// there is no choice to make.
Match choose(LatticeWorld& world, Cell site, const Plan* plan, Random& random) {
  const RuleTable& rules = world.rules();
  if (rules.conflicts() == Conflicts::first) return world.choose(site, random);
  std::vector<Match> matches;
  rules.matches(world.view(site), site.z, world.stage(), matches);
  for (const Match& match : matches) {
    if (plan && rules.place(match.rule) == plan->colour(site)) return match;
  }
  return matches[random.below(matches.size())];
}

}  // namespace

Plan::Plan(const std::vector<Deposit>& order) {
  for (std::uint32_t i = 0; i < order.size(); ++i) steps_[order[i].site] = {i, order[i].colour};
}

StageRun run_stage(LatticeWorld& world, const StageRunConfig& config, const Budget& budget) {
  assert(config.schedule != RunOrder::planned || config.plan != nullptr);
  StageRun run;
  OpenSites open(config);
  // Opening a world costs about a quarter of depositing its bricks.
  budget.spend(world.structure().size() * kStepsOfDeposit / 4);
  const auto allowed = [&](Cell site) { return !config.may_fill || config.may_fill(site); };
  for (const Cell site : world.enabled_sites()) {
    if (allowed(site)) open.set(site, true);
  }
  for (std::uint64_t step = 1;; ++step) {
    if (open.empty() || world.stage_spent()) {
      run.ended = true;
      return run;
    }
    if (run.deposits.size() >= config.most || budget.spent_at(step)) return run;
    budget.spend(kStepsOfDeposit);
    // A fresh stream of random numbers for each step, keyed by run and step: what a step
    // draws does not depend on how many numbers earlier steps drew.
    Random random(kSeed, config.run, Purpose::event, 0, step);
    const Cell site = open.next(random);
    const Match match = choose(world, site, config.plan, random);
    const Colour colour = world.rules().place(match.rule);
    open.set(site, false);
    world.deposit(site, colour, [&](Cell neighbour, const View& view) {
      if (!allowed(neighbour)) return;
      open.set(neighbour, world.rules().enabled(view, neighbour.z, world.stage()));
    });
    run.deposits.push_back({site, colour, match, -1, run.deposits.size() + 1});
  }
}

/// Bricks alone do not say in which stage a world is; the stages are counted off.
LatticeWorld world_at_stage(const RuleTable& rules, const std::vector<PlacedBrick>& bricks,
                            const std::optional<Box>& box, int stage) {
  assert(stage >= 1 && stage <= rules.stage_count());
  LatticeWorld world(rules, bricks, box);
  while (world.stage() < stage && world.next_stage()) {
  }
  return world;
}

}  // namespace stig::verify
