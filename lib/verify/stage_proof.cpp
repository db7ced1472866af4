// SPDX-License-Identifier: MIT
#include "verify/stage_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>
#include <set>
#include <utility>

#include "verify/far_order.h"
#include "verify/local_proof.h"
#include "verify/window.h"

namespace stig {
namespace {

constexpr std::size_t kDepositsOfRuns = 200'000;  ///< in all runs after the first
constexpr std::size_t kMostRuns = 32;
constexpr std::size_t kMostAttempts = 24;  ///< at orders that a failed proof suggests
constexpr int kMostWitnesses = 6;
constexpr int kMostFarRounds = 3;         ///< of looking for far chains
constexpr int kMostRounds = 12;           ///< of growing groups before they are all of the stage
constexpr std::size_t kMostGroup = 4096;  ///< bricks

std::string in_words(Cell cell) { return fmt::format("({}, {}, {})", cell.x, cell.y, cell.z); }

class StageProver {
 public:
  StageProver(const RuleSet& rules, const RuleTable& table, const World& before,
              std::vector<Deposit> run, const Budget& budget)
      : before_(before),
        budget_(budget),
        run_(std::move(run)),
        model_(rules, table, before, run_) {}

  /// The bricks that the run finds open and other orders may find closed.
  const std::set<Cell>& stuck() const { return stuck_; }

  /// `hasty`: give up as soon as the order of neighbours alone does not settle the stage.
  StageProof prove(bool hasty) {
    first_ = placed_before(model_, run_);
    if (other_runs_differ()) return std::move(proof_);
    Groups groups;
    if (attempt(groups)) return std::move(proof_);
    for (const LocalFailure& failure : failures_) {
      if (failure.kind == LocalFailure::Kind::stuck) stuck_.insert(model_.at(failure.site));
    }
    if (hasty && !stuck_.empty() && proof_.kind == StageProof::Kind::unknown) {
      return std::move(proof_);
    }
    if (!refuted() && !gave_up_ && !budget_.spent()) grow(groups, 0);
    for (int round = 1; !gave_up_ && !refuted() && !budget_.spent(); ++round) {
      if (attempt(groups)) return std::move(proof_);
      if (refuted() || gave_up_) return std::move(proof_);
      if (groups.size() == 1 && groups.front().size() == model_.bricks()) break;
      grow(groups, round);
    }
    if (proof_.open.empty()) {
      proof_.open = fmt::format("the time allowed ended with {} of {} bricks looked at one by one",
                                group_bricks(groups), model_.bricks());
    }
    return std::move(proof_);
  }

 private:
  bool refuted() const { return proof_.kind == StageProof::Kind::refuted; }

  using Groups = std::vector<std::vector<std::uint32_t>>;  ///< bricks by rising number

  static std::size_t group_bricks(const Groups& groups) {
    std::size_t number = 0;
    for (const auto& group : groups) number += group.size();
    return number;
  }

  // Runs.

  /// Is what a run did at odds with the model's? Then it becomes the proof.
  bool differs(StageRun&& run) {
    bool strange = false;
    for (const Deposit& deposit : run.deposits) {
      const std::uint32_t number = model_.number(deposit.site);
      strange =
          strange || number >= model_.bricks() || model_.run()[number].colour != deposit.colour;
    }
    if (!strange && !(run.ended && run.deposits.size() < model_.bricks())) return false;
    proof_.kind = StageProof::Kind::refuted;
    proof_.other = std::move(run);
    return true;
  }

  bool other_runs_differ() {
    agreed_ = first_;
    const std::size_t runs =
        std::clamp<std::size_t>(kDepositsOfRuns / (model_.bricks() + 1), 1, kMostRuns);
    for (std::size_t i = 0; i < runs && !budget_.spent(); ++i) {
      StageRunConfig config;
      config.schedule = i == 0 ? RunOrder::newest : i == 1 ? RunOrder::oldest : RunOrder::random;
      config.run = static_cast<std::uint32_t>(i + 1);
      config.most = model_.bricks() + 1000;
      World world = before_;
      StageRun run = run_stage(world, config, budget_);
      const bool whole = run.ended;
      std::vector<Deposit> deposits = run.deposits;
      if (differs(std::move(run))) return true;
      if (!whole) break;
      const std::vector<Mask> placed = placed_before(model_, deposits);
      for (std::size_t b = 0; b < agreed_.size(); ++b) agreed_[b] &= placed[b];
    }
    return false;
  }

