// SPDX-License-Identifier: MIT
#include "rules/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text.h"
#include "rules/rule_schema.h"

namespace stig {

namespace {

struct Token {
  std::string text;
  std::size_t begin = 0;  ///< in the scalar's text
};

/// A line that is not blank.
struct Row {
  std::vector<Token> tokens;
  std::size_t begin = 0, end = 0;
};

std::vector<Row> split(std::string_view text) {
  static constexpr std::string_view kSpace = " \t\r\n";
  std::vector<Row> rows;
  bool new_row = true;
  for (std::size_t i = 0; i < text.size();) {
    if (kSpace.find(text[i]) != kSpace.npos) {
      new_row = new_row || text[i] == '\n';
      ++i;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(kSpace, i), text.size());
    if (new_row) rows.push_back({{}, i, end});
    new_row = false;
    rows.back().tokens.push_back({std::string(text.substr(i, end - i)), i});
    rows.back().end = end;
    i = end;
  }
  return rows;
}

/// Reads one neighbourhood; collects errors and goes on.
class PatternReader {
 public:
  PatternReader(const YamlNode& node, bool inversion, DrawingContext& context)
      : node_(node),
        inversion_(inversion),
        context_(context),
        neighbours_(neighbourhood(context.lattice)),
        rows_(split(node.text)),
        places_(context.document, node) {}

  std::optional<Pattern> read() {
    if (rows_.size() != 3) {
      const bool more = rows_.size() > 3;
      const SourceRange where =
          more ? places_.range(rows_[3].begin, rows_[3].end) : context_.document.head(node_);
      fail(Code::R201, where, fmt::format("a drawing has 3 rows, this one has {}", rows_.size()));
    }
    for (std::size_t row = 0; row < rows_.size(); ++row) read_row(row);
    return sound_ ? std::optional(pattern_) : std::nullopt;
  }

 private:
  SourceRange range(const Token& token) const {
    return places_.range(token.begin, token.begin + token.text.size());
  }
  Diagnostic& fail(Code code, const SourceRange& where, std::string message) {
    sound_ = false;
    return context_.diagnostics.add(code, where, std::move(message));
  }

  /// Cells of row 0, 1, 2 in one slice.
  std::size_t width(std::size_t row) const {
    return context_.lattice == Lattice::hexagonal && row != 1 ? 2 : 3;
  }
  Offset offset_of(std::size_t row, std::size_t column) const {
    const std::size_t slice = column / width(row);
    const int y = 1 - static_cast<int>(row);
    // The lower row of a hexagonal slice starts one further along x.
    const int first = context_.lattice == Lattice::hexagonal && row == 2 ? 0 : -1;
    return {first + static_cast<int>(column % width(row)), y, 1 - static_cast<int>(slice)};
  }

  void read_row(std::size_t number) {
    const Row& row = rows_[number];
    const bool shaped = rows_.size() == 3 && row.tokens.size() == 3 * width(number);
    if (rows_.size() == 3 && !shaped) {
      fail(Code::R201, places_.range(row.begin, row.end),
           fmt::format("this row of a {} drawing has {} symbols, not {}: three slices of {}",
                       to_string(context_.lattice), row.tokens.size(), 3 * width(number),
                       width(number)));
    }
    for (std::size_t column = 0; column < row.tokens.size(); ++column) {
      const Token& token = row.tokens[column];
      if (shaped) {
        read_cell(token, offset_of(number, column));
      } else if (token.text != "*") {
        states_of(token);
      }
    }
  }

  void read_cell(const Token& token, Offset offset) {
    if (offset == Offset{}) {
      if (token.text == "*") return;
      fail(Code::R202, range(token),
           fmt::format("the site is drawn as '*' here, not as {}", in_quotes(token.text)));
      return;
    }
    if (token.text == "*") {
      fail(Code::R203, range(token), "'*' is the site, the middle of the level slice");
      return;
    }
    const std::optional<StateSet> states = states_of(token);
    if (token.text == "=") check_floor(token, offset);
    const auto index = static_cast<std::size_t>(neighbours_.index_of(offset));
    if (states) pattern_.allowed[index] = *states;
  }

  std::optional<StateSet> states_of(const Token& token) {
    const std::optional<StateSet> states = context_.symbols.states(token.text);
    if (!states) {
      sound_ = false;
      report_unknown(range(token), token.text, false, context_);
    }
    return states;
  }

  void check_floor(const Token& token, Offset offset) {
    if (!context_.floor) {
      fail(Code::R205, range(token), "'=' never matches in a set without `floor: true`");
    } else if (offset.z == 0 || (offset.z > 0 && !inversion_)) {
      fail(Code::R205, range(token),
           fmt::format("'=' never matches {} the site: the floor is below it",
                       offset.z == 0 ? "beside" : "above"));
    }
  }

