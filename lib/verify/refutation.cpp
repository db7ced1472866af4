// SPDX-License-Identifier: MIT
// Explains a refutation by one deposit. Let E(k) be the structure that results from
// following the second order for k deposits and then the first as far as the rules allow.
// E(0) is the first end and E(all) is not, so bisection finds some k with E(k) equal to the
// first end and E(k + 1) different from it: deposit k + 1 is decisive. The predicate need
// not be monotone; bisection finds one such step in O(log n) runs, not all.
#include "verify/refutation.h"

#include <algorithm>
#include <cassert>

namespace stig::verify {
namespace {

/// The second order may grow without end. It is cut some way past the length of the first;
/// by then it has a brick that the first end has not, or the comparison stays open.
constexpr std::uint64_t kBeyond = 10'000;  ///< deposits past the first order's length

/// One way to go on from a prefix of the other order.
struct Ending {
  std::vector<Deposit> deposits;  ///< after the prefix
  Structure structure;
  bool ended = false;
  std::size_t in_stage = 0;  ///< of the deposits
};

/// Runs a world on through all of its stages. `in_stage`: deposits of the stage it was in.
/// Later stages are run as well: two orders may differ after a stage and be made alike by
/// the next, which refutes nothing.
StageRun run_to_the_end(LatticeWorld& world, const Plan& plan, std::uint64_t most,
                        const Budget& budget, std::size_t& in_stage) {
  StageRun all;
  const int begun_in = world.stage();
  do {
    StageRunConfig config;
    config.schedule = RunOrder::planned;
    config.plan = &plan;
    config.most = most - std::min<std::uint64_t>(most, all.deposits.size());
    StageRun stage = run_stage(world, config, budget);
    all.deposits.insert(all.deposits.end(), stage.deposits.begin(), stage.deposits.end());
    all.ended = stage.ended;
    if (world.stage() == begun_in) in_stage = all.deposits.size();
  } while (all.ended && world.next_stage());
  return all;
}

enum class Comparison : std::uint8_t { same, differs, open };

class Explainer {
 public:
  Explainer(const RuleSet& rules, const RuleTable& table, const LatticeWorld& begin,
            const std::vector<Deposit>& first, const std::vector<Deposit>& other,
            const Budget& budget)
      : rules_(rules), table_(table), begin_(begin), other_(other), plan_(first), budget_(budget) {}

  std::optional<DivergingOrders> explain(const std::vector<Deposit>& earlier) {
    // Half of the range of integers stands for no limit, and adding to it cannot overflow.
    Ending first = go_on(0, ~std::uint64_t{0} >> 1);
    if (!first.ended) return std::nullopt;
    most_ = first.deposits.size() + kBeyond;
    end_ = first.structure;
    Ending second = go_on(other_.size(), most_);
    if (compare(second) != Comparison::differs) return std::nullopt;
    // The first order's end is reached after `low` deposits of the other, not after `high`.
    std::size_t low = 0, high = other_.size();
    if (high == 0) return std::nullopt;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      Ending ending = go_on(middle, most_);
      const Comparison comparison = compare(ending);
      if (comparison == Comparison::open) return std::nullopt;
      if (comparison == Comparison::same) {
        low = middle;
        first = std::move(ending);
      } else {
        high = middle;
        second = std::move(ending);
      }
    }
    return write(earlier, low, first, second);
  }

 private:
  LatticeWorld after(std::size_t prefix) const {
    assert(prefix <= other_.size());
    LatticeWorld world = begin_;
    budget_.spend(prefix * kStepsOfDeposit);
    for (std::size_t i = 0; i < prefix; ++i) {
      world.deposit(other_[i].site, other_[i].colour, [](Cell, const View&) {});
    }
    return world;
  }
  Ending go_on(std::size_t prefix, std::uint64_t most) const {
    LatticeWorld world = after(prefix);
    Ending ending;
    StageRun run = run_to_the_end(world, plan_, most, budget_, ending.in_stage);
    ending.deposits = std::move(run.deposits);
    ending.structure = world.take_structure();
    ending.ended = run.ended;
    return ending;
  }
  /// An ending that was cut short differs if it has a brick that the first end has not.
  /// Bricks stay for ever, so one that the first end lacks, or has in another colour,
  /// settles it even before the second order has ended.
  Comparison compare(const Ending& ending) const {
    if (ending.ended) return ending.structure == end_ ? Comparison::same : Comparison::differs;
    bool strange = false;
    ending.structure.for_each(
        [&](Cell cell, Colour colour) { strange = strange || end_.at(cell) != colour; });
    return strange ? Comparison::differs : Comparison::open;
  }

  std::optional<DivergingOrders> write(const std::vector<Deposit>& earlier, std::size_t common,
                                       Ending& first, Ending& second) const {
    DivergingOrders out;
    out.first = earlier;
    out.first.insert(out.first.end(), other_.begin(),
                     other_.begin() + static_cast<std::ptrdiff_t>(common));
    out.common = out.first.size();
    out.second = out.first;
    out.first_stage_end = out.common + first.in_stage;
    out.second_stage_end = out.common + 1 + second.in_stage;
    out.first.insert(out.first.end(), first.deposits.begin(), first.deposits.end());
    out.second.push_back(other_[common]);
    out.second.insert(out.second.end(), second.deposits.begin(), second.deposits.end());
    for (std::vector<Deposit>* order : {&out.first, &out.second}) {
      for (std::size_t i = 0; i < order->size(); ++i) (*order)[i].step = i + 1;
    }
    out.second_ended = second.ended;
    out.first_end = std::move(first.structure);
    out.second_end = std::move(second.structure);
    find_rival(first.deposits, common, out);
    return out;
  }

