// SPDX-License-Identifier: MIT
// Derives every clause of a minimality formula again from the problem and from the reason
// that stands before it. What is shown is one direction alone: each colouring that builds
// in the order fulfils every clause. A formula may say less than it could, which only makes
// a refutation harder; it may never say more. So superfluous literals in a clause are no
// error, and every test below asks whether the clause contains what is needed, never
// whether it is minimal.
//
// The reasons are untrusted like the clauses: a wrong one derives nothing.
#include "certify/fewest.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "certify/colour_problem.h"

namespace stig::certify {
namespace {

using Clause = std::vector<std::int64_t>;

/// Words of a line, parted by blanks.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return words;
    line.remove_prefix(first);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::optional<std::int64_t> number(std::string_view word) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  // 32 bits are enough for variables and coordinates, and keep products of them within 64.
  if (value > INT32_MAX || value < INT32_MIN) return std::nullopt;
  return value;
}

/// All words from the second on as numbers.
std::optional<Clause> numbers(const std::vector<std::string_view>& words, std::size_t from) {
  Clause out;
  for (std::size_t i = from; i < words.size(); ++i) {
    const auto value = number(words[i]);
    if (!value) return std::nullopt;
    out.push_back(*value);
  }
  return out;
}

/// Variables: colour c of orbit o is o * colours + c, so 1 to orbits * colours; larger
/// numbers stand for pairs of orbits and get their meaning from the first reason that
/// mentions them.
class Derivation {
 public:
  explicit Derivation(const ColourProblem& problem) : p_(problem) {}

  /// Empty: every clause holds. The formula is split into lines here and into clauses by
  /// CnfReader for the DRAT check. The two readings must agree on what the clauses are,
  /// hence the demand for a clause on a line of its own.
  std::string derive(std::string_view cnf) {
    while (!cnf.empty()) {
      const std::size_t end = std::min(cnf.find('\n'), cnf.size());
      const auto words = words_of(cnf.substr(0, end));
      cnf.remove_prefix(std::min(end + 1, cnf.size()));
      if (words.empty() || words[0] == "p") continue;
      // A reason holds until the next one, for all clauses that follow it.
      if (words[0] == "c") {
        reason_.assign(words.begin() + 1, words.end());
        continue;
      }
      auto clause = numbers(words, 0);
      if (!clause || clause->empty() || clause->back() != 0) {
        return fmt::format("clause {} is not on a line of its own", clauses_ + 1);
      }
      clause->pop_back();
      // A formula's reader ends a clause at every 0: one more would make two of this.
      if (contains(*clause, 0)) return fmt::format("clause {} has a 0 within", clauses_ + 1);
      ++clauses_;
      if (!holds(*clause)) {
        return fmt::format("clause {} does not follow from its reason '{}'", clauses_,
                           fmt::join(reason_, " "));
      }
    }
    return {};
  }
  std::uint64_t clashes() const { return clashes_; }

 private:
  std::int64_t has(std::int64_t orbit, int colour) const { return orbit * p_.colours + colour; }
  bool is_orbit(std::int64_t o) const {
    return o >= 0 && o < static_cast<std::int64_t>(p_.orbits.size());
  }
  const ColourProblem::Orbit& orbit(std::int64_t o) const {
    return p_.orbits[static_cast<std::size_t>(o)];
  }
  bool may_have(std::int64_t o, int colour) const {
    const auto& allowed = orbit(o).allowed;
    return !allowed || std::find(allowed->begin(), allowed->end(), colour) != allowed->end();
  }
  static bool contains(const Clause& clause, std::int64_t literal) {
    return std::find(clause.begin(), clause.end(), literal) != clause.end();
  }

  // An unknown kind of reason justifies nothing; the formats stand in
  // synthesis/proof_files.h.
  bool holds(const Clause& clause) {
    if (reason_.empty()) return false;
    const std::string_view kind = reason_[0];
    const auto a = numbers(reason_, 1);
    if (!a) return false;
    if (kind == "colour") return a->size() == 1 && colour_holds(clause, (*a)[0]);
    if (kind == "one") return a->size() == 1 && one_holds(clause, (*a)[0]);
    if (kind == "domain") return a->size() == 1 && domain_holds(clause, (*a)[0]);
    if (kind == "naming") return a->size() == 2 && naming_holds(clause, (*a)[0], (*a)[1]);
    if (kind == "pair") return a->size() == 3 && pair_holds(clause, (*a)[0], (*a)[1], (*a)[2]);
    if (kind == "A" || kind == "B") {
      ++clashes_;
      return a->size() == 10 && clash_holds(clause, kind == "B", *a);
    }
    return false;
  }

