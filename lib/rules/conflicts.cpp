// SPDX-License-Identifier: MIT
// Finds pairs of oriented rules that some neighbourhood satisfies both of. Comparing all
// pairs would be quadratic in up to 20 000 rules times their orientations, so exact
// patterns are compared by hash, and patterns with wildcards through a bit index (as in
// rule_table.cpp): for each one, the AND over neighbours of those that share a state there.
// What remains is decided exactly by view_search.h. All work is counted against a budget,
// so a hostile file cannot stall the reader.
#include "rules/conflicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "base/hash.h"
#include "base/text.h"
#include "rules/rule_printer.h"
#include "rules/site_condition.h"
#include "rules/view_search.h"

namespace stig::rules {

namespace {

constexpr std::size_t kMostConflicts = 100;  ///< reported of one set
constexpr Budget kBudget = 1'500'000'000;    ///< about a second
constexpr std::size_t kMostIndexBytes = 64U << 20U;

/// Orientation lists of every symmetry the set's rules name, made once. Few symmetries
/// occur in a set, and each list has up to 24 elements.
class Groups {
 public:
  explicit Groups(const RuleSet& rules) : rules_(rules) {}
  const std::vector<Orientation>& of(const Rule& rule) {
    const auto key = std::pair(rules_.symmetry_of(rule), rules_.inversion_of(rule));
    auto& group = groups_[key];
    if (group.empty()) group = orientations(rules_.lattice, key.first, key.second);
    return group;
  }
  /// True when one list serves all rules and it keeps the world as it is: then turning two
  /// rules alike changes nothing, and one of them can be left unturned. Inversion is no such
  /// turn where heights or the floor tell up from down.
  bool is_common() {
    bool heights = rules_.floor;
    for (const Rule& rule : rules_.rules) {
      of(rule);
      heights = heights || !allows_every_height(site_condition(rule));
    }
    return groups_.size() == 1 && !(groups_.begin()->first.second && heights);
  }

 private:
  const RuleSet& rules_;
  std::map<std::pair<Symmetry, bool>, std::vector<Orientation>> groups_;
};

/// A rule in one orientation.
struct Turned {
  std::uint32_t rule;
  std::uint32_t orientation;
  Pattern pattern;
};

/// An exact pattern is a single view; two of them meet only if they are equal.
bool is_exact(const Pattern& pattern, int size) {
  return std::all_of(pattern.allowed.begin(), pattern.allowed.begin() + size,
                     [](StateSet s) { return s.is_single(); });
}

std::uint64_t hash_of(const Pattern& pattern, int size) {
  std::uint64_t hash = 0;
  for (int i = 0; i < size; ++i) {
    hash = combine(hash, pattern.allowed[static_cast<std::size_t>(i)].bits());
  }
  return hash;
}

/// Is there a height and a stage that both rules allow?
bool meet(const Rule& a, const Rule& b) {
  return allowed_height(both(site_condition(a), site_condition(b)), Interval()).has_value();
}

/// All distinct orientations of a rule, the identity first: messages do not name that one.
std::vector<Turned> turned_rule(const RuleSet& rules, std::uint32_t index, Groups& groups) {
  const Rule& rule = rules.rules[index];
  const auto& group = groups.of(rule);
  std::vector<Turned> out;
  for (std::uint32_t g = 0; g < group.size(); ++g) {
    Turned entry{index, g, turned(rule.pattern, group[g], rules.lattice)};
    const bool known = std::any_of(out.begin(), out.end(),
                                   [&](const Turned& t) { return t.pattern == entry.pattern; });
    if (!known) out.push_back(std::move(entry));
  }
  return out;
}

/// For every neighbour and state the entries that accept it, as bits.
class PatternIndex {
 public:
  PatternIndex(const std::vector<Turned>& entries, int size, int colours)
      : size_(static_cast<std::size_t>(size)), words_((entries.size() + 63) / 64) {
    for (int c = 0; c <= colours; ++c) states_.push_back(static_cast<State>(c));
    states_.push_back(kFloor);
    bits_.assign(size_ * states_.size() * words_, 0);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t s = 0; s < states_.size(); ++s) {
          if (!entries[e].pattern.allowed[i].contains(states_[s])) continue;
          row(i, s)[e / 64] |= std::uint64_t{1} << (e % 64);
        }
      }
    }
  }
  // One bit for each entry, neighbour and state. The size is known before anything is built,
  // so a set whose index would be too large is refused and not started on.
  static std::size_t bytes(std::size_t entries, int size, int colours) {
    return entries / 8 * static_cast<std::size_t>(size) * static_cast<std::size_t>(colours + 2);
  }

  /// Entries whose allowed states meet the pattern's in every cell.
  void meeting(const Pattern& pattern, std::vector<std::uint64_t>& out, Budget& budget) const {
    out.assign(words_, ~std::uint64_t{0});
    std::vector<std::uint64_t> any(words_);
    for (std::size_t i = 0; i < size_; ++i) {
      // A neighbour that may be anything excludes no entry.
      if (pattern.allowed[i] == StateSet::anything()) continue;
      std::fill(any.begin(), any.end(), 0);
      for (std::size_t s = 0; s < states_.size(); ++s) {
        if (!pattern.allowed[i].contains(states_[s])) continue;
        budget -= static_cast<Budget>(words_);
        const std::uint64_t* accepting = row(i, s);
        for (std::size_t w = 0; w < words_; ++w) any[w] |= accepting[w];
      }
      std::uint64_t left = 0;
      for (std::size_t w = 0; w < words_; ++w) left |= out[w] &= any[w];
      if (left == 0) return;
    }
  }

 private:
  std::uint64_t* row(std::size_t cell, std::size_t state) {
    return bits_.data() + (cell * states_.size() + state) * words_;
  }
  const std::uint64_t* row(std::size_t cell, std::size_t state) const {
    return bits_.data() + (cell * states_.size() + state) * words_;
  }

  std::size_t size_, words_;
  std::vector<State> states_;
  std::vector<std::uint64_t> bits_;
};

