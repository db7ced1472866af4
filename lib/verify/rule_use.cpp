// SPDX-License-Identifier: MIT
// Reads off a certificate which rules can fire and which bricks close sites for others. The
// invariant over-approximates what is reachable, so "never fires" is proved, while a
// blocking pair is an example that the invariant allows. Bricks of groups are treated as
// unordered, which again only allows more.
#include "verify/rule_use.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>

#include "verify/invariant.h"

namespace stig::verify {
namespace {

/// Only so many states of a site are looked at: blocking pairs are hints for the author of the
/// rules.
constexpr std::uint64_t kMostStates = 4096;    ///< of one site
constexpr std::uint64_t kMostSites = 200'000;  ///< of a stage, for blocking pairs

/// What the certificate says, as the invariant it was written from; group bricks are
/// ordered by nothing, which allows more states than there are.
Invariant invariant_of(const CertifiedStage& stage) {
  Invariant invariant;
  for (const CertifiedBrick& brick : stage.order) invariant.before.push_back(brick.before);
  invariant.group_of.assign(stage.order.size(), Invariant::kNoWindow);
  return invariant;
}

class Uses {
 public:
  explicit Uses(const RuleSet& rules) : may_(rules.rules.size()) {}

  void look_at(const StageModel& model, const Invariant& invariant) {
    StageSite site;
    const bool few = model.sites() <= kMostSites;
    for (std::uint32_t number = 0; number < model.sites(); ++number) {
      model.look(number, site);
      if (site.rules.empty()) continue;
      const LocalOrder order = local_order(model, invariant, site);
      // Each rule's least state decides, as in local_proof.cpp.
      for (const LocalRule& rule : site.rules) {
        const Mask least = order.closed(rule.need);
        // Counts are not looked at: the rule is granted more than it can do.
        if ((least & (rule.forbid | order.after)) == 0) may_[rule.source.rule] = true;
      }
      if (few && number < model.bricks()) look_for_blocking(model, site, order);
    }
  }

  RuleUse result() const {
    RuleUse use;
    for (std::uint32_t r = 0; r < may_.size(); ++r) {
      if (!may_[r]) use.dead.push_back(r);
    }
    for (const auto& [pair, example] : blocking_) use.blocking.push_back(example);
    return use;
  }

 private:
  static const LocalRule* acting(const StageSite& site, Mask state) {
    const auto found = std::find_if(site.rules.begin(), site.rules.end(),
                                    [&](const LocalRule& r) { return r.matches(state); });
    return found == site.rules.end() ? nullptr : &*found;
  }

  /// A brick closes a site if some rule acts without it and none with it, its predecessors
  /// being there. One example is kept for each pair of rules, the first by site.
  void look_for_blocking(const StageModel& model, const StageSite& site, const LocalOrder& order) {
    Mask seen = 0;
    for (const LocalRule& rule : site.rules) seen |= rule.sees();
    seen &= ~order.after;
    for_each_local_state(model, site, order, seen, kMostStates, [&](Mask state) {
      const LocalRule* open = acting(site, state);
      if (open == nullptr) return true;
      for (Mask left = seen & ~state; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left);
        const Mask below = order.below[static_cast<std::size_t>(i)] & seen;
        if ((below & ~state) != 0 || acting(site, state | bit(i)) != nullptr) continue;
        const std::uint32_t brick = site.brick[static_cast<std::size_t>(i)];
        const std::uint32_t by = model.run()[brick].match.rule;
        blocking_.try_emplace({by, open->source.rule},
                              Blocking{by, open->source.rule, model.at(brick), site.at});
      }
      return true;
    });
  }

  std::vector<bool> may_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Blocking> blocking_;
};

}  // namespace

RuleUse use_of_rules(const RuleSet& rules, const VerifyOptions& options,
                     const VerifyResult& result) {
  assert(result.certificate);
  const RuleTable table(rules);
  Uses uses(rules);
  LatticeWorld world(table, rules.start, options.box);
  // The world is carried along from stage to stage, since a stage's model describes the
  // structure that the stage finds.
  std::size_t done = 0;
  for (std::size_t s = 0; s < result.certificate->stages.size(); ++s) {
    const auto first = result.run.begin() + static_cast<std::ptrdiff_t>(done);
    const auto last = result.run.begin() + static_cast<std::ptrdiff_t>(result.stage_ends[s]);
    const std::vector<Deposit> run(first, last);
    const StageModel model(rules, table, world, run);
    uses.look_at(model, invariant_of(result.certificate->stages[s]));
    for (const Deposit& deposit : run) {
      world.deposit(deposit.site, deposit.colour, [](Cell, const View&) {});
    }
    done = result.stage_ends[s];
    world.next_stage();
  }
  return uses.result();
}

}  // namespace stig::verify
