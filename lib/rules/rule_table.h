// SPDX-License-Identifier: MIT
// The compiled, immutable form of a rule set: every distinct orientation of every
// rule, indexed so that a site's view is matched in tens of nanoseconds.
//
// Two indices share the work. Exact entries (one state a cell) sit in a hash
// table under the view. The rest are matched together by bit sets: for each
// (neighbour, state) the set of entries that accept it; the matches of a view
// are the intersection over its neighbours. Heights, stages and counts are then
// checked one by one: rules of all stages share the indices.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rules/rule_set.h"
#include "rules/site_condition.h"

namespace stig::rules {

/// A rule that matches, in the first of its orientations that does.
struct Match {
  std::uint32_t rule = 0;  ///< index into RuleSet::rules
  std::uint32_t orientation =
      0;  ///< index into orientations(lattice, symmetry, inversion) of the rule
  auto operator<=>(const Match&) const = default;
};

/// One orientation of one rule; equal orientations of a rule are kept once.
struct Entry {
  Match source;
  Pattern pattern;
};

struct TableIndex;     // table_index.h
struct OpeningFilter;  // standing_view.h
struct StandingView;

class RuleTable {
 public:
  explicit RuleTable(const RuleSet& rules);
  ~RuleTable();
  RuleTable(RuleTable&&) noexcept;
  RuleTable& operator=(RuleTable&&) noexcept;

  const Neighbourhood& neighbours() const { return neighbourhood(lattice_); }
  Lattice lattice() const { return lattice_; }
  bool floor() const { return floor_; }
  int stage_count() const { return stage_count_; }
  const std::vector<Entry>& entries() const { return entries_; }

  /// Is some rule of this stage (1-based) matched by the view of a site at height z?
  bool enabled(const View& view, std::int32_t z, int stage) const;
  /// The stages, from `from` on, in which some rule is matched: bit s for a rule of stage
  /// s, bit 0 for one without a stage.
  std::uint64_t open_stages(const View& view, std::int32_t z, int from) const;
  /// All rules that match, by rising rule index, each once. `out` is cleared.
  void matches(const View& view, std::int32_t z, int stage, std::vector<Match>& out) const;

  /// The same two of a view where it stands.
  std::uint64_t open_stages(const StandingView& view, std::int32_t z, int from) const;
  void matches(const StandingView& view, std::int32_t z, int stage, std::vector<Match>& out) const;
  /// open_stages of a site that had none before this neighbour, which was empty, came to be a
  /// brick: only those entries are looked at to which that can make the difference.
  std::uint64_t newly_open_stages(const StandingView& view, std::size_t neighbour, std::int32_t z,
                                  int from) const;
  /// Good as long as the table is.
  OpeningFilter opening_filter() const;
  std::size_t floor_code() const;
  /// Can a rule match where there is no brick around?
  bool asks_for_none() const { return asks_for_none_; }

  /// Can the state of this neighbour ever decide whether a rule matches? Where not, a
  /// change there need not be looked at.
  bool sees(std::size_t neighbour) const { return sees_[neighbour]; }

  Colour place(std::uint32_t rule) const { return actions_[rule].place; }
  double probability(std::uint32_t rule) const { return actions_[rule].probability; }
  double weight(std::uint32_t rule) const { return actions_[rule].weight; }
  Conflicts conflicts() const { return conflicts_; }
  std::size_t rule_count() const { return actions_.size(); }
  /// Deposits after which a stage ends, or 0: when it has no event left.
  std::int64_t stage_limit(int stage) const;

 private:
  /// What a rule does and its conditions besides the pattern.
  struct Action {
    Colour place;
    int stage;  ///< its bit in open_stages()
    double probability, weight;
    SiteCondition where;
    std::vector<CountCondition> counts;
  };
  bool counts_hold(const Action& action, const View& view) const;
  template <class Visit>
  bool visit(const View& view, const Visit& found) const;
  template <class Visit>
  bool visit(const StandingView& view, std::optional<std::size_t> change, const Visit& found) const;
  template <class Visit>
  bool visit_exact(std::uint64_t hash, const View& view, const Visit& found) const;
  template <class Visit>
  bool visit_loose(std::size_t word, std::uint64_t matching, const View& view,
                   const Visit& found) const;
  auto stage_finder(std::int32_t z, int from, std::uint64_t& open) const;
  auto match_finder(std::int32_t z, int stage, std::vector<Match>& out) const;

  Lattice lattice_;
  bool floor_;
  int stage_count_;
  Conflicts conflicts_;
  int size_;  ///< of the neighbourhood
  std::array<bool, kMaxNeighbours> sees_{};
  bool asks_for_none_ = false;
  std::vector<Action> actions_;
  std::vector<Entry> entries_;
  std::vector<std::int64_t> stage_limits_;
  std::unique_ptr<TableIndex> index_;
};

/// Number of neighbours in view that show a state of the condition's set.
int count_in_view(const CountCondition& condition, const Neighbourhood& neighbours,
                  const View& view);
/// The pattern turned by an orientation: what the rule looks for when turned so.
Pattern oriented(const Pattern& pattern, const Orientation& orientation, int neighbours);

}  // namespace stig::rules