  /// Runs on from a world in which `done` has happened, and compares.
  bool completion_differs(World world, std::vector<Deposit> done, std::uint32_t stream) {
    StageRunConfig config;
    config.run = stream;
    config.schedule = RunOrder::random;
    config.most = model_.bricks() + 1000;
    StageRun rest = run_stage(world, config, budget_);
    for (const Deposit& deposit : rest.deposits) done.push_back(deposit);
    rest.deposits = std::move(done);
    return differs(std::move(rest));
  }

  /// Deposits a brick if a rule that acts allows it.
  bool deposit(World& world, Cell site, std::uint64_t colours, std::vector<Deposit>& done) {
    if (!world.is_site(site) || world.stage_spent()) return false;
    std::vector<Match> matches;
    world.rules().matches(world.view(site), site.z, world.stage(), matches);
    if (model_.first_acts() && matches.size() > 1) matches.resize(1);
    for (const Match& match : matches) {
      const Colour colour = world.rules().place(match.rule);
      if ((colours >> colour & 1U) == 0) continue;
      world.deposit(site, colour, [](Cell, const View&) {});
      done.push_back({site, colour, match, -1, done.size() + 1});
      return true;
    }
    return false;
  }

  /// Deposits these bricks in this order, then one at `site` that the first run has not
  /// (if there is a rule for it), and runs on.
  bool path_differs(const std::vector<std::uint32_t>& path, std::uint32_t site) {
    World world = before_;
    std::vector<Deposit> done;
    for (const std::uint32_t brick : path) {
      if (!deposit(world, model_.at(brick), std::uint64_t{1} << model_.run()[brick].colour, done))
        break;
    }
    if (site != StageModel::kNone) {
      std::uint64_t others = ~std::uint64_t{0};
      if (site < model_.bricks()) others &= ~(std::uint64_t{1} << model_.run()[site].colour);
      deposit(world, model_.at(site), others, done);
    }
    return completion_differs(std::move(world), std::move(done), 0x10000);
  }

  /// Tries to bring a failed local state about: only bricks that are before it are placed.
  bool provokes(const LocalFailure& failure, std::uint32_t stream) {
    Site site;
    model_.look(failure.site, site);
    std::set<std::uint32_t> wanted;
    std::vector<std::uint32_t> todo;
    const auto want = [&](std::uint32_t brick) {
      if (brick < model_.bricks() && wanted.insert(brick).second) todo.push_back(brick);
    };
    for (Mask left = failure.state; left != 0; left &= left - 1) {
      want(site.brick[static_cast<std::size_t>(std::countr_zero(left))]);
    }
    const Neighbourhood& n = model_.table().neighbours();
    while (!todo.empty() && wanted.size() < 100'000) {
      const std::uint32_t brick = todo.back();
      todo.pop_back();
      for (Mask left = invariant_.before[brick]; left != 0; left &= left - 1) {
        const Offset step = n.offsets[static_cast<std::size_t>(std::countr_zero(left))];
        want(model_.number(model_.at(brick) + step));
      }
    }
    wanted.erase(failure.site);
    World world = before_;
    StageRunConfig config;
    config.run = stream;
    config.schedule = RunOrder::random;
    config.may_fill = [&](Cell cell) { return wanted.contains(model_.number(cell)); };
    std::vector<Deposit> done = run_stage(world, config, budget_).deposits;
    std::uint64_t others = ~std::uint64_t{0};
    if (site.colour != 0) others &= ~(std::uint64_t{1} << site.colour);
    deposit(world, site.at, others, done);
    return completion_differs(std::move(world), std::move(done), stream);
  }

  // Proofs.

