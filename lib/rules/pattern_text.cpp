// SPDX-License-Identifier: MIT
// Drawings as text, the inverse of the readers. All columns have the width of the widest
// symbol, in code points, so that drawings line up in any editor with a fixed font;
// trailing spaces are cut, which keeps files stable under editors that do so.
#include "rules/pattern_text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>

#include "base/text.h"
#include "rules/rule_printer.h"

namespace stig::rules {

namespace {

using Symbols = std::array<std::string, kMaxNeighbours>;

/// Terminals may show some characters wider than one column; code points are what can be
/// counted portably.
std::string padded(const std::string& symbol, std::size_t width) {
  const std::size_t length = count_code_points(symbol);
  return symbol + std::string(width - std::min(width, length), ' ');
}

void trim(std::string& line) { line.erase(line.find_last_not_of(' ') + 1); }

/// Three slices side by side. `symbols` by neighbour index, all padded to one width.
std::string draw(Lattice lattice, const Symbols& symbols) {
  const Neighbourhood& neighbours = neighbourhood(lattice);
  std::size_t width = 1;
  for (const std::string& symbol : symbols) width = std::max(width, count_code_points(symbol));
  const std::size_t slice_width = 3 * width + 2;
  std::string out;
  for (int y = 1; y >= -1; --y) {
    std::string line;
    for (int z = 1; z >= -1; --z) {
      // Hexagonal rows of two are set in by half a cell, that is, half of a symbol and its
      // space, rounded down.
      std::string row((lattice == Lattice::hexagonal && y != 0) ? (width + 1) / 2 : 0, ' ');
      for (int x = -1; x <= 1; ++x) {
        const bool site = x == 0 && y == 0 && z == 0;
        const int index = neighbours.index_of({x, y, z});
        if (index < 0 && !site) continue;
        row += padded(site ? "*" : symbols[static_cast<std::size_t>(index)], width) + " ";
      }
      trim(row);
      // The line is filled up to the next slice by code points as well.
      line += row + std::string(slice_width + 3 - count_code_points(row), ' ');
    }
    trim(line);
    out += line + "\n";
  }
  return out;
}

template <class StateSetAt>
std::string draw_cells(const RuleSet& rules, StateSetAt at) {
  Symbols symbols;
  for (int i = 0; i < neighbourhood(rules.lattice).size; ++i) {
    const auto index = static_cast<std::size_t>(i);
    symbols[index] = symbol_of(rules, at(index));
  }
  return draw(rules.lattice, symbols);
}

}  // namespace

/// Reserved symbols come first: a legend entry that happens to mean "empty" is not used for
/// it. `#` is printed for all bricks, unless there is only one brick, whose own symbol says
/// more.
std::optional<std::string> find_symbol(const RuleSet& rules, StateSet states) {
  if (states == StateSet::anything()) return "?";
  if (states == StateSet::empty_cell()) return ".";
  if (states == StateSet::floor()) return "=";
  if (states.is_single() && states.first() <= rules.colours()) {
    return rules.brick(states.first()).symbol;
  }
  if (states == StateSet::bricks(rules.colours())) return "#";
  for (const LegendEntry& entry : rules.legend) {
    if (entry.states == states) return entry.symbol;
  }
  return std::nullopt;
}

/// For messages: a set without a symbol is written out.
std::string symbol_of(const RuleSet& rules, StateSet states) {
  if (const auto symbol = find_symbol(rules, states)) return *symbol;
  std::string out;
  const auto add = [&](std::string_view text) {
    out += (out.empty() ? "" : ",") + std::string(text);
  };
  if (states.contains(kEmpty)) add(".");
  for (Colour c = 1; c <= rules.colours(); ++c) {
    if (states.contains(c)) add(rules.brick(c).symbol);
  }
  if (states.contains(kFloor)) add("=");
  return "{" + out + "}";
}

std::string draw_pattern(const RuleSet& rules, const Pattern& pattern) {
  return draw_cells(rules, [&](std::size_t i) { return pattern.allowed[i]; });
}

std::string draw_view(const RuleSet& rules, const View& view) {
  return draw_cells(rules, [&](std::size_t i) { return StateSet::of(view.at[i]); });
}

std::string draw_structure(const RuleSet& rules, const std::vector<PlacedBrick>& bricks) {
  assert(!bricks.empty());
  Cell low = bricks.front().at, high = low;
  // A map by cell: expected structures are small, and may be sparse.
  std::map<Cell, Colour> at;
  std::size_t width = 1;
  for (const PlacedBrick& b : bricks) {
    low = {std::min(low.x, b.at.x), std::min(low.y, b.at.y), std::min(low.z, b.at.z)};
    high = {std::max(high.x, b.at.x), std::max(high.y, b.at.y), std::max(high.z, b.at.z)};
    at[b.at] = b.brick;
    width = std::max(width, count_code_points(rules.brick(b.brick).symbol));
  }
  std::string out;
  for (std::int32_t z = high.z; z >= low.z; --z) {
    if (z != high.z) out += "---\n";
    for (std::int32_t y = high.y; y >= low.y; --y) {
      std::string line;
      for (std::int32_t x = low.x; x <= high.x; ++x) {
        const auto found = at.find({x, y, z});
        line += padded(found == at.end() ? "." : rules.brick(found->second).symbol, width) + " ";
      }
      trim(line);
      out += line + "\n";
    }
  }
  return out;
}

}  // namespace stig::rules
