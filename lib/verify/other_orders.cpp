// SPDX-License-Identifier: MIT
// A failed local state is a guess: the invariant is an over-approximation, and what it
// leaves possible need not occur. Before groups are enumerated at great cost, each guess is
// tried with the real rules, as an order of events aimed at that state. An order that ends
// differently, or that has a brick the model's run has not, refutes the stage by itself; so
// nothing found here needs further proof.
#include "verify/other_orders.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <set>

namespace stig::verify {
namespace {

constexpr std::size_t kDepositsOfRuns = 200'000;  ///< in all runs after the first
constexpr std::size_t kMostRuns = 32;
constexpr std::size_t kMostOrdersTried = 24;  ///< at orders that a failed proof suggests

}  // namespace

/// Is what a run did at odds with the model's? Then it is what was looked for. An order
/// that was cut short does not differ merely by lacking bricks. It does by a brick
/// elsewhere or of another colour, since bricks are never taken away.
bool OtherOrders::differs(StageRun&& run) {
  bool strange = false;
  for (const Deposit& deposit : run.deposits) {
    const std::uint32_t number = model_.number(deposit.site);
    strange = strange || number >= model_.bricks() || model_.run()[number].colour != deposit.colour;
  }
  if (!strange && !(run.ended && run.deposits.size() < model_.bricks())) return false;
  found_ = std::move(run);
  return true;
}

/// Newest first and oldest first are the extremes, depth-first and breadth-first growth;
/// the rest is random. More runs are made of small structures, in which each is cheap.
bool OtherOrders::runs_differ(std::vector<Mask>& agreed) {
  const std::size_t runs =
      std::clamp<std::size_t>(kDepositsOfRuns / (model_.bricks() + 1), 1, kMostRuns);
  for (std::size_t i = 0; i < runs && !budget_.spent(); ++i) {
    StageRunConfig config;
    config.schedule = i == 0 ? RunOrder::newest : i == 1 ? RunOrder::oldest : RunOrder::random;
    config.run = static_cast<std::uint32_t>(i + 1);
    config.most = model_.bricks() + 1000;
    LatticeWorld world = before_;
    StageRun run = run_stage(world, config, budget_);
    const bool whole = run.ended;
    std::vector<Deposit> deposits = run.deposits;
    if (differs(std::move(run))) return true;
    // A run that was cut short says nothing of the order of bricks it had not placed.
    if (!whole) break;
    const std::vector<Mask> placed = placed_before(model_, deposits);
    for (std::size_t b = 0; b < agreed.size(); ++b) agreed[b] &= placed[b];
  }
  return false;
}

/// Runs on from a world in which `done` has happened, and compares.
bool OtherOrders::completion_differs(LatticeWorld world, std::vector<Deposit> done,
                                     std::uint32_t stream) {
  StageRunConfig config;
  config.run = stream;
  config.schedule = RunOrder::random;
  config.most = model_.bricks() + 1000;
  StageRun rest = run_stage(world, config, budget_);
  for (const Deposit& deposit : rest.deposits) done.push_back(deposit);
  rest.deposits = std::move(done);
  return differs(std::move(rest));
}

/// Deposits a brick if a rule that acts allows it. Used to follow a given order exactly.
/// False means that the rules do not allow that deposit, and the attempt goes on from where
/// it is.
bool OtherOrders::deposit(LatticeWorld& world, Cell site, std::uint64_t colours,
                          std::vector<Deposit>& done) const {
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

bool OtherOrders::path_differs(const std::vector<std::uint32_t>& path, std::uint32_t site) {
  LatticeWorld world = before_;
  std::vector<Deposit> done;
  for (const std::uint32_t brick : path) {
    assert(brick < model_.bricks());
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
/// The structure with exactly the wanted bricks and all that must precede them is the least
/// in which the state can occur. The random schedule then decides among orders of filling
/// it.
bool OtherOrders::provokes(const Invariant& invariant, const LocalFailure& failure,
                           std::uint32_t stream) {
  StageSite site;
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
  // Bounds the effort for large structures; the attempt then starts from fewer bricks, and
  // only completeness suffers.
  while (!todo.empty() && wanted.size() < 100'000) {
    const std::uint32_t brick = todo.back();
    todo.pop_back();
    for (Mask left = invariant.before[brick]; left != 0; left &= left - 1) {
      const Offset step = n.offsets[static_cast<std::size_t>(std::countr_zero(left))];
      want(model_.number(model_.at(brick) + step));
    }
  }
  // The failed site has to be empty in the state; it is filled afterwards, by another
  // colour if possible.
  wanted.erase(failure.site);
  LatticeWorld world = before_;
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

bool OtherOrders::provoked(const Invariant& invariant, const std::vector<LocalFailure>& failures) {
  std::uint32_t stream = 0x20000;
  std::size_t attempts = 0;
  for (const LocalFailure& failure : failures) {
    if (failure.kind == LocalFailure::Kind::too_many) continue;
    if (attempts++ >= kMostOrdersTried || budget_.spent()) break;
    for (const Window& window : invariant.windows) {
      if (window.context.empty() && shown_by(window, failure)) return true;
    }
    // Two random orders for each: states that need luck are left to the groups.
    for (int k = 0; k < 2; ++k) {
      if (provokes(invariant, failure, stream++)) return true;
    }
  }
  return false;
}

/// Does a filling of an exact window lead to the failed state? Then it is real.
bool OtherOrders::shown_by(const Window& window, const LocalFailure& failure) {
  StageSite site;
  model_.look(failure.site, site);
  std::vector<std::pair<std::size_t, bool>> wanted;
  // A filling determines the state only if all bricks around the site that matter are in
  // the window's group.
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

}  // namespace stig::verify
