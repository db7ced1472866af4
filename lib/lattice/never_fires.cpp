// SPDX-License-Identifier: MIT
// An abstract interpretation of growth: each cell has the set of states that it may ever
// have, and rules add to these sets until nothing changes. Any reachable structure is
// contained cell by cell, by induction over events; so a rule that matches nowhere in the
// closure never fires. The closure forgets which states occur together, which is why it is
// cheap, and why rules that it lets fire may still be dead.
#include "lattice/never_fires.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <deque>

#include "base/text.h"
#include "lattice/cell_map.h"
#include "lattice/firing_graph.h"
#include "rules/conflicts.h"
#include "rules/rule_table.h"
#include "rules/site_condition.h"

namespace stig::lattice {
namespace {

/// What each neighbour of a site may show.
using MayShow = std::array<StateSet, kMaxNeighbours>;

/// Cells with all that may be in them, stage after stage.
class Closure {
 public:
  // The limit counts looks at oriented rules, not time, so the answer is the same on every
  // machine.
  Closure(const RuleSet& rules, const std::optional<Box>& box, std::uint64_t most_looks)
      : rules_(rules),
        box_(box),
        table_(rules),
        n_(neighbourhood(rules.lattice)),
        looks_left_(most_looks),
        fires_(rules.rules.size(), false) {
    for (const PlacedBrick& brick : rules.start) {
      may_be_[brick.at] = StateSet::of(brick.brick).bits();
      bricks_.push_back(brick.at);
    }
  }

  /// False when there was more to look at than is allowed.
  bool close() {
    for (int stage = 1; stage <= rules_.stage_count() && !all_fire(); ++stage) {
      // Every stage begins from all bricks there may be: a site that was closed before may
      // be open to the new stage's rules.
      const std::vector<Cell> stand = bricks_;
      for (const Cell cell : stand) wake_around(cell);
      while (!waiting_.empty() && !all_fire()) {
        const Cell site = waiting_.front();
        waiting_.pop_front();
        waits_[site] = 0;
        if (!look(site, stage)) return false;
      }
    }
    return true;
  }

  std::vector<std::uint32_t> never() const {
    std::vector<std::uint32_t> rules;
    for (std::uint32_t r = 0; r < fires_.size(); ++r) {
      if (!fires_[r]) rules.push_back(r);
    }
    return rules;
  }

 private:
  bool all_fire() const { return count_ == fires_.size(); }
  Cell wrap(Cell cell) const { return box_ ? box_->wrap(cell) : cell; }
  bool placeable(Cell cell) const {
    return (!rules_.floor || cell.z >= 0) && (!box_ || box_->contains(cell));
  }

  void wake_around(Cell cell) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_.size); ++i) {
      const Cell site = wrap(cell + n_.offsets[i]);
      if (!placeable(site) || waits_.at(site) != 0 || is_start(site)) continue;
      waits_[site] = 1;
      waiting_.push_back(site);
    }
  }
  /// Cells of the start are the only ones that cannot be empty.
  bool is_start(Cell cell) const {
    const std::uint64_t bits = may_be_.at(cell);
    return bits != 0 && !StateSet(bits).contains(kEmpty);
  }
  StateSet may_show(Cell cell) const {
    if (rules_.floor && cell.z < 0) return StateSet::floor();
    const std::uint64_t bits = may_be_.at(wrap(cell));
    return bits != 0 ? StateSet(bits) : StateSet::empty_cell();
  }

  bool look(Cell site, int stage) {
    assert(placeable(site));
    if (looks_left_-- <= 1) return false;
    MayShow shows;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_.size); ++i) {
      shows[i] = may_show(site + n_.offsets[i]);
    }
    const StateSet before = may_show(site);
    StateSet here = before;
    for (const Entry& entry : table_.entries()) {
      const Rule& rule = rules_.rules[entry.source.rule];
      // A rule that is known to fire is looked at again only where its colour could be new.
      if (fires_[entry.source.rule] && here.contains(rule.place)) continue;
      if (!allows(site_condition(rule), {site.z, stage})) continue;
      if (looks_left_-- <= 1) return false;
      if (!may_match(rule, entry.pattern, shows)) continue;
      count_ += fires_[entry.source.rule] ? 0 : 1;
      fires_[entry.source.rule] = true;
      here = here | StateSet::of(rule.place);
    }
    if (here == before) return true;
    if (before == StateSet::empty_cell()) bricks_.push_back(site);
    may_be_[site] = here.bits();
    // Neighbours have to be looked at again only when the set of this cell has grown; sets
    // have at most 62 colours, so the closure ends wherever the space is bounded.
    wake_around(site);
    return true;
  }

  bool may_match(const Rule& rule, const Pattern& pattern, const MayShow& shows) const {
    MayShow both;
    bool beside = false;  // rules act beside bricks alone
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_.size); ++i) {
      both[i] = pattern.allowed[i] & shows[i];
      if (both[i].none()) return false;
      beside = beside || !(both[i] & StateSet::bricks(rules_.colours())).none();
    }
    return beside && std::all_of(rule.counts.begin(), rule.counts.end(),
                                 [&](const CountCondition& count) { return can_be(count, both); });
  }
  // The bounds of the number over all choices of one state for each neighbour.
  bool can_be(const CountCondition& count, const MayShow& shows) const {
    int least = 0, most = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_.size); ++i) {
      if (count.faces_only && !n_.is_face[i]) continue;
      least += shows[i].subset_of(count.of) ? 1 : 0;
      most += (shows[i] & count.of).none() ? 0 : 1;
    }
    return least <= count.max && most >= count.min;
  }

  const RuleSet& rules_;
  const std::optional<Box>& box_;
  RuleTable table_;
  const Neighbourhood& n_;
  std::uint64_t looks_left_;
  std::vector<bool> fires_;
  std::size_t count_ = 0;  ///< rules that fire
  /// States, as bits; 0: nothing but empty.
  CellMap<std::uint64_t> may_be_;
  std::vector<Cell> bricks_;  ///< cells that may have one
  CellMap<std::uint8_t> waits_;
  std::deque<Cell> waiting_;
};

/// By their colours alone. The fallback when the closure was too much: the firing graph
/// knows no geometry and is always finite.
std::vector<std::uint32_t> without_level(const RuleSet& rules) {
  std::vector<std::uint32_t> never;
  if (!firing_graph_problem(rules).empty()) return never;
  const FiringGraph graph = firing_graph(rules);
  for (std::uint32_t r = 0; r < graph.nodes.size(); ++r) {
    if (!graph.nodes[r].level) never.push_back(r);
  }
  return never;
}

}  // namespace

std::vector<std::uint32_t> rules_that_never_fire(const RuleSet& rules,
                                                 const std::optional<Box>& box,
                                                 std::uint64_t most_looks) {
  Closure closure(rules, box, most_looks);
  return closure.close() ? closure.never() : without_level(rules);
}

void check_rules_fire(const RuleSet& rules, Diagnostics& diagnostics) {
  std::optional<Box> box;
  if (rules.box) box = lay_box(*rules.box, rules.start, rules.floor);
  for (const std::uint32_t r : rules_that_never_fire(rules, box)) {
    const Rule& rule = rules.rules[r];
    diagnostics.add(
        Code::R318, rule_place(rule),
        fmt::format("rule {} never fires: what it asks for is never built", in_quotes(rule.name)));
  }
}

}  // namespace stig::lattice
