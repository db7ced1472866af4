// SPDX-License-Identifier: MIT
// A rule set as its author wrote it: symbolic, with source ranges. RuleTable
// (rule_table.h) is the compiled form that worlds run on; neither turns into the
// other in place.
//
// A site where a rule of it matches (rule.h) is an event; agents only choose the order of
// events. See docs/language.md for the file form.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/source.h"
#include "rules/cell.h"
#include "rules/key_field.h"
#include "rules/neighbourhood.h"
#include "rules/rule.h"
#include "rules/symmetry.h"

namespace stig::rules {

struct Brick {
  std::string symbol;  ///< what drawings use
  std::string name;
  std::string color;  ///< "#rrggbb"
  std::string led;    ///< "Q1".."Q62" (base/led_name.h) or empty
  SourceRange range;
};

/// A symbol of the drawings that stands for a set of states.
struct LegendEntry {
  std::string symbol;
  StateSet states;
  SourceRange range;
};

struct PlacedBrick {
  Cell at;
  Colour brick = 0;
  auto operator<=>(const PlacedBrick&) const = default;
};

enum class Conflicts : std::uint8_t { error, random, first };
enum class Verdict : std::uint8_t { coordinated, order_dependent, endless };

/// A bounded world, as far as the file fixes it. Without an origin the box is
/// laid around the start (see lattice/box.h).
struct BoxSpec {
  Offset size;                 ///< cells along x, y, z; each >= 1
  std::optional<Cell> origin;  ///< lowest cell
  bool periodic = false;
  bool operator==(const BoxSpec&) const = default;
};

/// What is assumed of robots; used by compile and validate alone.
struct PhysicalSpec {
  std::vector<std::string> sides;  ///< "+x" "-x" "+y" "-y"; empty: from all
  std::optional<int> robots;
};

/// What the author says the set builds; `stigc test` holds the file to it.
struct Expectation {
  std::optional<std::int64_t> bricks;  ///< in the end, the start included
  std::optional<Verdict> verdict;
  std::vector<PlacedBrick> structure;  ///< modulo translation; empty: not said
  SourceRange range, bricks_range, verdict_range, structure_range;
};

/// A comment of the file, kept so that `fmt` does not lose it: it is printed before
/// (or, if trailing, behind) the element it was written before (or behind).
struct Comment {
  std::string element;  ///< "bricks/1", "rules/3/when", …; empty: the end of the file
  bool trailing = false;
  std::string text;  ///< from the '#'
};

/// Where those parts of a file stand that have no range of their own.
struct Places {
  SourceRange start, inversion, conflicts;
  std::vector<SourceRange> start_bricks;  ///< beside RuleSet::start
  std::map<int, SourceRange> stages;
};

struct RuleSet {
  std::string name, title, source;
  Lattice lattice = Lattice::cubic;
  Symmetry symmetry = Symmetry::none;
  bool inversion = false;
  bool floor = false;
  Conflicts conflicts = Conflicts::error;
  std::vector<Brick> bricks;  ///< colour k is bricks[k - 1]
  std::vector<LegendEntry> legend;
  std::vector<PlacedBrick> start;
  std::vector<Rule> rules;
  std::map<int, std::int64_t> stages;  ///< stage -> deposits after which the next begins
  std::optional<BoxSpec> box;
  std::optional<PhysicalSpec> physical;
  std::optional<Expectation> expect;

  SourceRef file;
  Places places;
  std::vector<Comment> comments;

  int colours() const { return static_cast<int>(bricks.size()); }
  const Brick& brick(Colour colour) const { return bricks[colour - 1U]; }
  /// 0 when the symbol is no brick's.
  Colour colour_of(std::string_view symbol) const;
  /// The highest kind that a brick's `led` names (base/led_name.h), 0 where none does.
  int highest_kind() const;
  /// Highest stage any rule names; 1 for a set without stages.
  int stage_count() const;
  Symmetry symmetry_of(const Rule& rule) const { return rule.symmetry.value_or(symmetry); }
  bool inversion_of(const Rule& rule) const { return rule.inversion.value_or(inversion); }
};

template <SameButConst<Brick> B>
auto fields(B& brick) {
  auto& [symbol, name, color, led, range] = brick;
  return std::tuple(KeyField{"", symbol}, KeyField{"name", name, Hashed::never},
                    KeyField{"color", color, Hashed::never}, KeyField{"led", led});
}

template <SameButConst<LegendEntry> E>
auto fields(E& entry) {
  auto& [symbol, states, range] = entry;
  return std::tuple(KeyField{"", symbol}, KeyField{"", states});
}

template <SameButConst<PlacedBrick> B>
auto fields(B& placed) {
  auto& [at, brick] = placed;
  return std::tuple(KeyField{"at", at}, KeyField{"brick", brick});
}

template <SameButConst<BoxSpec> B>
auto fields(B& box) {
  auto& [size, origin, periodic] = box;
  return std::tuple(KeyField{"size", size}, KeyField{"origin", origin},
                    KeyField{"periodic", periodic});
}

template <SameButConst<PhysicalSpec> P>
auto fields(P& physical) {
  auto& [sides, robots] = physical;
  return std::tuple(KeyField{"sides", sides}, KeyField{"robots", robots});
}

template <SameButConst<Expectation> E>
auto fields(E& expect) {
  auto& [bricks, verdict, structure, range, bricks_range, verdict_range, structure_range] = expect;
  return std::tuple(KeyField{"bricks", bricks}, KeyField{"verdict", verdict},
                    KeyField{"structure", structure});
}

template <SameButConst<RuleSet> S>
auto fields(S& set) {
  auto& [name, title, source, lattice, symmetry, inversion, floor, conflicts, bricks, legend, start,
         rules, stages, box, physical, expect, file, places, comments] = set;
  // The order is that of the hash. The legend only names sets that the drawings hold.
  return std::tuple(KeyField{"name", name, Hashed::never}, KeyField{"title", title, Hashed::never},
                    KeyField{"source", source, Hashed::never}, KeyField{"lattice", lattice},
                    KeyField{"symmetry", symmetry}, KeyField{"inversion", inversion},
                    KeyField{"floor", floor}, KeyField{"conflicts", conflicts},
                    KeyField{"bricks", bricks}, KeyField{"legend", legend, Hashed::never},
                    KeyField{"start", start}, KeyField{"rules", rules}, KeyField{"stages", stages},
                    KeyField{"box", box}, KeyField{"physical", physical, Hashed::never},
                    KeyField{"expect", expect, Hashed::never});
}

/// Same meaning and words; source ranges and comments do not count.
bool operator==(const RuleSet& a, const RuleSet& b);

std::string_view to_string(Conflicts conflicts);
std::string_view to_string(Verdict verdict);  ///< "order-dependent"

}  // namespace stig::rules
