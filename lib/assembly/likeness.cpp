// SPDX-License-Identifier: MIT
// Comparing all pairs of cases would be quadratic in thousands. Cases are put together by the cells
// that are seen to be empty and filled; pairs of such shapes are few, and within a pair colours at
// the common cells are compared by a hash table.
#include "assembly/likeness.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
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

/// What is done in cases and what may be, each as a number of what is the same.
class Intentions {
 public:
  Intentions(const std::vector<Case>& cases, const std::vector<Colour>& colours,
             const std::vector<std::vector<bool>>& done) {
    std::map<Places, std::uint32_t> known;
    const auto number = [&](Places places) {
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end()), places.end());
      const auto [at, added] =
          known.emplace(std::move(places), static_cast<std::uint32_t>(known.size()));
      if (added) places_.push_back(at->first);
      return at->second;
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
      Places all, wanted;
      for (std::size_t c = 0; c < cases[i].choices.size(); ++c) {
        const Choice& one = cases[i].choices[c];
        all.emplace_back(one.at, colours[one.brick]);
        if (done[i][c]) wanted.push_back(all.back());
      }
      choices_.push_back(number(std::move(all)));
      wanted_.push_back(number(std::move(wanted)));
    }
  }

  /// Is something done there?
  bool busy(std::uint32_t i) const { return !places_[wanted_[i]].empty(); }
  std::uint32_t choices(std::uint32_t i) const { return choices_[i]; }
  /// Is all that is done in the case among these choices?
  bool allowed(std::uint32_t i, std::uint32_t choices) const {
    const Places &some = places_[wanted_[i]], &all = places_[choices];
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  }

 private:
  using Places = std::vector<std::pair<WindowCell, Colour>>;  ///< rising
  std::vector<Places> places_;
  std::vector<std::uint32_t> choices_, wanted_;  ///< by case
};

/// Cases that look alike, and what they have to choose from.
struct Alike {
  std::vector<std::uint32_t> cases;
  std::set<std::uint32_t> choices;
};

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
                                   const std::vector<std::vector<bool>>& done,
                                   const std::function<bool(const Likeness&)>& visit) const {
  assert(done.size() == cases_.size());
  const Intentions intend(cases_, colours, done);
  std::uint64_t looked = 0;
  for (const Shape& one : shapes_) {
    std::vector<std::uint32_t> working;
    for (const std::uint32_t i : one.cases) {
      if (intend.busy(i)) working.push_back(i);
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
      std::unordered_map<std::string, Alike> alike;
      for (const std::uint32_t i : other.cases) {
        // Where such a question exists, an idle `b` is told apart already.
        if (more && !intend.busy(i)) continue;
        Alike& some = alike[seen_in(cases_[i], both, colours)];
        some.cases.push_back(i);
        some.choices.insert(intend.choices(i));
      }
      looked += other.cases.size() + working.size();
      for (const std::uint32_t a : working) {
        const auto found = alike.find(seen_in(cases_[a], both, colours));
        if (found == alike.end()) continue;
        const std::set<std::uint32_t>& choices = found->second.choices;
        const auto harmless = [&](std::uint32_t choice) { return intend.allowed(a, choice); };
        // Long rows have thousands of cases that look alike and want the same.
        if (std::all_of(choices.begin(), choices.end(), harmless)) continue;
        for (const std::uint32_t b : found->second.cases) {
          if (a == b || harmless(intend.choices(b))) continue;
          if (!visit({a, b, more})) return looked;
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
