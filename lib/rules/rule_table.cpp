// SPDX-License-Identifier: MIT
// Compiles a rule set into two indices (see the header). The order of work is chosen for
// the engines' hot path, which asks for one view at a time and mostly gets "no": the hash
// of exact entries costs one look-up, and the bit sets are intersected from the most
// selective neighbour on, so most words are zero after two or three neighbours.
#include "rules/rule_table.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "rules/table_index.h"

namespace stig::rules {
namespace {

/// Distinct orientations of a rule, each with the first group element that gives it.
/// Orientations that give equal patterns would find the same matches twice; the first one
/// names the match.
std::vector<Entry> entries_of(const RuleSet& rules, std::uint32_t number) {
  const Rule& rule = rules.rules[number];
  const int size = neighbourhood(rules.lattice).size;
  const auto group = orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule));
  std::vector<Entry> distinct;
  for (std::uint32_t g = 0; g < group.size(); ++g) {
    Entry entry{{number, g}, oriented(rule.pattern, group[g], size)};
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const Entry& other) {
      return other.pattern == entry.pattern;
    });
    if (!known) distinct.push_back(std::move(entry));
  }
  return distinct;
}

/// One match for each rule, in the first of its orientations that matches.
void keep_first_of_each_rule(std::vector<Match>& matches) {
  if (matches.size() < 2) return;
  std::sort(matches.begin(), matches.end());
  const auto same_rule = [](const Match& a, const Match& b) { return a.rule == b.rule; };
  matches.erase(std::unique(matches.begin(), matches.end(), same_rule), matches.end());
}

}  // namespace

/// The images of distinct neighbours are distinct, so every entry is written once.
Pattern oriented(const Pattern& pattern, const Orientation& orientation, int neighbours) {
  assert(neighbours > 0 && neighbours <= kMaxNeighbours);
  Pattern turned;
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours); ++i) {
    turned.allowed[static_cast<std::size_t>(orientation.image[i])] = pattern.allowed[i];
  }
  return turned;
}

int count_in_view(const CountCondition& condition, const Neighbourhood& neighbours,
                  const View& view) {
  int number = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbours.size); ++i) {
    if (condition.faces_only && !neighbours.is_face[i]) continue;
    number += condition.of.contains(view.at[i]) ? 1 : 0;
  }
  return number;
}

RuleTable::RuleTable(const RuleSet& rules)
    : lattice_(rules.lattice),
      floor_(rules.floor),
      stage_count_(rules.stage_count()),
      conflicts_(rules.conflicts),
      size_(neighbours().size),
      stage_limits_(static_cast<std::size_t>(stage_count_) + 1),
      index_(std::make_unique<TableIndex>()) {
  assert(stage_count_ <= kMaxStage);
  for (std::uint32_t r = 0; r < rules.rules.size(); ++r) {
    const Rule& rule = rules.rules[r];
    actions_.push_back(
        {rule.place, rule.stage, rule.probability, rule.weight, site_condition(rule), rule.counts});
    for (Entry& entry : entries_of(rules, r)) {
      index_->add(entry, static_cast<std::uint32_t>(entries_.size()), size_);
      entries_.push_back(std::move(entry));
    }
  }
  std::vector<bool> counting;
  for (const Entry& entry : entries_) {
    counting.push_back(!actions_[entry.source.rule].counts.empty());
  }
  index_->finish(entries_, counting, size_, rules.colours());
  // Neighbours that can never make a difference need not be re-examined after a deposit
  // there; counts look at all.
  for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) {
    sees_[i] = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.pattern.allowed[i] != StateSet::anything() ||
             !actions_[entry.source.rule].counts.empty();
    });
  }
  // Rules act beside bricks: for one that asks for none, any brick makes the difference.
  asks_for_none_ = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return std::all_of(entry.pattern.allowed.begin(), entry.pattern.allowed.begin() + size_,
                       [](StateSet s) { return s.contains(kEmpty) || s.contains(kFloor); });
  });
  if (asks_for_none_) sees_.fill(true);
  for (const auto& [stage, limit] : rules.stages) {
    if (stage >= 1 && stage <= stage_count_) stage_limits_[static_cast<std::size_t>(stage)] = limit;
  }
}

RuleTable::~RuleTable() = default;
RuleTable::RuleTable(RuleTable&&) noexcept = default;
RuleTable& RuleTable::operator=(RuleTable&&) noexcept = default;

std::int64_t RuleTable::stage_limit(int stage) const {
  assert(stage >= 1 && stage <= stage_count_);
  return stage_limits_[static_cast<std::size_t>(stage)];
}

/// Calls found(match, action) for each entry whose pattern matches until it returns true;
/// says whether one did. Exact entries come before loose ones; callers that need the order of
/// rules sort.
template <class Visit>
bool RuleTable::visit(const View& view, const Visit& found) const {
  const TableIndex& index = *index_;
  if (!index.exact.empty() && visit_exact(kViewHash(view, size_), view, found)) return true;
  for (std::size_t w = 0; w < index.words; ++w) {
    std::uint64_t alive = index.all(w);
    for (const std::uint8_t i : index.order) {
      alive &= index.accepting(i, index.row[view.at[i]], w);
      if (alive == 0) break;
    }
    if (visit_loose(w, alive, view, found)) return true;
  }
  return false;
}