class ConflictSearch {
 public:
  ConflictSearch(const RuleSet& rules, Diagnostics& diagnostics)
      : rules_(rules), out_(diagnostics), groups_(rules) {}

  void run() {
    size_ = neighbourhood(rules_.lattice).size;
    const bool common = groups_.is_common();
    for (std::uint32_t r = 0; r < rules_.rules.size(); ++r) {
      for (Turned& entry : turned_rule(rules_, r, groups_)) {
        const bool exact = is_exact(entry.pattern, size_);
        if (exact) exact_[hash_of(entry.pattern, size_)].push_back(entry);
        // Every turned pattern can be met; a rule need ask only as it is written where one
        // list of turns serves all rules.
        if (!common || entry.orientation == 0) asking_.push_back(entry);
        if (!exact) open_.push_back(std::move(entry));
      }
    }
    if (PatternIndex::bytes(open_.size(), size_, rules_.colours()) > kMostIndexBytes) {
      return give_up(rules_.rules.front());
    }
    const PatternIndex index(open_, size_, rules_.colours());
    for (const Turned& entry : asking_) {
      if (done_) return;
      ask(entry, index);
    }
  }

 private:
  /// Compares one rule with the equal exact entries and with all open ones. An exact entry
  /// meets an open one when it asks; the open one need not ask it too. Pairs are found in
  /// at least one direction; `found_` keeps them from being reported in both.
  void ask(const Turned& entry, const PatternIndex& index) {
    if (is_exact(entry.pattern, size_)) {
      for (const Turned& other : exact_[hash_of(entry.pattern, size_)]) compare(entry, other);
    }
    if (open_.empty()) return;
    index.meeting(entry.pattern, meeting_, budget_);
    for (std::size_t w = 0; w < meeting_.size() && !done_; ++w) {
      for (std::uint64_t bits = meeting_[w]; bits != 0 && !done_; bits &= bits - 1) {
        const std::size_t e = w * 64 + static_cast<std::size_t>(std::countr_zero(bits));
        if (e < open_.size()) compare(entry, open_[e]);
      }
    }
  }

  void compare(const Turned& a, const Turned& b) {
    if (done_) return;
    // Steps are rough weights of the work, in the unit of kBudget.
    budget_ -= 8;
    const Rule& first = rules_.rules[std::min(a.rule, b.rule)];
    const Rule& second = rules_.rules[std::max(a.rule, b.rule)];
    if (budget_ < 0) return give_up(second);
    if (first.place == second.place || !meet(first, second)) return;
    if (found_.count(std::minmax(a.rule, b.rule)) > 0) return;
    // The tests above are in the order of their cost; only what comes now searches.
    Example example;
    budget_ -= 500;
    const Answer answer = find_view(rules_, both(demand(a), demand(b)), example, budget_);
    if (answer == Answer::no) return;
    found_.insert(std::minmax(a.rule, b.rule));
    if (answer == Answer::yes) {
      report(a.rule < b.rule ? a : b, a.rule < b.rule ? b : a, example);
    } else if (budget_ < 0) {
      give_up(second);
    } else {
      undecided(first, second);
    }
  }

  Demand demand(const Turned& entry) const {
    Demand out = demand_of(rules_.rules[entry.rule]);
    out.pattern = entry.pattern;
    return out;
  }

  std::string name(const Turned& entry) {
    const Rule& rule = rules_.rules[entry.rule];
    const std::string name = in_quotes(rule.name);
    return entry.orientation == 0
               ? name
               : fmt::format("{} ({})", name, groups_.of(rule)[entry.orientation].name);
  }

