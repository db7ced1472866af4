// SPDX-License-Identifier: MIT
// Comparing all pairs of cases would be quadratic in thousands. Cases are put together by the cells
// that are seen to be empty and filled; pairs of such shapes are few, and within a pair colours at
// the common cells are compared by a hash table.
#include "assembly/likeness.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>

namespace stig::assembly {

namespace {

/// What is seen of the cells, as a text.
std::string seen_in(const Case& one, const CellBits& cells, const std::vector<Colour>& colours) {
  std::string out;
  for (std::size_t i = 0; i < one.bricks.size(); ++i) {
    // A colour fits a char, see kMaxColours.
    if (cells[i]) out += static_cast<char>(colours[one.bricks[i]]);
  }
  return out;
}

}  // namespace

Likenesses::Likenesses(const std::vector<Case>& cases) : cases_(cases) {
  std::map<std::tuple<ApproachSide, std::string, std::string>, std::size_t> known;
  for (std::uint32_t i = 0; i < cases.size(); ++i) {
    const Case& one = cases[i];
    const auto [at, added] = known.emplace(
        std::tuple(one.side, one.empty.to_string(), one.filled.to_string()), shapes_.size());
    if (added) shapes_.push_back({one.side, one.empty, one.filled, {}});
    shapes_[at->second].cases.push_back(i);
  }
}

std::uint64_t Likenesses::for_each(const std::vector<Colour>& colours,
                                   const std::vector<bool>& busy,
                                   const std::function<bool(const Likeness&)>& visit) const {
  assert(busy.size() == cases_.size());
  std::uint64_t looked = 0;
  for (const Shape& one : shapes_) {
    std::vector<std::uint32_t> working;
    for (const std::uint32_t i : one.cases) {
      if (busy[i]) working.push_back(i);
    }
    if (working.empty()) continue;
    for (const Shape& other : shapes_) {
      ++looked;
      // A cell that is empty in one and filled in the other tells them apart whatever the colours:
      // the question "is there a brick?" is answered in both.
      if (one.side != other.side || (one.empty & other.filled).any() ||
          (one.filled & other.empty).any()) {
        continue;
      }
      // If `one` sees a cell that `other` does not, a robot in `one` could ask about it, and gets
      // no answer in `other`.
      const bool more = ((one.empty | one.filled) & ~(other.empty | other.filled)).any();
      const CellBits both = one.filled & other.filled;
      std::unordered_map<std::string, std::vector<std::uint32_t>> alike;
      for (const std::uint32_t i : other.cases) {
        // Where such a question exists, an idle `b` is told apart already.
        if (!more || busy[i]) alike[seen_in(cases_[i], both, colours)].push_back(i);
      }
      looked += other.cases.size() + working.size();
      for (const std::uint32_t a : working) {
        const auto found = alike.find(seen_in(cases_[a], both, colours));
        if (found == alike.end()) continue;
        for (const std::uint32_t b : found->second) {
          if (a != b && !visit({a, b, more})) return looked;
        }
      }
    }
  }
  return looked;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> compared_bricks(const Case& a, const Case& b) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  const CellBits both = a.filled & b.filled;
  for (std::size_t i = 0; i < a.bricks.size(); ++i) {
    if (!both[i] || a.bricks[i] == b.bricks[i]) continue;
    out.emplace_back(std::min(a.bricks[i], b.bricks[i]), std::max(a.bricks[i], b.bricks[i]));
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace stig::assembly