  /// One round: true when the stage is proved or refuted.
  bool attempt(Groups& groups) {
    invariant_ = {};
    invariant_.before = agreed_;
    invariant_.group_of.assign(model_.bricks(), Invariant::kNoWindow);
    const std::int64_t limit = model_.table().stage_limit(before_.stage());
    if (groups.size() == 1 && groups.front().size() == model_.bricks() && limit > 0 &&
        static_cast<std::size_t>(limit) == model_.bricks()) {
      invariant_.over_at = static_cast<std::uint64_t>(limit);
    }
    for (const auto& group : groups) {
      for (const std::uint32_t brick : group) {
        invariant_.before[brick] = 0;
        invariant_.group_of[brick] = static_cast<std::uint32_t>(invariant_.windows.size());
      }
      invariant_.windows.push_back({});
      invariant_.windows.back().group = group;
    }
    failures_.clear();
    int far_rounds = groups.empty() ? kMostFarRounds : 0;
    while (true) {
      const std::vector<Mask> held = invariant_.before;
      for (std::uint32_t w = 0; w < groups.size(); ++w) {
        if (!fill(groups, w)) return false;
      }
      LocalProof local = prove_locally(model_, first_, invariant_, budget_);
      if (!local.finished) return false;
      if (drop_broken_chains(model_, invariant_)) continue;
      if (far_rounds > 0 && add_far_chains(model_, local.failures, invariant_)) {
        --far_rounds;
        invariant_.before = held;
        continue;
      }
      proof_.local_states = local.local_states;
      if (!local.failures.empty()) {
        failures_ = std::move(local.failures);
        return refuted_by_failures();
      }
      if (!context_changed(held)) break;
    }
    write_proof(groups);
    return true;
  }

  bool context_changed(const std::vector<Mask>& held) const {
    for (const Window& window : invariant_.windows) {
      for (const std::uint32_t brick : window.context) {
        if (held[brick] != invariant_.before[brick]) return true;
      }
    }
    return false;
  }

  /// Searches a window, its group growing where the context is at fault. False when that
  /// does not help, or the stage is refuted on the way.
  bool fill(Groups& groups, std::uint32_t number) {
    Window& window = invariant_.windows[number];
    while (true) {
      const auto failure = explore_window(model_, invariant_, budget_, window);
      if (!failure) return true;
      if (failure->kind == WindowFailure::Kind::too_many) {
        gave_up_ = true;
        proof_.open = fmt::format("{} fillings of {} bricks were explored, and there are more",
                                  window.count(), window.group.size());
        return false;
      }
      const bool wrong = failure->kind == WindowFailure::Kind::wrong;
      const std::uint32_t site = wrong ? failure->site : StageModel::kNone;
      if (path_differs(path_to(window, failure->filling), site)) return false;
      assert(!window.context.empty());
      const std::uint32_t brick = most_helpful(number);
      if (brick == StageModel::kNone) {
        for (const std::uint32_t c : window.context) {
          failures_.push_back({LocalFailure::Kind::too_many, c, 0, 0});
        }
        return false;
      }
      take(brick, number);
      groups[number] = window.group;
    }
  }

  void take(std::uint32_t brick, std::uint32_t window) {
    std::vector<std::uint32_t>& group = invariant_.windows[window].group;
    group.insert(std::lower_bound(group.begin(), group.end(), brick), brick);
    invariant_.before[brick] = 0;
    invariant_.group_of[brick] = window;
  }

