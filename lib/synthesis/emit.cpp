// SPDX-License-Identifier: MIT
// Turns patterns and colours into a rule set as a person would write it: bricks get symbols
// that line up in drawings, and rules get names that say what they look for. The expected
// structure and the verdict are written too, so that `stigc check` and `stigc verify` can
// compare.
#include "synthesis/emit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <set>

#include "lattice/rgb.h"
#include "lattice/structure.h"
#include "rules/rule_printer.h"

namespace stig::synthesis {
namespace {

/// One character a colour: drawings stay in line.
constexpr std::string_view kSymbols =
    "123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0";
static_assert(kSymbols.size() == kMaxColours);

/// A symbol that no brick has yet.
std::string free_symbol(const std::vector<Brick>& bricks) {
  for (const char c : kSymbols) {
    const std::string symbol(1, c);
    const auto same = [&](const Brick& brick) { return brick.symbol == symbol; };
    if (std::none_of(bricks.begin(), bricks.end(), same)) return symbol;
  }
  return std::to_string(bricks.size() + 1);
}

/// A palette colour that no brick has yet.
std::string free_colour(const std::vector<Brick>& bricks) {
  for (const Brick& candidate : numbered_bricks(kMaxColours)) {
    const auto same = [&](const Brick& brick) { return brick.color == candidate.color; };
    if (std::none_of(bricks.begin(), bricks.end(), same)) return candidate.color;
  }
  return "#808080";
}

std::vector<Brick> complete(std::vector<Brick> bricks, int count) {
  const bool all_ours = bricks.empty();
  while (static_cast<int>(bricks.size()) < count) {
    Brick brick;
    brick.symbol = free_symbol(bricks);
    brick.color = free_colour(bricks);
    brick.name = brick.symbol;
    // Up to four colours are what the LEDs of the blocks can show.
    if (all_ours && count <= 4) brick.led = brick.name = "Q" + brick.symbol;
    bricks.push_back(brick);
  }
  // The target's bricks come from another file, so their places in it mean nothing here.
  for (Brick& brick : bricks) brick.range = {};
  return bricks;
}

/// The bricks asked for in some cells: "3", "2 and 3", "a brick"; empty when none is.
std::string bricks_among(const RuleSet& set, const Pattern& pattern,
                         const std::vector<std::size_t>& cells) {
  std::map<std::string, int> seen;
  for (const std::size_t i : cells) {
    const StateSet states = pattern.allowed[i];
    if (states.contains(kEmpty) || states.contains(kFloor)) continue;
    ++seen[states.is_single() ? symbol_of(set, states) : "a brick"];
  }
  std::vector<std::string> parts;
  for (const auto& [what, times] : seen) {
    parts.push_back(times == 1 ? what
                               : fmt::format("{} {}", times, what == "a brick" ? "bricks" : what));
  }
  return fmt::format("{}", fmt::join(parts, " and "));
}

struct Around {
  std::vector<std::size_t> below, beside, above, behind;
};

Around around_of(const Neighbourhood& n) {
  Around places;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    const Offset o = n.offsets[i];
    if (!n.is_face[i]) {
      places.behind.push_back(i);
    } else if (o.z != 0) {
      (o.z < 0 ? places.below : places.above).push_back(i);
    } else {
      places.beside.push_back(i);
    }
  }
  return places;
}

bool asks_for_floor(const Pattern& pattern, const Neighbourhood& n) {
  for (int i = n.first_below; i < n.size; ++i) {
    if (pattern.allowed[static_cast<std::size_t>(i)] == StateSet::floor()) return true;
  }
  return false;
}

}  // namespace

std::string name_of(const RuleSet& set, const MergedRule& rule) {
  const Neighbourhood& n = neighbourhood(set.lattice);
  const Around places = around_of(n);
  std::string name = "place " + symbol_of(set, StateSet::of(rule.place));
  const auto add = [&](const char* word, const std::vector<std::size_t>& cells) {
    const std::string what = bricks_among(set, rule.pattern, cells);
    if (!what.empty()) name += fmt::format(" {} {}", word, what);
  };
  // The words of a name: bricks below are "on", at the sides "beside", above "under"; edges
  // and corners only when nothing else is asked for.
  const std::size_t bare = name.size();
  add("on", places.below);
  add("beside", places.beside);
  add("under", places.above);
  if (name.size() == bare) add("near", places.behind);
  if (asks_for_floor(rule.pattern, n)) name += " on the floor";
  return name;
}

RuleSet make_rule_set(const Frame& frame, const Colouring& colours, int colour_count,
                      const std::vector<Brick>& bricks, const std::vector<MergedRule>& rules,
                      const Wording& wording) {
  assert(colour_count > 0 && colours.size() == frame.orbits.size());
  RuleSet set;
  set.name = wording.name;
  set.title = wording.title;
  set.source = wording.source;
  set.lattice = frame.lattice;
  set.symmetry = frame.symmetry;
  set.floor = frame.floor;
  set.bricks = complete(bricks, colour_count);
  Expectation expect;
  expect.bricks = static_cast<std::int64_t>(frame.cells.size());
  expect.verdict = Verdict::coordinated;
  for (std::size_t i = 0; i < frame.cells.size(); ++i) {
    const auto orbit = static_cast<std::size_t>(frame.orbit_of[i]);
    expect.structure.push_back({frame.cells[i], colours[orbit]});
    if (frame.orbits[orbit].start) set.start.push_back({frame.cells[i], colours[orbit]});
  }
  // Files list a structure from the origin, whatever cells the target had.
  expect.structure = to_origin(Structure(frame.lattice, expect.structure)).bricks();
  set.expect = expect;
  std::map<std::string, int> times;
  for (const MergedRule& merged : rules) {
    Rule rule;
    rule.place = merged.place;
    rule.pattern = merged.pattern;
    rule.height_min = merged.height_min;
    rule.height_max = merged.height_max;
    rule.name = name_of(set, merged);
    // Names must be unique; repetitions are counted.
    if (const int n = ++times[rule.name]; n > 1) rule.name += fmt::format(" ({})", n);
    set.rules.push_back(std::move(rule));
  }
  return set;
}

}  // namespace stig::synthesis
