// SPDX-License-Identifier: MIT
// The head of a structure's text file. It consists of comments with known keys before the
// first row, so that files remain readable as plain drawings and older ones without a head
// keep their meaning.
#include "lattice/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>

#include "base/text_bytes.h"
#include "lattice/rgb.h"
#include "lattice/structure_text.h"

namespace stig::lattice {

namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kLongestSymbol = 64;  ///< bytes

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

std::optional<int> number_of(std::string_view word, int low, int high) {
  int value = 0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value < low || value > high ? std::nullopt : std::optional(value);
}

// Can a row of symbols be read back that has this one in it? A symbol must survive printing
// and reading: it can be of no great length, no comment, no separator and no empty cell.
bool drawable(std::string_view symbol) {
  return !symbol.empty() && symbol.size() <= kLongestSymbol && symbol != "." && symbol != "---" &&
         !symbol.starts_with("//") && symbol.find_first_of(" \t\r\n") == std::string_view::npos;
}

/// Names are the symbols: nothing better is known of bricks that are only drawn.
std::vector<Brick> bricks_of(const std::vector<std::string_view>& symbols) {
  std::vector<Brick> bricks = numbered_bricks(static_cast<int>(symbols.size()));
  for (std::size_t i = 0; i < symbols.size(); ++i) bricks[i].symbol = bricks[i].name = symbols[i];
  return bricks;
}

bool all_differ(const std::vector<std::string_view>& words) {
  return std::set<std::string_view>(words.begin(), words.end()).size() == words.size();
}

struct Head {
  std::optional<Lattice> lattice;
  std::optional<Cell> corner;
  std::optional<std::vector<Brick>> bricks;
};

// Reads the comments before the first row; those without a key of ours are passed over.
// Errors in known keys are reported; unknown keys are comments like any other.
class HeadReader {
 public:
  HeadReader(const SourceRef& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  /// False when something in the head is malformed.
  bool read(Head& head) {
    std::string_view rest = source_->text();
    // The head ends at the first row; comments further down are only comments.
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view line = trimmed(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (line.empty()) continue;
      if (!line.starts_with("//")) break;
      read_line(line.substr(2), head);
    }
    return good_;
  }

 private:
  void read_line(std::string_view line, Head& head) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return;
    const std::string_view key = trimmed(line.substr(0, colon));
    const std::string_view value = line.substr(colon + 1);
    if (key == "lattice") read_lattice(value, head);
    if (key == "lowest corner") read_corner(value, head);
    if (key == "bricks") read_bricks(value, head);
  }

  void read_lattice(std::string_view value, Head& head) {
    const std::string_view word = trimmed(value);
    if (head.lattice) return error(value, "the lattice is given twice");
    for (const Lattice lattice : {Lattice::cubic, Lattice::hexagonal}) {
      if (word == to_string(lattice)) head.lattice = lattice;
    }
    if (!head.lattice) error(value, "the lattice is cubic or hexagonal");
  }

  void read_corner(std::string_view value, Head& head) {
    if (head.corner) return error(value, "the lowest corner is given twice");
    std::vector<int> numbers;
    const auto words = words_of(value);
    for (const std::string_view word : words) {
      const auto number = number_of(word, -kMaxCoordinate, kMaxCoordinate);
      if (number) numbers.push_back(*number);
    }
    if (words.size() != 3 || numbers.size() != 3) {
      return error(value, fmt::format("the lowest corner is x y z, three whole numbers within ±{}",
                                      kMaxCoordinate));
    }
    head.corner = Cell{numbers[0], numbers[1], numbers[2]};
  }

  void read_bricks(std::string_view value, Head& head) {
    if (head.bricks) return error(value, "the bricks are given twice");
    const auto symbols = words_of(value);
    if (symbols.empty() || symbols.size() > kMaxColours || !all_differ(symbols) ||
        !std::all_of(symbols.begin(), symbols.end(), drawable)) {
      return error(value, fmt::format("the bricks are 1 to {} different symbols", kMaxColours));
    }
    head.bricks = bricks_of(symbols);
  }

  void error(std::string_view where, std::string message) {
    const std::string_view shown = trimmed(where);
    // The word may be empty, and then the place of the value's begin is all there is.
    const char* begin = shown.empty() ? where.data() : shown.data();
    const auto at = static_cast<std::uint32_t>(begin - source_->text().data());
    diagnostics_.add(Code::F411, {source_, at, at + static_cast<std::uint32_t>(shown.size())},
                     std::move(message));
    good_ = false;
  }

  const SourceRef& source_;
  Diagnostics& diagnostics_;
  bool good_ = true;
};

// The rows of all slices, without what is passed over and what parts slices.
std::vector<std::string_view> rows_of(std::string_view text) {
  std::vector<std::string_view> rows;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && !line.starts_with("//") && line != "---") rows.push_back(line);
  }
  return rows;
}