  /// The brick of a window's context with which in its group the search gets farthest, of
  /// those that do not touch another group.
  std::uint32_t most_helpful(std::uint32_t number) {
    constexpr std::uint64_t kAll = ~std::uint64_t{0};
    Budget little = budget_;
    little.states = std::min<std::uint64_t>(little.states, 20'000);
    std::uint32_t best = StageModel::kNone;
    std::uint64_t farthest = 0;
    const std::vector<std::uint32_t> context = invariant_.windows[number].context;
    for (const std::uint32_t brick : context) {
      if (touches_another_group(brick, number)) continue;
      Invariant kept = std::exchange(invariant_, with_one_window(number));
      take(brick, 0);
      Window& window = invariant_.windows[0];
      const auto failure = explore_window(model_, invariant_, little, window);
      const std::uint64_t got = failure ? 1 + window.bricks_in(failure->filling) : kAll;
      if (got > farthest) {
        farthest = got;
        best = brick;
      }
      invariant_ = std::move(kept);
    }
    return best;
  }

  Invariant with_one_window(std::uint32_t number) const {
    Invariant one;
    one.before = invariant_.before;
    one.group_of = invariant_.group_of;
    for (std::uint32_t& window : one.group_of) {
      if (window == number) window = 0;
    }
    one.windows.resize(1);
    one.windows[0].group = invariant_.windows[number].group;
    return one;
  }

  bool touches_another_group(std::uint32_t brick, std::uint32_t number) const {
    const Neighbourhood& n = model_.table().neighbours();
    for (int i = 0; i < n.size; ++i) {
      const std::uint32_t beside =
          model_.number(model_.at(brick) + n.offsets[static_cast<std::size_t>(i)]);
      if (beside >= model_.bricks()) continue;
      const std::uint32_t window = invariant_.group_of[beside];
      if (window != Invariant::kNoWindow && window != number) return true;
    }
    return false;
  }

  bool refuted_by_failures() {
    std::uint32_t stream = 0x20000;
    std::size_t attempts = 0;
    for (const LocalFailure& failure : failures_) {
      if (failure.kind == LocalFailure::Kind::too_many) continue;
      if (attempts++ >= kMostAttempts || budget_.spent()) break;
      for (const Window& window : invariant_.windows) {
        if (window.context.empty() && shown_by(window, failure)) return false;
      }
      for (int k = 0; k < 2; ++k) {
        if (provokes(failure, stream++)) return false;
      }
    }
    return false;
  }

  /// Does a filling of an exact window lead to the failed state? Then it is real.
  bool shown_by(const Window& window, const LocalFailure& failure) {
    Site site;
    model_.look(failure.site, site);
    std::vector<std::pair<std::size_t, bool>> wanted;
    for (Mask left = site.bricks & failure.seen; left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      const auto at = std::lower_bound(window.group.begin(), window.group.end(),
                                       site.brick[static_cast<std::size_t>(i)]);
      if (at == window.group.end() || *at != site.brick[static_cast<std::size_t>(i)]) return false;
      wanted.emplace_back(static_cast<std::size_t>(at - window.group.begin()),
                          (failure.state & bit(i)) != 0);
    }
    for (std::size_t f = 0; f < window.count(); ++f) {
      const bool same = std::all_of(wanted.begin(), wanted.end(), [&](const auto& pair) {
        return window.has(f, pair.first) == pair.second;
      });
      if (same && path_differs(path_to(window, f), failure.site)) return true;
    }
    return false;
  }

  // Groups.

  /// Takes in what the failures are about; groups that touch become one.
  void grow(Groups& groups, int round) {
    std::set<std::uint32_t> bricks;
    for (const auto& group : groups) bricks.insert(group.begin(), group.end());
    const std::size_t had = bricks.size();
    const auto take = [&](std::uint32_t brick) {
      if (brick < model_.bricks()) bricks.insert(brick);
    };
    Site site;
    for (const LocalFailure& failure : failures_) {
      take(failure.site);
      // A brick alone at first: its window takes in what it needs.
      if (round == 0 && failure.site < model_.bricks()) continue;
      model_.look(failure.site, site);
      const Mask around = failure.seen != 0 ? failure.seen & site.bricks : Mask{0};
      for (Mask left = around; left != 0; left &= left - 1) {
        take(site.brick[static_cast<std::size_t>(std::countr_zero(left))]);
      }
    }
    if (bricks.size() == had || round >= kMostRounds || bricks.size() > kMostGroup) {
      for (std::uint32_t b = 0; b < model_.bricks(); ++b) bricks.insert(b);
    }
    if (bricks.size() > kMostGroup) {
      gave_up_ = true;
      if (failures_.empty()) return;  // the time is over
      proof_.open =
          fmt::format("{} sites are not settled by the order of their neighbours, the first at {}",
                      failures_.size(), in_words(model_.at(failures_.front().site)));
      return;
    }
    groups = touching(bricks);
  }

  Groups touching(const std::set<std::uint32_t>& bricks) const {
    const Neighbourhood& n = model_.table().neighbours();
    Groups groups;
    std::set<std::uint32_t> left = bricks;
    while (!left.empty()) {
      std::vector<std::uint32_t> group{*left.begin()};
      left.erase(left.begin());
      for (std::size_t k = 0; k < group.size(); ++k) {
        for (int i = 0; i < n.size; ++i) {
          const Cell beside = model_.at(group[k]) + n.offsets[static_cast<std::size_t>(i)];
          const auto found = left.find(model_.number(beside));
          if (found == left.end()) continue;
          group.push_back(*found);
          left.erase(found);
        }
      }
      std::sort(group.begin(), group.end());
      groups.push_back(std::move(group));
    }
    return groups;
  }

  void write_proof(const Groups& groups) {
    proof_.kind = StageProof::Kind::proved;
    proof_.method = groups.empty() ? ProofMethod::certificate : ProofMethod::components;
    if (groups.size() == 1 && groups.front().size() == model_.bricks()) {
      proof_.method = ProofMethod::exhaustive;
    }
    CertifiedStage& stage = proof_.certificate;
    proof_.run = run_;
    stage.order.reserve(model_.bricks());
    for (std::uint32_t b = 0; b < model_.bricks(); ++b) {
      stage.order.push_back({model_.at(b), model_.run()[b].colour, invariant_.before[b]});
    }
    for (const auto& [brick, chains] : invariant_.far) {
      stage.far.insert(stage.far.end(), chains.begin(), chains.end());
    }
    for (const Window& window : invariant_.windows) {
      proof_.local_states += window.count();
      CertifiedWindow out;
      out.group = window.group;
      out.context = window.context;
      for (std::size_t f = 0; f < window.count(); ++f) {
        const auto first = window.fillings.begin() + static_cast<std::ptrdiff_t>(f * window.words);
        out.fillings.emplace_back(first, first + static_cast<std::ptrdiff_t>(window.words));
      }
      std::sort(out.fillings.begin(), out.fillings.end(), [](const Filling& a, const Filling& b) {
        return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
      });
      stage.windows.push_back(std::move(out));
    }
  }

  const World& before_;
  const Budget& budget_;
  std::vector<Deposit> run_;
  StageModel model_;
  std::set<Cell> stuck_;
  std::vector<Mask> first_;   ///< placed_before of the model's run
  std::vector<Mask> agreed_;  ///< of all runs
  Invariant invariant_;
  std::vector<LocalFailure> failures_;
  bool gave_up_ = false;
  StageProof proof_;
};

/// Another run, in which some bricks wait until nothing else can be done.
std::vector<Deposit> run_with_delays(const World& before, const std::vector<Deposit>& run,
                                     const std::set<Cell>& late, const Budget& budget) {
  std::vector<Deposit> wish;
  for (const bool now : {false, true}) {
    for (const Deposit& deposit : run) {
      if (late.contains(deposit.site) == now) wish.push_back(deposit);
    }
  }
  const Plan plan(wish);
  StageRunConfig config;
  config.schedule = RunOrder::planned;
  config.plan = &plan;
  config.most = run.size() + 1000;
  World world = before;
  StageRun result = run_stage(world, config, budget);
  return result.ended ? std::move(result.deposits) : std::vector<Deposit>{};
}

}  // namespace

StageProof prove_stage(const RuleSet& rules, const RuleTable& table, const World& before,
                       const StageRun& run, const Budget& budget) {
  // A witness in which bricks come as late as they can leaves less to be shown of them.
  std::set<Cell> late;
  std::vector<Deposit> witness = run.deposits;
  for (int i = 0; i < kMostWitnesses; ++i) {
    StageProver prover(rules, table, before, witness, budget);
    StageProof proof = prover.prove(true);
    if (proof.kind != StageProof::Kind::unknown || prover.stuck().empty()) return proof;
    const std::size_t had = late.size();
    late.insert(prover.stuck().begin(), prover.stuck().end());
    if (late.size() == had) break;
    std::vector<Deposit> next = run_with_delays(before, witness, late, budget);
    if (next.size() != run.deposits.size()) break;
    witness = std::move(next);
  }
  return StageProver(rules, table, before, run.deposits, budget).prove(false);
}

}  // namespace stig
