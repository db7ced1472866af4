// SPDX-License-Identifier: MIT
// Drawings of neighbourhoods: diagnostics R201 to R205.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>

#include "base/text.h"
#include "rules/drawing.h"
#include "rules/drawing_rows.h"
#include "rules/rule_schema.h"

namespace stig::rules {

namespace {

/// Reads one neighbourhood; collects errors and goes on.
class PatternReader {
 public:
  PatternReader(const YamlNode& node, bool inversion, DrawingContext& context)
      : node_(node),
        inversion_(inversion),
        context_(context),
        neighbours_(neighbourhood(context.lattice)),
        rows_(split_rows(node.text)),
        places_(context.document, node) {}

  // In order of what makes the rest meaningless: separators that are no symbols, the number
  // of rows, their lengths. Only then are cells read.
  std::optional<Pattern> read() {
    if (!check_separators() || !check_form()) return std::nullopt;
    check_widths();
    for (std::size_t row = 0; row < rows_.size(); ++row) read_row(row);
    if (sound_) check_floor_is_whole(-1);
    // Upside down, the slice above is the one that may be floor.
    if (sound_ && inversion_) check_floor_is_whole(1);
    return sound_ ? std::optional(pattern_) : std::nullopt;
  }

 private:
  SourceRange range(const DrawnSymbol& token) const {
    return places_.range(token.begin, token.begin + token.text.size());
  }
  // The last diagnostic is kept so that a hint can be added to it.
  Diagnostic& fail(Code code, const SourceRange& where, std::string message) {
    sound_ = false;
    return *(last_ = &context_.diagnostics.add(code, where, std::move(message)));
  }

  bool is_known(const std::string& symbol) const {
    return is_reserved_symbol(symbol) || context_.symbols.find(symbol) != nullptr;
  }

  /// Commas, bars and brackets as in lists and tables: said once, since they come in dozens.
  bool check_separators() {
    for (const DrawnRow& row : rows_) {
      for (const DrawnSymbol& token : row.tokens) {
        const std::size_t at = token.text.find_first_of(",;|[](){}\"'");
        if (at == std::string::npos || is_known(token.text)) continue;
        fail(Code::R201, places_.range(token.begin + at, token.begin + at + 1),
             fmt::format("symbols in a drawing are parted by spaces alone, without {}",
                         in_quotes(token.text.substr(at, 1))));
        return false;
      }
    }
    return true;
  }

  /// Three rows? False when nothing in the drawing would be where it is meant to be.
  bool check_form() {
    if (rows_.size() == 3) return true;
    // Where a drawing is no literal block, its rows cannot be told apart in the file, so
    // the head is marked.
    const bool in_block = node_.style == YamlStyle::literal;
    const SourceRange where = in_block && rows_.size() > 3
                                  ? places_.range(rows_[3].begin, rows_[3].end)
                                  : context_.document.head(node_);
    if (!in_block && rows_.size() == 1) {
      fail(Code::R201, where,
           "a drawing is a block of 3 rows: write 'when: |' and the rows below it");
      return false;
    }
    // Slices drawn one below the other are a frequent misreading of the form.
    const bool stacked =
        rows_.size() == 9 || (rows_.size() > 3 && rows_[3].tokens[0].text == "---");
    fail(Code::R201, where,
         fmt::format("a drawing has 3 rows, this one has {}{}", rows_.size(),
                     stacked ? ": its slices stand side by side, not one below the other" : ""));
    return !stacked;
  }

  /// Three rows of one wrong length are one mistake, and reported once.
  void check_widths() {
    if (rows_.size() != 3) return;
    const std::size_t found = rows_[0].tokens.size();
    const auto same = [&](const DrawnRow& row) { return row.tokens.size() == found; };
    if (found == 3 * width(0) || !std::all_of(rows_.begin(), rows_.end(), same)) return;
    alike_ = true;
    fail(Code::R201, places_.range(rows_[0].begin, rows_[0].end),
         fmt::format("the rows of a {} drawing have {}, {} and {} symbols, three slices side by "
                     "side; these have {} each",
                     to_string(context_.lattice), 3 * width(0), 3 * width(1), 3 * width(2), found));
    note_run_together(rows_[0]);
  }

  /// `...` in place of `. . .`?
  bool run_together(const DrawnSymbol& token) const {
    return token.text.size() > 1 && !is_known(token.text) &&
           std::all_of(token.text.begin(), token.text.end(),
                       [&](char c) { return is_known(std::string(1, c)); });
  }
  void note_run_together(const DrawnRow& row) {
    if (!std::any_of(row.tokens.begin(), row.tokens.end(),
                     [&](const DrawnSymbol& token) { return run_together(token); })) {
      return;
    }
    last_->note("symbols in a drawing are parted by spaces");
  }

  /// Cells of row 0, 1, 2 in one slice.
  std::size_t width(std::size_t row) const {
    return context_.lattice == Lattice::hexagonal && row != 1 ? 2 : 3;
  }
  // Column and row of the drawing to an offset; the inverse of the order in
  // neighbourhood.cpp.
  Offset offset_of(std::size_t row, std::size_t column) const {
    assert(row < 3);
    const std::size_t slice = column / width(row);
    const int y = 1 - static_cast<int>(row);
    // The lower row of a hexagonal slice starts one further along x.
    const int first = context_.lattice == Lattice::hexagonal && row == 2 ? 0 : -1;
    return {first + static_cast<int>(column % width(row)), y, 1 - static_cast<int>(slice)};
  }