/// The same of a view where it stands; with `change`, of those loose entries that can match since
/// that neighbour is not empty any more. The few neighbours that are not empty decide what is left
/// of a word; of that each entry is asked whether it wants more of them.
template <class Visit>
bool RuleTable::visit(const StandingView& view, std::optional<std::size_t> change,
                      const Visit& found) const {
  const TableIndex& index = *index_;
  if (!index.exact.empty() && index.find(view.hash) != 0 &&
      visit_exact(view.hash, index.gathered(view), found)) {
    return true;
  }
  const std::uint64_t* asking =
      change ? index.asking.data() + (*change * index.rows + view.code(*change)) * index.words
             : nullptr;
  for (std::size_t w = 0; w < index.words; ++w) {
    std::uint64_t alive = asking != nullptr ? asking[w] : index.all(w);
    const std::uint32_t known = change ? 1U << *change : 0;
    for (std::uint32_t rest = view.occupied & ~known; rest != 0 && alive != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      alive &= index.accepting(i, view.code(i), w);
    }
    std::uint64_t matching = 0;
    for (; alive != 0; alive &= alive - 1) {
      const auto bit = static_cast<std::size_t>(std::countr_zero(alive));
      if ((index.needs[w * 64 + bit] & ~view.occupied) == 0) matching |= alive & (0 - alive);
    }
    if (matching == 0) continue;
    // Counts alone need the view.
    if (visit_loose(w, matching, index.counts ? index.gathered(view) : View{}, found)) return true;
  }
  return false;
}

template <class Visit>
bool RuleTable::visit_exact(std::uint64_t hash, const View& view, const Visit& found) const {
  const TableIndex& index = *index_;
  const std::uint32_t first = index.find(hash);
  if (first == 0) return false;
  for (std::size_t i = first - 1; i < index.exact.size() && index.exact[i].hash == hash; ++i) {
    if (index.exact[i].view != view) continue;
    const Match& source = entries_[index.exact[i].entry].source;
    if (found(source, actions_[source.rule], view)) return true;
  }
  return false;
}

/// For those entries of a word that match.
template <class Visit>
bool RuleTable::visit_loose(std::size_t word, std::uint64_t matching, const View& view,
                            const Visit& found) const {
  for (; matching != 0; matching &= matching - 1) {
    const auto bit = static_cast<std::size_t>(std::countr_zero(matching));
    const Match& source = entries_[index_->loose[word * 64 + bit]].source;
    if (found(source, actions_[source.rule], view)) return true;
  }
  return false;
}

bool RuleTable::counts_hold(const Action& action, const View& view) const {
  if (action.counts.empty()) return true;  // by far the most
  return std::all_of(action.counts.begin(), action.counts.end(), [&](const CountCondition& c) {
    const int number = count_in_view(c, neighbours(), view);
    return number >= c.min && number <= c.max;
  });
}

bool RuleTable::enabled(const View& view, std::int32_t z, int stage) const {
  return visit(view, [&](const Match&, const Action& action, const View& seen) {
    return allows(action.where, {z, stage}) && counts_hold(action, seen);
  });
}

/// A visitor that gathers stages. Bit 0 stands for rules without a stage; they match in every stage
/// and in none in particular.
auto RuleTable::stage_finder(std::int32_t z, int from, std::uint64_t& open) const {
  return [this, &open, z, from](const Match&, const Action& action, const View& view) {
    if (!allows_height(action.where, z) || !counts_hold(action, view)) return false;
    const int own = action.stage;
    if (own == 0 || own >= from) open |= std::uint64_t{1} << own;
    return stage_count_ == 1;  // nothing else to find
  };
}

std::uint64_t RuleTable::open_stages(const View& view, std::int32_t z, int from) const {
  std::uint64_t open = 0;
  visit(view, stage_finder(z, from, open));
  return open;
}

std::uint64_t RuleTable::open_stages(const StandingView& view, std::int32_t z, int from) const {
  std::uint64_t open = 0;
  visit(view, std::nullopt, stage_finder(z, from, open));
  return open;
}

std::uint64_t RuleTable::newly_open_stages(const StandingView& view, std::size_t neighbour,
                                           std::int32_t z, int from) const {
  std::uint64_t open = 0;
  visit(view, neighbour, stage_finder(z, from, open));
  return open;
}

/// A visitor that gathers matches.
auto RuleTable::match_finder(std::int32_t z, int stage, std::vector<Match>& out) const {
  return [this, &out, z, stage](const Match& match, const Action& action, const View& view) {
    if (allows(action.where, {z, stage}) && counts_hold(action, view)) out.push_back(match);
    return false;
  };
}

void RuleTable::matches(const View& view, std::int32_t z, int stage,
                        std::vector<Match>& out) const {
  out.clear();
  visit(view, match_finder(z, stage, out));
  keep_first_of_each_rule(out);
}

void RuleTable::matches(const StandingView& view, std::int32_t z, int stage,
                        std::vector<Match>& out) const {
  out.clear();
  visit(view, std::nullopt, match_finder(z, stage, out));
  keep_first_of_each_rule(out);
}

std::size_t RuleTable::floor_code() const { return index_->rows - 1; }

OpeningFilter RuleTable::opening_filter() const {
  return {index_->slots.data(), index_->slots.size() - 1, index_->asked.data(), index_->rows};
}

}  // namespace stig::rules