  bool allows(const LatticeWorld& world, const Deposit& deposit) const {
    if (!world.is_site(deposit.site)) return false;
    std::vector<Match> matches;
    table_.matches(world.view(deposit.site), deposit.site.z, world.stage(), matches);
    if (rules_.conflicts == Conflicts::first && matches.size() > 1) matches.resize(1);
    return std::any_of(matches.begin(), matches.end(), [&](const Match& match) {
      return table_.place(match.rule) == deposit.colour;
    });
  }

  /// The first deposit of the first order that cannot stand beside the decisive one. Two
  /// worlds are kept one decisive deposit apart and the first order is replayed in both.
  /// The first deposit that only one of them allows, or that makes the decisive one
  /// impossible, is the rival.
  void find_rival(const std::vector<Deposit>& first, std::size_t common,
                  DivergingOrders& out) const {
    const Deposit& decisive = other_[common];
    LatticeWorld without = after(common), with = after(common + 1);
    const int stage = without.stage();
    const auto nothing = [](Cell, const View&) {};
    for (const Deposit& deposit : first) {
      const bool ruled_out = !allows(with, deposit);
      out.view = without.view(decisive.site);
      out.rival_view = without.view(deposit.site);
      out.rival = deposit;
      if (ruled_out || !allows(without, deposit)) return;
      without.deposit(deposit.site, deposit.colour, nothing);
      if (!allows(without, decisive) || without.stage() != stage) return;
      with.deposit(deposit.site, deposit.colour, nothing);
    }
  }

  const RuleSet& rules_;
  const RuleTable& table_;
  const LatticeWorld& begin_;
  const std::vector<Deposit>& other_;
  Plan plan_;
  const Budget& budget_;
  std::uint64_t most_ = 0;
  Structure end_;
};

/// Two whole orders, as they are: they part where they first differ. For orders of several
/// stages: no bisection, since the stages after the parting depend on both. Random orders
/// part early, so the common part is short.
DivergingOrders part(const LatticeWorld& start, Ending& first, Ending& second) {
  DivergingOrders out;
  LatticeWorld world = start;
  // Both orders end in different structures, so they differ before either has run out; the
  // assertion states it.
  while (first.deposits[out.common].site == second.deposits[out.common].site &&
         first.deposits[out.common].colour == second.deposits[out.common].colour) {
    const Deposit& deposit = first.deposits[out.common++];
    world.deposit(deposit.site, deposit.colour, [](Cell, const View&) {});
    assert(out.common < std::min(first.deposits.size(), second.deposits.size()));
    while ((world.stage_spent() || world.enabled_sites().empty()) && world.next_stage()) {
    }
  }
  out.rival = first.deposits[out.common];
  out.view = world.view(second.deposits[out.common].site);
  out.rival_view = world.view(out.rival.site);
  out.first = std::move(first.deposits);
  out.second = std::move(second.deposits);
  for (std::vector<Deposit>* order : {&out.first, &out.second}) {
    for (std::size_t i = 0; i < order->size(); ++i) (*order)[i].step = i + 1;
  }
  out.first_stage_end = out.first.size();
  out.second_stage_end = out.second.size();
  out.second_ended = true;
  out.first_end = std::move(first.structure);
  out.second_end = std::move(second.structure);
  return out;
}

}  // namespace

std::optional<DivergingOrders> explain_refutation(const RuleSet& rules, const RuleTable& table,
                                                  const LatticeWorld& stage_begin,
                                                  const std::vector<Deposit>& earlier,
                                                  const std::vector<Deposit>& first,
                                                  const std::vector<Deposit>& other,
                                                  const Budget& budget) {
  return Explainer(rules, table, stage_begin, first, other, budget).explain(earlier);
}

std::optional<DivergingOrders> find_whole_orders(const LatticeWorld& start, const Budget& budget) {
  constexpr std::uint32_t kRuns = 48;
  std::optional<Ending> first;
  for (std::uint32_t i = 0; i < kRuns && !budget.spent(); ++i) {
    LatticeWorld world = start;
    StageRunConfig config;
    config.run = 0x30000 + i;
    config.most = kBeyond;
    Ending ending;
    do {
      StageRun stage = run_stage(world, config, budget);
      ending.deposits.insert(ending.deposits.end(), stage.deposits.begin(), stage.deposits.end());
      ending.ended = stage.ended;
    } while (ending.ended && world.next_stage());
    if (!ending.ended) continue;
    ending.structure = world.take_structure();
    if (!first) {
      first = std::move(ending);
    } else if (!(first->structure == ending.structure)) {
      return part(start, *first, ending);
    }
  }
  return std::nullopt;
}

}  // namespace stig::verify
