// SPDX-License-Identifier: MIT
// Symbols and drawn structures. Diagnostics go on after an error wherever the rest can
// still be read: a drawing with one unknown symbol is no drawing, but its other symbols are
// looked at, so that all errors are reported at once. Drawings of neighbourhoods are read
// by pattern_reader.cpp.
#include "rules/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/text.h"
#include "rules/drawing_rows.h"
#include "rules/rule_schema.h"

namespace stig::rules {

namespace {

/// In ASCII. Case is a frequent slip in symbols, hence a suggestion of its own before the
/// edit distance.
bool same_but_for_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

using Slice = std::vector<const DrawnRow*>;

/// Rows between lines of ---, from the top slice down. Slices are counted from above, as
/// they are drawn.
std::vector<Slice> slices_of(const std::vector<DrawnRow>& rows) {
  std::vector<Slice> slices(1);
  for (const DrawnRow& row : rows) {
    if (row.tokens.size() == 1 && row.tokens[0].text == "---") {
      slices.emplace_back();
    } else {
      slices.back().push_back(&row);
    }
  }
  return slices;
}

/// All slices alike? Reports the first row or slice that differs. One report is enough:
/// rows and slices of different lengths usually have one cause.
bool check_structure_shape(const YamlTextMap& places, const std::vector<Slice>& slices,
                           DrawingContext& context) {
  const auto fail = [&](std::size_t begin, std::size_t end, std::string message) {
    context.diagnostics.add(Code::R207, places.range(begin, end), std::move(message));
    return false;
  };
  if (slices[0].empty()) return fail(0, 0, "the first slice of the structure has no rows");
  const std::size_t rows = slices[0].size();
  const std::size_t columns = slices[0][0]->tokens.size();
  const DrawnRow* last = slices[0][0];
  for (const Slice& slice : slices) {
    // Where a slice is empty, the last row before it is the nearest place to point at.
    if (!slice.empty()) last = slice[0];
    if (slice.size() != rows) {
      return fail(
          last->begin, last->end,
          fmt::format("a slice here has {} rows, the first one has {}", slice.size(), rows));
    }
    for (const DrawnRow* row : slice) {
      if (row->tokens.size() == columns) continue;
      return fail(row->begin, row->end,
                  fmt::format("this row has {} symbols, the first one has {}", row->tokens.size(),
                              columns));
    }
    last = slice.back();
  }
  return true;
}

/// An expected structure is compared up to translation, so its place in the drawing means
/// nothing.
void move_to_origin(std::vector<PlacedBrick>& bricks) {
  assert(!bricks.empty());
  Cell low = bricks.front().at;
  for (const PlacedBrick& b : bricks) {
    low = {std::min(low.x, b.at.x), std::min(low.y, b.at.y), std::min(low.z, b.at.z)};
  }
  for (PlacedBrick& b : bricks) b.at = Cell{} + (b.at - low);
  std::sort(bricks.begin(), bricks.end());
}

}  // namespace

bool SymbolTable::add(const std::string& symbol, Entry entry) {
  if (!entries_.emplace(symbol, entry).second) return false;
  order_.push_back(symbol);
  return true;
}

const SymbolTable::Entry* SymbolTable::find(const std::string& symbol) const {
  const auto found = entries_.find(symbol);
  return found == entries_.end() ? nullptr : &found->second;
}

/// The four symbols with a meaning of their own; bricks and legend entries cannot take
/// them.
std::optional<StateSet> SymbolTable::states(const std::string& symbol) {
  if (symbol == ".") return StateSet::empty_cell();
  if (symbol == "?") return StateSet::anything();
  if (symbol == "#") return StateSet::bricks(colours_);
  if (symbol == "=") return StateSet::floor();
  const auto found = entries_.find(symbol);
  if (found == entries_.end()) return std::nullopt;
  // Marked here, since this is where every use of a symbol passes; unused legend entries
  // are warned of.
  found->second.used = true;
  return found->second.states;
}

std::string SymbolTable::symbol_named(const std::string& name) const {
  const auto found = names_.find(name);
  return found == names_.end() ? std::string() : found->second;
}

std::string SymbolTable::nearest_to(std::string_view word, bool bricks_only) const {
  // What people draw for a cell with nothing in it.
  if (!bricks_only && (word == "0" || word == "_" || word == "-")) return ".";
  std::vector<std::string_view> candidates;
  for (const std::string& symbol : order_) {
    if (bricks_only && entries_.at(symbol).colour == 0) continue;
    if (same_but_for_case(word, symbol)) return symbol;
    candidates.push_back(symbol);
    if (candidates.size() == 200) break;  // thousands of symbols would take their time
  }
  return std::string(nearest(word, candidates));
}

void report_unknown(const SourceRange& range, const std::string& symbol, bool bricks_only,
                    DrawingContext& context) {
  const std::string meant = context.symbols.symbol_named(symbol);
  // In a structure only bricks can stand; a legend entry stands for a set of states.
  const bool legend = bricks_only && context.symbols.find(symbol) != nullptr;
  std::string message = fmt::format("unknown brick {}", in_quotes(symbol));
  if (legend || is_reserved_symbol(symbol)) {
    message = fmt::format("{} is no brick", in_quotes(symbol));
  } else if (!meant.empty()) {
    message = fmt::format("{} is a brick's name, where its symbol is wanted", in_quotes(symbol));
  }
  Diagnostic& diagnostic = context.diagnostics.add(Code::R204, range, message);
  if (context.diagnostics.full()) return;
  diagnostic.suggest(meant.empty() ? context.symbols.nearest_to(symbol, bricks_only) : meant);
  // "..." for ". . .": all characters are symbols by themselves.
  const bool run_together =
      symbol.size() > 1 && std::all_of(symbol.begin(), symbol.end(), [&](char c) {
        const std::string one(1, c);
        return is_reserved_symbol(one) || context.symbols.find(one) != nullptr;
      });
  if (run_together && !bricks_only) diagnostic.note("symbols in a drawing are parted by spaces");
}

std::optional<std::vector<PlacedBrick>> read_structure(const YamlNode& node,
                                                       DrawingContext& context) {
  const std::vector<DrawnRow> rows = split_rows(node.text);
  const std::vector<Slice> slices = slices_of(rows);
  const YamlTextMap places(context.document, node);
  bool sound = check_structure_shape(places, slices, context);
  std::vector<PlacedBrick> bricks;
  for (std::size_t s = 0; s < slices.size(); ++s) {
    // Slices fall in z, rows in y, as in all drawings.
    const auto z = static_cast<std::int32_t>(slices.size() - 1 - s);
    for (std::size_t r = 0; r < slices[s].size(); ++r) {
      const auto y = static_cast<std::int32_t>(slices[s].size() - 1 - r);
      std::int32_t x = -1;
      for (const DrawnSymbol& token : slices[s][r]->tokens) {
        ++x;
        if (token.text == ".") continue;
        const SymbolTable::Entry* entry = context.symbols.find(token.text);
        if (entry != nullptr && entry->colour != 0) {
          bricks.push_back({{x, y, z}, entry->colour});
          continue;
        }
        const std::size_t end = token.begin + token.text.size();
        report_unknown(places.range(token.begin, end), token.text, true, context);
        sound = false;
      }
    }
  }
  if (!sound) return std::nullopt;
  if (bricks.empty()) {
    context.diagnostics.add(Code::R207, context.document.head(node), "the structure has no brick");
    return std::nullopt;
  }
  move_to_origin(bricks);
  return bricks;
}

}  // namespace stig::rules