  // Every cell has some colour: holds if the clause contains all colours that it may have.
  bool colour_holds(const Clause& clause, std::int64_t o) const {
    if (!is_orbit(o)) return false;
    for (int c = 1; c <= p_.colours; ++c) {
      if (may_have(o, c) && !contains(clause, has(o, c))) return false;
    }
    return true;
  }
  // No cell has two colours: two different literals, both negative, both of this orbit.
  bool one_holds(const Clause& clause, std::int64_t o) const {
    if (!is_orbit(o) || clause.size() != 2 || clause[0] == clause[1]) return false;
    return std::all_of(clause.begin(), clause.end(), [&](std::int64_t literal) {
      return -literal >= has(o, 1) && -literal <= has(o, p_.colours);
    });
  }
  // A colour that the target excludes at this orbit.
  bool domain_holds(const Clause& clause, std::int64_t o) const {
    if (!is_orbit(o)) return false;
    for (int c = 1; c <= p_.colours; ++c) {
      if (!may_have(o, c) && contains(clause, -has(o, c))) return true;
    }
    return false;
  }
  /// Colours beyond the named ones can be exchanged: the list's orbits take them in turn.
  /// The k-th listed orbit needs none but the named colours and the first k others: colours
  /// beyond are interchangeable, and numbering them by first occurrence along the list
  /// loses no colouring up to renaming. For that the list must be one list: a place has one
  /// orbit and an orbit one place.
  bool naming_holds(const Clause& clause, std::int64_t place, std::int64_t o) {
    // The bound on `place` only keeps the sum below from overflowing.
    if (!is_orbit(o) || place < 1 || place > 1'000'000 || orbit(o).allowed) return false;
    const auto [at, fresh] = named_.try_emplace(place, o);
    if (at->second != o || (fresh && !listed_.insert(o).second)) return false;
    for (std::int64_t c = p_.named + place + 1; c <= p_.colours; ++c) {
      if (contains(clause, -has(o, static_cast<int>(c)))) return true;
    }
    return false;
  }
  /// A variable of its own is, by definition, true when two orbits have one colour. Each
  /// new variable is bound to one pair. Both directions of the equivalence may be clauses,
  /// and any of them holds by definition of the variable, however the colouring is chosen.
  bool pair_holds(const Clause& clause, std::int64_t p, std::int64_t a, std::int64_t b) {
    if (!is_orbit(a) || !is_orbit(b) || a == b) return false;
    if (p <= has(static_cast<std::int64_t>(p_.orbits.size()) - 1, p_.colours)) return false;
    const auto pair = std::minmax({a, b});
    const auto [at, fresh] = pairs_.try_emplace(p, pair);
    if (at->second != pair) return false;
    for (int c = 1; c <= p_.colours; ++c) {
      const std::int64_t x = has(a, c), y = has(b, c);
      if (contains(clause, p) && contains(clause, -x) && contains(clause, -y)) return true;
      if (contains(clause, -p) && contains(clause, -x) && contains(clause, y)) return true;
      if (contains(clause, -p) && contains(clause, x) && contains(clause, -y)) return true;
    }
    return false;
  }

  static std::optional<Cell> cell_at(const Clause& a, std::size_t i) {
    for (std::size_t k = i; k < i + 3; ++k) {
      if (a[k] < -kMaxCoordinate || a[k] > kMaxCoordinate) return std::nullopt;
    }
    return Cell{static_cast<std::int32_t>(a[i]), static_cast<std::int32_t>(a[i + 1]),
                static_cast<std::int32_t>(a[i + 2])};
  }

  /// Q at a cell, orientation G, S at a cell, M: see proof_files.h. Kind A: the site must
  /// not be filled at all in this structure. Kind B (`intended`): it is due there, so the
  /// rule may act, but with the site's own colour.
  bool clash_holds(const Clause& clause, bool intended, const Clause& a) const {
    const auto from = cell_at(a, 1), to = cell_at(a, 6);
    if (!from || !to || a[4] < 0 || a[4] >= static_cast<std::int64_t>(p_.group.size()))
      return false;
    const auto key_cell = p_.cell(*from);
    if (!key_cell || p_.orbit_of[*key_cell] != a[0] || p_.in_start(*key_cell)) return false;
    const auto site = p_.cell(*to);
    // -1 stands for a site outside the target.
    if ((site ? static_cast<std::int64_t>(p_.orbit_of[*site]) : -1) != a[5]) return false;
    // A site of the start is never empty, and one below the floor is no site.
    if (site ? p_.in_start(*site) : p_.floor && to->z < 0) return false;
    if (a[9] <= 0) return false;  // beside no brick no rule acts
    const auto state = static_cast<std::uint32_t>(a[9]);
    const Orientation& g = p_.group[static_cast<std::size_t>(a[4])];
    // The conjunction is the claim: the rule of `from` looks for this set, both structures
    // are reachable, the floor shows the same, and the clause says that some compared pair
    // differs.
    return is_key(*key_cell, turned_back(state, g)) && p_.reachable(*to, state) &&
           same_floor(*from, *to, g) && is_intended(site, state) == intended &&
           compares_all(clause, *from, *to, g, state, intended ? site : std::nullopt);
  }

