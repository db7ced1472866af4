// SPDX-License-Identifier: MIT
#include "verify/refutation.h"

#include <algorithm>

namespace stig {
namespace {

constexpr std::uint64_t kBeyond = 10'000;  ///< deposits past the first order's length

/// One way to go on from a prefix of the other order.
struct Ending {
  std::vector<Deposit> deposits;  ///< after the prefix
  Structure structure;
  bool ended = false;
  std::size_t in_stage = 0;  ///< of the deposits
};

/// Runs a world on through all of its stages. `in_stage`: deposits of the stage it was in.
StageRun run_to_the_end(World& world, const Plan& plan, std::uint64_t most, const Budget& budget,
                        std::size_t& in_stage) {
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

class Explainer {
 public:
  Explainer(const RuleSet& rules, const RuleTable& table, const World& begin,
            const std::vector<Deposit>& first, const std::vector<Deposit>& other,
            const Budget& budget)
      : rules_(rules), table_(table), begin_(begin), other_(other), plan_(first), budget_(budget) {}

  std::optional<DivergingOrders> explain(const std::vector<Deposit>& earlier) {
    Ending first = go_on(0, ~std::uint64_t{0} >> 1);
    if (!first.ended) return std::nullopt;
    most_ = first.deposits.size() + kBeyond;
    end_ = first.structure;
    Ending second = go_on(other_.size(), most_);
    if (same_end(second)) return std::nullopt;
    // The first order's end is reached after `low` deposits of the other, not after `high`.
    std::size_t low = 0, high = other_.size();
    if (high == 0) return std::nullopt;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      Ending ending = go_on(middle, most_);
      if (same_end(ending)) {
        low = middle;
        first = std::move(ending);
      } else {
        high = middle;
        second = std::move(ending);
      }
    }
    if (high == other_.size()) second = go_on(high, most_);
    return write(earlier, low, first, second);
  }

 private:
  World after(std::size_t prefix) const {
    World world = begin_;
    for (std::size_t i = 0; i < prefix; ++i) {
      world.deposit(other_[i].site, other_[i].colour, [](Cell, const View&) {});
    }
    return world;
  }
  Ending go_on(std::size_t prefix, std::uint64_t most) const {
    World world = after(prefix);
    Ending ending;
    StageRun run = run_to_the_end(world, plan_, most, budget_, ending.in_stage);
    ending.deposits = std::move(run.deposits);
    ending.structure = world.take_structure();
    ending.ended = run.ended;
    return ending;
  }
  bool same_end(const Ending& ending) const { return ending.ended && ending.structure == end_; }

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

  bool allows(const World& world, const Deposit& deposit) const {
    if (!world.is_site(deposit.site)) return false;
    std::vector<Match> matches;
    table_.matches(world.view(deposit.site), deposit.site.z, world.stage(), matches);
    if (rules_.conflicts == Conflicts::first && matches.size() > 1) matches.resize(1);
    return std::any_of(matches.begin(), matches.end(), [&](const Match& match) {
      return table_.place(match.rule) == deposit.colour;
    });
  }

  /// The first deposit of the first order that cannot stand beside the decisive one.
  void find_rival(const std::vector<Deposit>& first, std::size_t common,
                  DivergingOrders& out) const {
    const Deposit& decisive = other_[common];
    World without = after(common), with = after(common + 1);
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
  const World& begin_;
  const std::vector<Deposit>& other_;
  Plan plan_;
  const Budget& budget_;
  std::uint64_t most_ = 0;
  Structure end_;
};

}  // namespace

std::optional<DivergingOrders> explain_refutation(const RuleSet& rules, const RuleTable& table,
                                                  const World& stage_begin,
                                                  const std::vector<Deposit>& earlier,
                                                  const std::vector<Deposit>& first,
                                                  const std::vector<Deposit>& other,
                                                  const Budget& budget) {
  return Explainer(rules, table, stage_begin, first, other, budget).explain(earlier);
}

}  // namespace stig