// Somebody who draws "##.#" means four cells. A row of one word is taken for that when it cannot
// well be a symbol: "." and "#" occur in no name, and neither three digits are a colour nor one
// digit twice, as in "11". Words of letters, and other numbers of two digits, stay symbols of a
// structure one cell wide.
RowForm form_of(const std::vector<std::string_view>& rows) {
  const auto plain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  bool told = false;
  for (const std::string_view row : rows) {
    const bool same = row.size() == rows.front().size() && row.size() > 1;
    const bool drawn = std::all_of(row.begin(), row.end(), [&](char c) {
      return plain(c) || c == '.' || c == '#' || c == '?';
    });
    if (!same || !drawn) return RowForm::spaced;
    const bool digits = row.find_first_not_of("0123456789") == std::string_view::npos;
    const bool twice = row.size() == 2 && row[0] == row[1];
    told = told || row.find_first_of(".#?") != std::string_view::npos ||
           (digits && (row.size() > 2 || twice));
  }
  return told ? RowForm::joined : RowForm::spaced;
}

// The bricks of slices that nobody has named: none, for numbers, when all symbols are
// numbers; otherwise the symbols as they appear, as many as a structure has room for.
// Numbers mean colours by their value; letters mean them by the order of appearance.
std::vector<Brick> bricks_drawn(const std::vector<std::string_view>& rows, RowForm form) {
  std::vector<std::string_view> symbols;
  std::set<std::string_view> seen{"."};
  bool numbers = true;
  const auto add = [&](std::string_view word) {
    if (word.size() > kLongestSymbol || !seen.insert(word).second) return;
    if (symbols.size() < kMaxColours) symbols.push_back(word);
    numbers &= number_of(word, 1, kMaxColours).has_value();
  };
  for (const std::string_view row : rows) {
    if (symbols.size() >= kMaxColours) break;
    if (form == RowForm::joined) {
      for (std::size_t i = 0; i < row.size(); ++i) add(row.substr(i, 1));
    } else {
      for (const std::string_view word : words_of(row)) add(word);
    }
  }
  return numbers ? std::vector<Brick>{} : bricks_of(symbols);
}

/// The highest colour of a brick that stands in the structure; 0 without bricks.
int highest_colour(const Structure& structure) {
  int highest = 0;
  for (const PlacedBrick& brick : structure.bricks()) highest = std::max<int>(highest, brick.brick);
  return highest;
}

// The bricks, or numbers where their symbols could not be told apart again. All or none are
// replaced: a mixture of symbols and numbers could be misread. Colours that are declared and not
// used are kept, so that numbers stay what they were.
std::vector<Brick> drawable_bricks(const Structure& structure, const std::vector<Brick>& bricks) {
  const int highest = highest_colour(structure);
  std::vector<std::string_view> symbols;
  for (const Brick& brick : bricks) symbols.push_back(brick.symbol);
  const bool good = static_cast<int>(bricks.size()) >= highest && all_differ(symbols) &&
                    std::all_of(symbols.begin(), symbols.end(), drawable);
  return good ? bricks : numbered_bricks(std::max(highest, static_cast<int>(bricks.size())));
}

}  // namespace

std::optional<LoadedStructure> read_text_file(const SourceRef& source,
                                              std::optional<Lattice> lattice,
                                              const std::vector<Brick>& bricks,
                                              Diagnostics& diagnostics) {
  Head head;
  if (!is_text(source, diagnostics)) return std::nullopt;
  if (!HeadReader(source, diagnostics).read(head)) return std::nullopt;
  if (lattice && head.lattice && *head.lattice != *lattice) {
    diagnostics.add(Code::F411, {source, 0, 0},
                    fmt::format("the structure is {}, {} is wanted", to_string(*head.lattice),
                                to_string(*lattice)));
    return std::nullopt;
  }
  if (!lattice) lattice = head.lattice.value_or(Lattice::cubic);
  std::vector<Brick> known = bricks;
  RowForm form = RowForm::spaced;
  if (known.empty() && head.bricks) known = *head.bricks;
  if (known.empty()) {
    const auto rows = rows_of(source->text());
    form = form_of(rows);
    known = bricks_drawn(rows, form);
  }
  auto structure =
      read_structure_text(source, *lattice, known, diagnostics, head.corner.value_or(Cell{}), form);
  if (!structure) return std::nullopt;
  if (known.empty()) known = numbered_bricks(highest_colour(*structure));
  return LoadedStructure{std::move(*structure), std::move(known), head.corner.has_value()};
}

std::string print_text_file(const Structure& structure, const std::vector<Brick>& bricks) {
  const std::vector<Brick> drawn = drawable_bricks(structure, bricks);
  const Cell corner = structure.empty() ? Cell{} : structure.bounds()->low;
  std::string out = fmt::format("// lattice: {}\n// lowest corner: {} {} {}\n",
                                to_string(structure.lattice()), corner.x, corner.y, corner.z);
  if (!drawn.empty()) {
    out += "// bricks:";
    for (const Brick& brick : drawn) out += " " + brick.symbol;
    out += '\n';
  }
  return out + print_structure(structure, drawn);
}

}  // namespace stig::lattice
