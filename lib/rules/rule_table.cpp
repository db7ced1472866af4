// SPDX-License-Identifier: MIT
// Compiles a rule set into two indices (see the header). The order of work is chosen for
// the engines' hot path, which asks for one view at a time and mostly gets "no": the hash
// of exact entries costs one look-up, and the bit sets are intersected from the most
// selective neighbour on, so most words are zero after two or three neighbours.
#include "rules/rule_table.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "base/hash.h"

namespace stig::rules {
namespace {

/// Random words by neighbour and state; a view's hash is their exclusive or. Exclusive or
/// makes the hash independent of the order of neighbours, and each table entry is a
/// compile-time constant.
struct ViewHash {
  std::array<std::array<std::uint64_t, 64>, 32> word{};
  constexpr ViewHash() {
    for (std::size_t i = 0; i < 32; ++i) {
      // Word of the empty state is 0, so only what stands around costs entropy.
      for (std::size_t s = 1; s < 64; ++s) word[i][s] = mix(i * 64 + s + 0x517cc1b727220a95ULL);
    }
  }
  std::uint64_t operator()(const View& view, int size) const {
    std::uint64_t h = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) h ^= word[i][view.at[i]];
    return h;
  }
};
constexpr ViewHash kViewHash;

/// A pattern with one state in every cell is a view.
std::optional<View> as_view(const Pattern& pattern, int size) {
  View view;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    if (!pattern.allowed[i].is_single()) return std::nullopt;
    view.at[i] = pattern.allowed[i].first();
  }
  return view;
}

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

/// Entries are numbered as in RuleTable::entries_.
struct RuleTable::Index {
  struct Exact {
    View view;
    std::uint64_t hash;
    std::uint32_t entry;
  };
  std::vector<Exact> exact;            ///< by hash, then entry
  std::vector<std::uint32_t> slots;    ///< open addressing by hash: 1 + first in `exact`; 0 free
  std::vector<std::uint32_t> loose;    ///< entries with wildcards, rising
  std::size_t words = 0;               ///< of a bit set over `loose`
  std::vector<std::uint64_t> accept;   ///< [neighbour][row of state][word]
  std::array<std::uint8_t, 64> row{};  ///< state -> row; states no rule names share row 0
  std::size_t rows = 1;
  std::vector<std::uint8_t> order;  ///< neighbours, the most selective first

  void add(const Entry& entry, std::uint32_t number, int size);
  void finish(const std::vector<Entry>& entries, int size, int colours);
  bool accepts_anything(std::size_t neighbour) const;
  std::uint32_t find(std::uint64_t hash) const;
};

void RuleTable::Index::add(const Entry& entry, std::uint32_t number, int size) {
  if (const auto view = as_view(entry.pattern, size)) {
    exact.push_back({*view, kViewHash(*view, size), number});
  } else {
    loose.push_back(number);
  }
}

/// Exact entries of equal hash stand next to each other, by rising entry, and the slot
/// points at the first.
void RuleTable::Index::finish(const std::vector<Entry>& entries, int size, int colours) {
  std::sort(exact.begin(), exact.end(), [](const Exact& a, const Exact& b) {
    return std::tie(a.hash, a.entry) < std::tie(b.hash, b.entry);
  });
  // A quarter full at most: misses, the frequent case, end at once.
  slots.assign(std::bit_ceil(exact.size() * 4 + 1), 0);
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    if (i > 0 && exact[i].hash == exact[i - 1].hash) continue;
    std::size_t slot = exact[i].hash & (slots.size() - 1);
    while (slots[slot] != 0) slot = (slot + 1) & (slots.size() - 1);
    slots[slot] = i + 1;
  }
  // States beyond the colours of this set share row 0 with the empty state; no view shows
  // them.
  for (int c = 1; c <= colours; ++c)
    row[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(rows++);
  row[kFloor] = static_cast<std::uint8_t>(rows++);

  words = (loose.size() + 63) / 64;
  accept.assign(static_cast<std::size_t>(size) * rows * words, 0);
  std::array<std::size_t, kMaxNeighbours> accepting_empty{};
  for (std::size_t k = 0; k < loose.size(); ++k) {
    const Pattern& pattern = entries[loose[k]].pattern;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
      for (std::size_t state = 0; state < 64; ++state) {
        if (state != kEmpty && row[state] == 0) continue;
        if (!pattern.allowed[i].contains(static_cast<State>(state))) continue;
        accept[(i * rows + row[state]) * words + k / 64] |= std::uint64_t{1} << (k % 64);
      }
      accepting_empty[i] += pattern.allowed[i].contains(kEmpty) ? 1U : 0U;
    }
  }
  // A neighbour that no pattern asks about is left out of the order altogether.
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    if (!accepts_anything(i)) order.push_back(static_cast<std::uint8_t>(i));
  }
  // Views are mostly empty, so the neighbours at which few entries accept emptiness exclude
  // the most.
  std::stable_sort(order.begin(), order.end(), [&](std::uint8_t a, std::uint8_t b) {
    return accepting_empty[a] < accepting_empty[b];
  });
}