  void report(const Turned& a, const Turned& b, const Example& example) {
    const Rule& first = rules_.rules[a.rule];
    const Rule& second = rules_.rules[b.rule];
    out_.add(Code::R301, rule_place(second),
             fmt::format(
                 "rules {} and {} conflict: where both match, one places {} and the other {}",
                 in_quotes(first.name), in_quotes(second.name),
                 in_quotes(rules_.brick(first.place).symbol),
                 in_quotes(rules_.brick(second.place).symbol)))
        .note(rule_place(first), "the first one")
        .note(fmt::format("both {} and {} match at height {}:\n{}", name(a), name(b), example.z,
                          draw_view(rules_, example.view)));
    // After so many conflicts the cause is systematic, and further ones say nothing new.
    if (++reported_ < kMostConflicts) return;
    out_.add(Code::R302, rule_place(second), "no more conflicts were looked for after so many");
    done_ = true;
  }

  void undecided(const Rule& first, const Rule& second) {
    out_.add(Code::R302, rule_place(second),
             fmt::format("whether the rules {} and {} conflict could not be decided",
                         in_quotes(first.name), in_quotes(second.name)))
        .note(rule_place(first), "the first one");
  }

  void give_up(const Rule& rule) {
    out_.add(Code::R302, rule_place(rule),
             "not all rules could be compared: the search for conflicts takes too long");
    done_ = true;
  }

  const RuleSet& rules_;
  Diagnostics& out_;
  Groups groups_;
  int size_ = 0;
  std::unordered_map<std::uint64_t, std::vector<Turned>> exact_;
  std::vector<Turned> open_, asking_;
  std::vector<std::uint64_t> meeting_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> found_;
  Budget budget_ = kBudget;
  std::size_t reported_ = 0;
  bool done_ = false;
};

/// Everything but the drawing that makes two rules the same. A hash to find candidates;
/// same_conditions decides.
std::uint64_t conditions_hash(const Rule& rule) {
  std::uint64_t hash = rule.place;
  for_each_part(site_condition(rule), {},
                [&](std::string_view, const Interval& asked, std::int64_t) {
                  hash = combine(hash, static_cast<std::uint64_t>(asked.low));
                  hash = combine(hash, static_cast<std::uint64_t>(asked.high));
                });
  std::uint64_t counts = 0;  // a sum: their order does not matter
  for (const CountCondition& c : rule.counts) {
    counts +=
        combine(combine(c.of.bits(), c.faces_only), static_cast<std::uint64_t>(c.min * 64 + c.max));
  }
  return combine(hash, counts);
}

bool same_conditions(const Rule& a, const Rule& b) {
  const auto counts = [](const Rule& rule) {
    std::multiset<std::tuple<std::uint64_t, bool, int, int>> out;
    for (const CountCondition& c : rule.counts)
      out.emplace(c.of.bits(), c.faces_only, c.min, c.max);
    return out;
  };
  return a.place == b.place && site_condition(a) == site_condition(b) && counts(a) == counts(b);
}

/// Is every pattern of `entries` among those of `others`? A rule repeats an earlier one if
/// each of its orientations is an orientation of that.
bool covers(const std::vector<Turned>& others, const std::vector<Turned>& entries) {
  return std::all_of(entries.begin(), entries.end(), [&](const Turned& entry) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Turned& other) { return other.pattern == entry.pattern; });
  });
}

}  // namespace

SourceRange rule_place(const Rule& rule) { return rule.name_range ? rule.name_range : rule.range; }

void check_conflicts(const RuleSet& rules, Diagnostics& diagnostics) {
  if (rules.conflicts != Conflicts::error || rules.rules.empty()) return;
  ConflictSearch(rules, diagnostics).run();
}

void check_repetitions(const RuleSet& rules, Diagnostics& diagnostics) {
  const int size = neighbourhood(rules.lattice).size;
  Groups groups(rules);
  // Hash of a pattern in any orientation, with its conditions -> such rules, none a
  // repetition. They differ in symmetry, so a list is short.
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> seen;
  for (std::uint32_t r = 0; r < rules.rules.size(); ++r) {
    const Rule& rule = rules.rules[r];
    const std::uint64_t conditions = conditions_hash(rule);
    const std::vector<Turned> entries = turned_rule(rules, r, groups);
    const auto repeated = [&](std::uint32_t earlier) {
      return same_conditions(rules.rules[earlier], rule) &&
             covers(turned_rule(rules, earlier, groups), entries);
    };
    const auto& alike = seen[combine(conditions, hash_of(entries[0].pattern, size))];
    const auto found = std::find_if(alike.begin(), alike.end(), repeated);
    if (found != alike.end()) {
      const Rule& first = rules.rules[*found];
      diagnostics
          .add(Code::R303, rule_place(rule),
               fmt::format("rule {} repeats rule {}", in_quotes(rule.name), in_quotes(first.name)))
          .note(rule_place(first), "the first one");
      continue;
    }
    for (const Turned& entry : entries) {
      seen[combine(conditions, hash_of(entry.pattern, size))].push_back(r);
    }
  }
}

}  // namespace stig::rules