  // The image under g of neighbour i is seen at index g.image[i]: the set at the site is
  // taken back to the orientation in which the rule was written.
  std::uint32_t turned_back(std::uint32_t state, const Orientation& g) const {
    std::uint32_t key = 0;
    for (int i = 0; i < p_.neighbours().size; ++i) {
      if ((state >> g.image[static_cast<std::size_t>(i)] & 1U) != 0) key |= std::uint32_t{1} << i;
    }
    return key;
  }
  /// A rule looks for this: all of lower rank, some of equal, and it can come to that.
  bool is_key(std::uint32_t cell, std::uint32_t key) const {
    const std::uint32_t before = p_.before(cell);
    return (key & before) == before && p_.reachable(p_.cells[cell], key);
  }
  bool is_intended(std::optional<std::uint32_t> site, std::uint32_t state) const {
    if (!site) return false;
    const std::uint32_t before = p_.before(*site);
    return (state & before) == before;
  }
  // The floor is visible to rules. If the two neighbourhoods differ in where floor is, the
  // rule does not match, whatever the colours.
  bool same_floor(Cell from, Cell to, const Orientation& g) const {
    if (!p_.floor) return true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(p_.neighbours().size); ++i) {
      const Offset there = p_.neighbours().offsets[static_cast<std::size_t>(g.image[i])];
      const bool here_floor = from.z + p_.neighbours().offsets[i].z < 0;
      if (here_floor != (to.z + there.z < 0)) return false;
    }
    return true;
  }

  /// Every pair of cells that the rule compares is in the clause as "differs"; more would
  /// only weaken it. Under B the clause also says that the two sites are equal: colours under
  /// which they look alike are none of a clash if they are.
  bool compares_all(const Clause& clause, Cell from, Cell to, const Orientation& g,
                    std::uint32_t state, std::optional<std::uint32_t> same_site) const {
    const auto pair_of = [&](Cell x, Cell y) {
      const std::int64_t a = p_.orbit_of[*p_.cell(x)], b = p_.orbit_of[*p_.cell(y)];
      return std::pair(std::min(a, b), std::max(a, b));
    };
    std::set<std::pair<std::int64_t, std::int64_t>> differ;
    bool equal = false;
    for (const std::int64_t literal : clause) {
      const auto found = pairs_.find(literal < 0 ? -literal : literal);
      // A literal that is no known pair could make the clause mean anything; with it,
      // nothing is derived.
      if (found == pairs_.end()) return false;
      if (literal < 0) {
        differ.insert(found->second);
      } else if (same_site && found->second == pair_of(from, to)) {
        equal = true;
      } else {
        return false;
      }
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(p_.neighbours().size); ++i) {
      const auto image = static_cast<std::size_t>(g.image[i]);
      // Only bricks are compared; cells empty in one are empty in the other since the sets
      // correspond.
      if ((state >> image & 1U) == 0) continue;
      const auto pair =
          pair_of(from + p_.neighbours().offsets[i], to + p_.neighbours().offsets[image]);
      // Cells of one orbit have one colour, so the rule cannot tell them apart, and no
      // literal is needed.
      if (pair.first != pair.second && !differ.contains(pair)) return false;
    }
    // Never so for sites of one orbit, which do not clash: a pair has two.
    return !same_site || equal;
  }

  const ColourProblem& p_;
  std::vector<std::string_view> reason_;
  std::map<std::int64_t, std::int64_t> named_;  ///< place in the list -> orbit
  std::set<std::int64_t> listed_;
  std::map<std::int64_t, std::pair<std::int64_t, std::int64_t>> pairs_;  ///< by variable
  std::uint64_t clauses_ = 0, clashes_ = 0;
};

}  // namespace

/// The report's counts describe the problem even if a clause fails, so that messages can
/// say what was looked at.
FewestReport derive_formula(std::string_view problem, std::string_view cnf) {
  FewestReport report;
  const auto read = read_colour_problem(problem, report.refusal);
  if (!read) return report;
  report.cells = read->cells.size();
  report.colours = read->colours;
  report.order = read->order;
  Derivation derivation(*read);
  report.refusal = derivation.derive(cnf);
  report.clashes = derivation.clashes();
  report.derived = report.refusal.empty();
  return report;
}

}  // namespace stig::certify
