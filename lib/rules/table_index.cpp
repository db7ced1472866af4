// SPDX-License-Identifier: MIT
#include "rules/table_index.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <tuple>

namespace stig::rules {
namespace {

/// A pattern with one state in every cell is a view.
std::optional<View> as_view(const Pattern& pattern, int size) {
  View view;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    if (!pattern.allowed[i].is_single()) return std::nullopt;
    view.at[i] = pattern.allowed[i].first();
  }
  return view;
}

}  // namespace

void TableIndex::add(const Entry& entry, std::uint32_t number, int size) {
  if (const auto view = as_view(entry.pattern, size)) {
    exact.push_back({*view, kViewHash(*view, size), number});
  } else {
    loose.push_back(number);
  }
}

void TableIndex::finish(const std::vector<Entry>& entries, const std::vector<bool>& counting,
                        int size, int colours) {
  counts = std::find(counting.begin(), counting.end(), true) != counting.end();
  hash_exact();
  // States beyond the colours of this set share row 0 with the empty state; no view shows
  // them.
  for (int c = 1; c <= colours; ++c)
    row[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(rows++);
  row[kFloor] = static_cast<std::uint8_t>(rows++);
  lay_out_loose(entries, static_cast<std::size_t>(size));
  find_asking(counting, static_cast<std::size_t>(size));
}

/// Exact entries of equal hash stand next to each other, by rising entry, and the slot
/// points at the first.
void TableIndex::hash_exact() {
  std::sort(exact.begin(), exact.end(), [](const Exact& a, const Exact& b) {
    return std::tie(a.hash, a.entry) < std::tie(b.hash, b.entry);
  });
  // An eighth full at most: misses, the frequent case, end at once.
  slots.assign(std::bit_ceil(exact.size() * 8 + 1), 0);
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    if (i > 0 && exact[i].hash == exact[i - 1].hash) continue;
    std::size_t slot = exact[i].hash & (slots.size() - 1);
    while (slots[slot] != 0) slot = (slot + 1) & (slots.size() - 1);
    slots[slot] = i + 1;
  }
}

void TableIndex::lay_out_loose(const std::vector<Entry>& entries, std::size_t size) {
  words = (loose.size() + 63) / 64;
  accept.assign(size * rows * words, 0);
  needs.assign(loose.size(), 0);
  std::array<std::size_t, kMaxNeighbours> accepting_empty{};
  for (std::size_t k = 0; k < loose.size(); ++k) {
    const Pattern& pattern = entries[loose[k]].pattern;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t state = 0; state < 64; ++state) {
        if (state != kEmpty && row[state] == 0) continue;
        if (!pattern.allowed[i].contains(static_cast<State>(state))) continue;
        accept[(i * rows + row[state]) * words + k / 64] |= std::uint64_t{1} << (k % 64);
      }
      const bool empty = pattern.allowed[i].contains(kEmpty);
      accepting_empty[i] += empty ? 1U : 0U;
      if (!empty) needs[k] |= 1U << i;
    }
  }
  // A neighbour that no pattern asks about is left out of the order altogether.
  for (std::size_t i = 0; i < size; ++i) {
    if (!accepts_anything(i)) order.push_back(static_cast<std::uint8_t>(i));
  }
  // Views are mostly empty, so the neighbours at which few entries accept emptiness exclude
  // the most.
  std::stable_sort(order.begin(), order.end(), [&](std::uint8_t a, std::uint8_t b) {
    return accepting_empty[a] < accepting_empty[b];
  });
}

/// Entries that accept a state and not emptiness; one with counts may match anew by any brick.
void TableIndex::find_asking(const std::vector<bool>& counting, std::size_t size) {
  asking = accept;
  asked.assign(size * rows, 0);
  std::vector<std::uint64_t> counted(words);
  for (std::size_t k = 0; k < loose.size(); ++k) {
    if (counting[loose[k]]) counted[k / 64] |= std::uint64_t{1} << (k % 64);
  }
  for (std::size_t i = 0; i < size * rows; ++i) {
    for (std::size_t w = 0; w < words; ++w) {
      std::uint64_t& set = asking[i * words + w];
      set &= ~accepting(i / rows, 0, w) | counted[w];
      if (set != 0) asked[i] = 1;
    }
  }
}

/// Does every entry accept every state of this neighbour?
bool TableIndex::accepts_anything(std::size_t neighbour) const {
  for (std::size_t k = 0; k < loose.size() * rows; ++k) {
    const std::size_t entry = k / rows;
    if ((accepting(neighbour, k % rows, entry / 64) >> (entry % 64) & 1U) == 0) return false;
  }
  return true;
}

View TableIndex::gathered(const StandingView& view) const {
  View out;
  for (std::uint32_t rest = view.occupied; rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    const std::size_t code = view.code(i);
    out.at[i] = code == rows - 1 ? kFloor : static_cast<State>(code);
  }
  return out;
}

}  // namespace stig::rules