/// Does every entry accept every state of this neighbour?
bool RuleTable::Index::accepts_anything(std::size_t neighbour) const {
  for (std::size_t k = 0; k < loose.size() * rows; ++k) {
    const std::size_t entry = k / rows, at = neighbour * rows + k % rows;
    if ((accept[at * words + entry / 64] >> (entry % 64) & 1U) == 0) return false;
  }
  return true;
}

/// 1 + the first exact entry with this hash, or 0.
std::uint32_t RuleTable::Index::find(std::uint64_t hash) const {
  for (std::size_t slot = hash & (slots.size() - 1); slots[slot] != 0;
       slot = (slot + 1) & (slots.size() - 1)) {
    if (exact[slots[slot] - 1].hash == hash) return slots[slot];
  }
  return 0;
}

RuleTable::RuleTable(const RuleSet& rules)
    : lattice_(rules.lattice),
      floor_(rules.floor),
      stage_count_(rules.stage_count()),
      conflicts_(rules.conflicts),
      size_(neighbours().size),
      stage_limits_(static_cast<std::size_t>(stage_count_) + 1),
      index_(std::make_unique<Index>()) {
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
  index_->finish(entries_, size_, rules.colours());
  // Neighbours that can never make a difference need not be re-examined after a deposit
  // there; counts look at all.
  for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) {
    sees_[i] = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.pattern.allowed[i] != StateSet::anything() ||
             !actions_[entry.source.rule].counts.empty();
    });
  }
  // Rules act beside bricks: for one that asks for none, any brick makes the difference.
  const bool asks_for_none = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return std::all_of(entry.pattern.allowed.begin(), entry.pattern.allowed.begin() + size_,
                       [](StateSet s) { return s.contains(kEmpty) || s.contains(kFloor); });
  });
  if (asks_for_none) sees_.fill(true);
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

bool RuleTable::counts_hold(const Action& action, const View& view) const {
  if (action.counts.empty()) return true;  // by far the most
  return std::all_of(action.counts.begin(), action.counts.end(), [&](const CountCondition& c) {
    const int number = count_in_view(c, neighbours(), view);
    return number >= c.min && number <= c.max;
  });
}

/// Calls found(match, action) for each entry whose pattern matches until it returns true;
/// says whether one did.
template <class Visit>
bool RuleTable::visit(const View& view, const Visit& found) const {
  // Exact entries come before loose ones; callers that need the order of rules sort.
  const Index& index = *index_;
  const auto accepted = [&](std::uint32_t entry) {
    const Match& source = entries_[entry].source;
    return found(source, actions_[source.rule]);
  };
  if (!index.exact.empty()) {
    const std::uint64_t hash = kViewHash(view, size_);
    if (const std::uint32_t first = index.find(hash)) {
      for (std::size_t i = first - 1; i < index.exact.size() && index.exact[i].hash == hash; ++i) {
        if (index.exact[i].view == view && accepted(index.exact[i].entry)) return true;
      }
    }
  }
  for (std::size_t w = 0; w < index.words; ++w) {
    const std::size_t last = index.loose.size() - w * 64;
    std::uint64_t alive = last >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << last) - 1;
    for (const std::uint8_t i : index.order) {
      alive &= index.accept[(i * index.rows + index.row[view.at[i]]) * index.words + w];
      if (alive == 0) break;
    }
    for (; alive != 0; alive &= alive - 1) {
      const auto bit = static_cast<std::size_t>(std::countr_zero(alive));
      if (accepted(index.loose[w * 64 + bit])) return true;
    }
  }
  return false;
}

bool RuleTable::enabled(const View& view, std::int32_t z, int stage) const {
  return visit(view, [&](const Match&, const Action& action) {
    return allows(action.where, {z, stage}) && counts_hold(action, view);
  });
}

/// Bit 0 stands for rules without a stage; they match in every stage and in none in
/// particular.
std::uint64_t RuleTable::open_stages(const View& view, std::int32_t z, int from) const {
  std::uint64_t open = 0;
  visit(view, [&](const Match&, const Action& action) {
    if (!allows_height(action.where, z) || !counts_hold(action, view)) return false;
    const int own = action.stage;
    if (own == 0 || own >= from) open |= std::uint64_t{1} << own;
    return stage_count_ == 1;  // nothing else to find
  });
  return open;
}

void RuleTable::matches(const View& view, std::int32_t z, int stage,
                        std::vector<Match>& out) const {
  out.clear();
  visit(view, [&](const Match& match, const Action& action) {
    if (allows(action.where, {z, stage}) && counts_hold(action, view)) out.push_back(match);
    return false;
  });
  // One match for each rule, in the first of its orientations that matches.
  std::sort(out.begin(), out.end());
  const auto same_rule = [](const Match& a, const Match& b) { return a.rule == b.rule; };
  out.erase(std::unique(out.begin(), out.end(), same_rule), out.end());
}

}  // namespace stig::rules
