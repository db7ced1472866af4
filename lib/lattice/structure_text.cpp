// SPDX-License-Identifier: MIT
// The drawing of slices, in files and in string literals of tests. Slices are listed from
// the top down and rows from the back, as in rule sets, so that a drawing of a structure
// reads like the drawings of rules.
#include "lattice/structure_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <map>

#include "lattice/loaded_structure.h"
#include "lattice/rgb.h"

namespace stig::lattice {

namespace {

constexpr std::size_t kMostErrors = 100;  // then reading stops: a wrong file is wrong all over
constexpr std::string_view kSpaces = " \t\r";

/// Without bricks, symbols are numbers, as in literals of tests.
std::map<std::string, State, std::less<>> states_by_symbol(const std::vector<Brick>& bricks) {
  std::map<std::string, State, std::less<>> states{{".", kEmpty}};
  const int count = bricks.empty() ? kMaxColours : static_cast<int>(bricks.size());
  for (int colour = 1; colour <= count; ++colour) {
    const auto state = static_cast<State>(colour);
    states.emplace(symbol_of(bricks, state), state);
  }
  return states;
}

class TextReader {
 public:
  TextReader(SourceRef source, const std::vector<Brick>& bricks, RowForm form,
             Diagnostics& diagnostics)
      : source_(std::move(source)),
        states_(states_by_symbol(bricks)),
        joined_(form == RowForm::joined),
        diagnostics_(diagnostics) {}

  std::optional<Structure> read(Lattice lattice, Offset corner) {
    const std::string& text = source_->text();
    for (std::size_t begin = 0; begin < text.size() && errors_ < kMostErrors;) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      read_line(begin, end);
      begin = end + 1;
    }
    if (width_ == 0 && errors_ == 0) {
      error(Code::F404, text.size(), text.size(), "the file draws no structure");
    }
    if (errors_ == 0) end_slice(text.size(), text.size());
    if (errors_ != 0) return std::nullopt;
    return build(lattice, corner);
  }

 private:
  void read_line(std::size_t begin, std::size_t end) {
    const std::string_view line = std::string_view(source_->text()).substr(begin, end - begin);
    const std::size_t first = line.find_first_not_of(kSpaces);
    if (first == std::string_view::npos) {
      blank_before_ = rows_ > 0;
      return;
    }
    const std::size_t last = line.find_last_not_of(kSpaces) + 1;
    // Comments are skipped within the drawing too; the head's keys are read by
    // text_file.cpp.
    const std::string_view body = line.substr(first, last - first);
    if (body.starts_with("//")) return;
    if (body == "---") {
      end_slice(begin + first, begin + last);
    } else {
      read_row(begin + first, begin + last);
    }
  }

  // A symbol may be any run of characters without spaces, so several-character symbols are
  // read as they are printed.
  void read_row(std::size_t begin, std::size_t end) {
    if (blank_before_) warn_of_blank(begin, end);
    // No farther than the row: a search beyond it would make long drawings quadratic.
    const std::string_view text = std::string_view(source_->text()).substr(0, end);
    const std::size_t cells_before = cells_.size();
    for (std::size_t at = begin; at < end;) {
      const std::size_t stop = joined_ ? at + 1 : std::min(text.find_first_of(kSpaces, at), end);
      cells_.push_back(state_of(at, stop));
      at = std::min(text.find_first_not_of(kSpaces, stop), end);
    }
    const std::size_t width = cells_.size() - cells_before;
    if (width_ == 0) width_ = width;
    // The row is read in full although its width is wrong: all unknown symbols are
    // reported.
    if (width != width_) {
      error(Code::F403, begin, end,
            fmt::format("row has {} cells, the rows before have {}", width, width_));
    }
    ++rows_;
  }

  /// Said once: who parts slices so does it everywhere.
  void warn_of_blank(std::size_t begin, std::size_t end) {
    blank_before_ = false;
    if (warned_) return;
    warned_ = true;
    diagnostics_.add(Code::F412, range(begin, end), "this row is on the level of the rows above it")
        .note("a blank line parts nothing; a line of '---' begins the next level");
  }