  void read_row(std::size_t number) {
    const DrawnRow& row = rows_[number];
    const bool shaped = rows_.size() == 3 && row.tokens.size() == 3 * width(number);
    std::size_t most = row.tokens.size();
    if (rows_.size() == 3 && !shaped && !alike_) most = report_width(number);
    // Symbols of a row of wrong length are still looked up, for their own errors, but not
    // placed.
    for (std::size_t column = 0; column < most; ++column) {
      const DrawnSymbol& token = row.tokens[column];
      if (shaped) {
        read_cell(token, offset_of(number, column));
      } else if (token.text != "*" && !run_together(token)) {
        states_of(token);
      }
    }
  }

  /// Says that a row is too short or too long; how many of its symbols are worth a look.
  std::size_t report_width(std::size_t number) {
    const DrawnRow& row = rows_[number];
    const std::size_t wanted = 3 * width(number);
    if (row.tokens.size() > wanted && row.tokens[wanted].text[0] == '#') {
      fail(Code::R201, places_.range(row.tokens[wanted].begin, row.end),
           "a drawing has no comments: what stands behind its symbols is read as symbols too");
      return wanted;
    }
    fail(Code::R201, places_.range(row.begin, row.end),
         fmt::format("this row of a {} drawing has {} symbols, not {}: three slices of {}",
                     to_string(context_.lattice), row.tokens.size(), wanted, width(number)));
    note_run_together(row);
    return row.tokens.size();
  }

  void read_cell(const DrawnSymbol& token, Offset offset) {
    if (offset == Offset{}) {
      if (token.text == "*") return;
      fail(Code::R202, range(token),
           fmt::format("the site is drawn as '*' here, not as {}", in_quotes(token.text)));
      return;
    }
    if (token.text == "*") {
      fail(Code::R203, range(token),
           "'*' is the site, the middle of the level slice alone: write '.' for an empty cell, '?' "
           "for anything");
      return;
    }
    const std::optional<StateSet> states = states_of(token);
    if (token.text == "=") check_floor(token, offset);
    assert(neighbours_.index_of(offset) >= 0);
    const auto index = static_cast<std::size_t>(neighbours_.index_of(offset));
    if (states) pattern_.allowed[index] = *states;
  }

  std::optional<StateSet> states_of(const DrawnSymbol& token) {
    const std::optional<StateSet> states = context_.symbols.states(token.text);
    if (states && !states->none()) return states;
    sound_ = false;
    if (states) return std::nullopt;  // of the legend, where it has been reported
    // An unknown symbol is reported at its first use in the drawing.
    if (reported_.insert(token.text).second) {
      report_unknown(range(token), token.text, false, context_);
    }
    return std::nullopt;
  }

  /// Once for a slice: where one cell is drawn as floor by mistake, others are too.
  void check_floor(const DrawnSymbol& token, Offset offset) {
    const bool below = offset.z < 0 || (offset.z > 0 && inversion_);
    if (context_.floor && below) return;
    sound_ = false;
    if (!floor_reported_.insert(context_.floor ? offset.z : 0).second) return;
    if (!context_.floor) {
      fail(Code::R205, range(token), "'=' never matches in a set without `floor: true`");
    } else {
      fail(Code::R205, range(token),
           fmt::format("'=' never matches {} the site: the floor is below it",
                       offset.z == 0 ? "beside" : "above"));
    }
  }

  /// The floor fills a slice or is not in it: `= 1 =` matches nothing. A world has floor
  /// below a site in all cells of the slice or in none (rule_checks.h), so a mixture with
  /// cells that exclude floor never matches.
  void check_floor_is_whole(int z) {
    const DrawnSymbol* floor = nullptr;
    const DrawnSymbol* other = nullptr;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (std::size_t column = 0; column < rows_[row].tokens.size(); ++column) {
        const Offset offset = offset_of(row, column);
        if (offset.z != z) continue;
        assert(neighbours_.index_of(offset) >= 0);
        const auto index = static_cast<std::size_t>(neighbours_.index_of(offset));
        const StateSet& allowed = pattern_.allowed[index];
        if (allowed == StateSet::floor() && floor == nullptr) floor = &rows_[row].tokens[column];
        if (!allowed.contains(kFloor) && other == nullptr) other = &rows_[row].tokens[column];
      }
    }
    if (floor == nullptr || other == nullptr) return;
    fail(Code::R205, range(*other),
         fmt::format("{} never matches in one slice with '=', since the floor fills a slice or is "
                     "not in it: write '=' or '?' for all of them",
                     in_quotes(other->text)))
        .note(range(*floor), "the floor");
  }

  const YamlNode& node_;
  bool inversion_;
  DrawingContext& context_;
  const Neighbourhood& neighbours_;
  std::vector<DrawnRow> rows_;
  YamlTextMap places_;
  Pattern pattern_;
  bool sound_ = true;
  bool alike_ = false;              ///< all rows have the same wrong length, which has been said
  Diagnostic* last_ = nullptr;      ///< what was said last
  std::set<std::string> reported_;  ///< unknown symbols
  std::set<int> floor_reported_;    ///< slices
};

}  // namespace

std::optional<Pattern> read_pattern(const YamlNode& node, bool inversion, DrawingContext& context) {
  return PatternReader(node, inversion, context).read();
}

}  // namespace stig::rules