  const YamlNode& node_;
  bool inversion_;
  DrawingContext& context_;
  const Neighbourhood& neighbours_;
  std::vector<Row> rows_;
  YamlTextMap places_;
  Pattern pattern_;
  bool sound_ = true;
};

using Slice = std::vector<const Row*>;

/// Rows between lines of ---, from the top slice down.
std::vector<Slice> slices_of(const std::vector<Row>& rows) {
  std::vector<Slice> slices(1);
  for (const Row& row : rows) {
    if (row.tokens.size() == 1 && row.tokens[0].text == "---") {
      slices.emplace_back();
    } else {
      slices.back().push_back(&row);
    }
  }
  return slices;
}

/// All slices alike? Reports the first row or slice that differs.
bool check_structure_shape(const YamlTextMap& places, const std::vector<Slice>& slices,
                           DrawingContext& context) {
  const auto fail = [&](std::size_t begin, std::size_t end, std::string message) {
    context.diagnostics.add(Code::R207, places.range(begin, end), std::move(message));
    return false;
  };
  if (slices[0].empty()) return fail(0, 0, "the first slice of the structure has no rows");
  const std::size_t rows = slices[0].size();
  const std::size_t columns = slices[0][0]->tokens.size();
  const Row* last = slices[0][0];
  for (const Slice& slice : slices) {
    if (!slice.empty()) last = slice[0];
    if (slice.size() != rows) {
      return fail(
          last->begin, last->end,
          fmt::format("a slice here has {} rows, the first one has {}", slice.size(), rows));
    }
    for (const Row* row : slice) {
      if (row->tokens.size() == columns) continue;
      return fail(row->begin, row->end,
                  fmt::format("this row has {} symbols, the first one has {}", row->tokens.size(),
                              columns));
    }
    last = slice.back();
  }
  return true;
}

void move_to_origin(std::vector<PlacedBrick>& bricks) {
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

std::optional<StateSet> SymbolTable::states(const std::string& symbol) {
  if (symbol == ".") return StateSet::empty_cell();
  if (symbol == "?") return StateSet::anything();
  if (symbol == "#") return StateSet::bricks(colours_);
  if (symbol == "=") return StateSet::floor();
  const auto found = entries_.find(symbol);
  if (found == entries_.end()) return std::nullopt;
  found->second.used = true;
  return found->second.states;
}

std::string SymbolTable::nearest_to(std::string_view word, bool bricks_only) const {
  std::vector<std::string_view> candidates;
  for (const std::string& symbol : order_) {
    if (!bricks_only || entries_.at(symbol).colour != 0) candidates.push_back(symbol);
    if (candidates.size() == 200) break;  // thousands of symbols would take their time
  }
  return std::string(nearest(word, candidates));
}

void report_unknown(const SourceRange& range, const std::string& symbol, bool bricks_only,
                    DrawingContext& context) {
  const bool legend = bricks_only && context.symbols.find(symbol) != nullptr;
  const std::string message = legend || is_reserved_symbol(symbol)
                                  ? fmt::format("{} is no brick", in_quotes(symbol))
                                  : fmt::format("unknown brick {}", in_quotes(symbol));
  Diagnostic& diagnostic = context.diagnostics.add(Code::R204, range, message);
  if (context.diagnostics.full()) return;
  diagnostic.suggest(context.symbols.nearest_to(symbol, bricks_only));
  const bool run_together =
      symbol.size() > 1 && std::all_of(symbol.begin(), symbol.end(), [&](char c) {
        const std::string one(1, c);
        return is_reserved_symbol(one) || context.symbols.find(one) != nullptr;
      });
  if (run_together && !bricks_only) diagnostic.note("symbols in a drawing are parted by spaces");
}

std::optional<Pattern> read_pattern(const YamlNode& node, bool inversion, DrawingContext& context) {
  return PatternReader(node, inversion, context).read();
}

std::optional<std::vector<PlacedBrick>> read_structure(const YamlNode& node,
                                                       DrawingContext& context) {
  const std::vector<Row> rows = split(node.text);
  const std::vector<Slice> slices = slices_of(rows);
  const YamlTextMap places(context.document, node);
  bool sound = check_structure_shape(places, slices, context);
  std::vector<PlacedBrick> bricks;
  for (std::size_t s = 0; s < slices.size(); ++s) {
    const auto z = static_cast<std::int32_t>(slices.size() - 1 - s);
    for (std::size_t r = 0; r < slices[s].size(); ++r) {
      const auto y = static_cast<std::int32_t>(slices[s].size() - 1 - r);
      std::int32_t x = -1;
      for (const Token& token : slices[s][r]->tokens) {
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

}  // namespace stig