  // The nearest known symbol is suggested, by edit distance, as for keys of rule files.
  State state_of(std::size_t begin, std::size_t end) {
    const std::string_view symbol = std::string_view(source_->text()).substr(begin, end - begin);
    const auto found = states_.find(symbol);
    if (found != states_.end()) return found->second;
    Diagnostic& diagnostic =
        error(Code::F402, begin, end, fmt::format("unknown brick '{}'", symbol.substr(0, 40)));
    std::vector<std::string_view> known;
    for (const auto& [name, state] : states_) known.push_back(name);
    const std::string_view near = nearest(symbol.substr(0, 40), known);
    if (!near.empty()) diagnostic.suggest(std::string(near));
    // Entering the unknown symbol as empty silences it from now on.
    states_.emplace(std::string(symbol), kEmpty);
    return kEmpty;
  }

  // The last slice has no separator behind it; the end of the text closes it.
  void end_slice(std::size_t begin, std::size_t end) {
    if (rows_ == 0) {
      error(Code::F403, begin, end, "slice without rows");
    } else if (height_ == 0) {
      height_ = rows_;
    } else if (rows_ != height_) {
      error(Code::F403, begin, end,
            fmt::format("slice has {} rows, the slices before have {}", rows_, height_));
    }
    rows_ = 0;
    blank_before_ = false;
    ++slices_;
  }

  std::optional<Structure> build(Lattice lattice, Offset corner) {
    assert(cells_.size() == width_ * height_ * slices_);
    std::vector<PlacedBrick> bricks;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (cells_[i] == kEmpty) continue;
      const std::size_t row = i / width_;
      // Reading order is x rising, y falling, z falling.
      const Cell drawn{static_cast<std::int32_t>(i % width_),
                       static_cast<std::int32_t>(height_ - 1 - row % height_),
                       static_cast<std::int32_t>(slices_ - 1 - row / height_)};
      bricks.push_back({drawn + corner, cells_[i]});
    }
    if (const auto problem = find_problem(bricks)) {
      error(Code::F406, 0, 0, to_string(*problem));
      return std::nullopt;
    }
    return Structure(lattice, bricks);
  }

  Diagnostic& error(Code code, std::size_t begin, std::size_t end, std::string message) {
    ++errors_;
    return diagnostics_.add(code, range(begin, end), std::move(message));
  }

  SourceRange range(std::size_t begin, std::size_t end) const {
    return {source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }

  SourceRef source_;
  std::map<std::string, State, std::less<>> states_;
  bool joined_;
  Diagnostics& diagnostics_;
  std::vector<State> cells_;  // in reading order
  std::size_t width_ = 0, height_ = 0, rows_ = 0, slices_ = 0, errors_ = 0;
  bool blank_before_ = false;  ///< between the row before, of the same slice, and the next
  bool warned_ = false;
};

}  // namespace

std::optional<Structure> read_structure_text(SourceRef source, Lattice lattice,
                                             const std::vector<Brick>& bricks,
                                             Diagnostics& diagnostics, Cell corner, RowForm form) {
  return TextReader(std::move(source), bricks, form, diagnostics)
      .read(lattice, {corner.x, corner.y, corner.z});
}

/// A malformed literal is a fault of a test, so it is asserted and not reported.
Structure structure_literal(std::string_view text, Lattice lattice) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<SourceFile>("literal", std::string(text));
  std::optional<Structure> structure = read_structure_text(source, lattice, {}, diagnostics);
  assert(structure && "malformed structure literal");
  return std::move(*structure);
}

std::string print_structure(const Structure& structure, const std::vector<Brick>& bricks) {
  const std::optional<CellBounds> bounds = structure.bounds();
  if (!bounds) return ".\n";
  // Symbols of several characters are padded to one width, so that columns line up.
  std::vector<std::string> symbols{"."};
  std::size_t width = 1;
  for (const PlacedBrick& brick : structure.bricks()) {
    while (symbols.size() <= brick.brick) {
      symbols.push_back(symbol_of(bricks, static_cast<Colour>(symbols.size())));
    }
    width = std::max(width, symbols[brick.brick].size());
  }
  std::string out;
  for (int z = bounds->high.z; z >= bounds->low.z; --z) {
    if (z != bounds->high.z) out += "---\n";
    for (int y = bounds->high.y; y >= bounds->low.y; --y) {
      for (int x = bounds->low.x; x <= bounds->high.x; ++x) {
        const std::string& symbol = symbols[structure.at({x, y, z})];
        out += symbol;
        out.append(x == bounds->high.x ? 0 : width - symbol.size() + 1, ' ');
      }
      out += '\n';
    }
  }
  return out;
}

}  // namespace stig::lattice
