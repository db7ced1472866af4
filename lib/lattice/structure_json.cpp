// SPDX-License-Identifier: MIT
// Reads the JSON form by a SAX parser. Files can be large, and hostile ones deep; without a
// tree the memory is that of the bricks. The states of `Where` are the grammar: each event
// is allowed in few of them, and everything else is an error at the place that the parser
// has reached.
#include "lattice/structure_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>

#include "lattice/rgb.h"

namespace stig::lattice {

namespace {

using nlohmann::json;

// Walks the text for the parser and tells how far it has come, so that errors in meaning,
// which the parser does not know, have a place too. The parser itself reports places of
// errors in form only.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  std::size_t* count = nullptr;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    ++*count;
    return *this;
  }
  bool operator==(const CountingIterator& o) const { return at == o.at; }
  bool operator!=(const CountingIterator& o) const { return at != o.at; }
};

// Takes the parser's events one by one: no tree is built, so neither depth nor width of a
// hostile file costs anything. Each handler returns false to stop. Members hold what has
// been read so far; nothing is handed out before `finish` has seen all of it.
class Handler : public nlohmann::json_sax<json> {
 public:
  Handler(SourceRef source, Diagnostics& diagnostics)
      : source_(std::move(source)), diagnostics_(diagnostics) {}

  std::size_t* count() { return &count_; }
  std::optional<LoadedStructure> finish();

  bool null() override { return fail("null has no place here"); }
  bool boolean(bool) override { return fail("true and false have no place here"); }
  bool binary(binary_t&) override { return fail("binary data has no place here"); }
  bool number_integer(number_integer_t value) override { return number(value); }
  // Larger numbers have no meaning in the form, and the conversion would be undefined.
  bool number_unsigned(number_unsigned_t value) override {
    return value > (std::uint64_t{1} << 62) ? fail("number too large")
                                            : number(static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t, const string_t& text) override {
    return fail(fmt::format("'{}' is not a whole number", text.substr(0, 40)));
  }
  bool string(string_t& value) override;
  bool start_object(std::size_t) override;
  bool end_object() override;
  bool key(string_t& key) override;
  bool start_array(std::size_t) override;
  bool end_array() override;
  bool parse_error(std::size_t, const std::string& token, const json::exception&) override {
    return fail(token.empty() ? "the text ends too early"
                              : fmt::format("not JSON at '{}'", printable(token)));
  }

 private:
  enum class Where { outside, top, bricks, brick, cells, cell, after };

  // Names from a hostile file may hold control characters, which a message must not.
  static std::string printable(std::string text) {
    text.resize(std::min<std::size_t>(text.size(), 40));
    for (char& c : text) c = c >= ' ' && c <= '~' ? c : '?';
    return text;
  }
  bool number(std::int64_t value);
  bool end_cell();
  bool version(std::int64_t value);
  bool fail(const std::string& message, Code code = Code::F405);

  SourceRef source_;
  Diagnostics& diagnostics_;
  std::size_t count_ = 0;  // bytes the parser has taken
  Where where_ = Where::outside;
  std::string key_;
  std::vector<std::string> top_keys_, brick_keys_;
  Lattice lattice_ = Lattice::cubic;
  std::vector<Brick> bricks_;
  std::vector<PlacedBrick> cells_;
  std::array<std::int64_t, 4> cell_{};
  std::size_t cell_size_ = 0;
  Colour highest_ = 0;
};

bool Handler::fail(const std::string& message, Code code) {
  const std::size_t size = source_->text().size();
  // The parser has taken the offending character already, so the place is one back.
  const std::size_t begin = std::min(count_ == 0 ? 0 : count_ - 1, size);
  diagnostics_.add(code,
                   {source_, static_cast<std::uint32_t>(begin),
                    static_cast<std::uint32_t>(std::min(begin + 1, size))},
                   message);
  return false;
}

/// The same function serves both kinds of objects; `where_` says which keys are known and
/// which were seen.
bool Handler::key(string_t& key) {
  static const std::vector<std::string_view> top = {"stigc_structure", "lattice", "bricks",
                                                    "cells"};
  static const std::vector<std::string_view> brick = {"symbol", "name", "color"};
  const auto& known = where_ == Where::top ? top : brick;
  auto& seen = where_ == Where::top ? top_keys_ : brick_keys_;
  if (std::find(known.begin(), known.end(), key) == known.end()) {
    return fail(fmt::format("unknown key '{}'", printable(key)));
  }
  if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
    return fail(fmt::format("key '{}' comes twice", key));
  }
  seen.push_back(key);
  key_ = key;
  return true;
}

bool Handler::string(string_t& value) {
  if (where_ == Where::top && key_ == "lattice") {
    if (value != "cubic" && value != "hexagonal") {
      return fail(fmt::format("unknown lattice '{}': cubic or hexagonal", printable(value)));
    }
    lattice_ = value == "cubic" ? Lattice::cubic : Lattice::hexagonal;
    return true;
  }
  if (where_ != Where::brick) return fail("a text has no place here");
  Brick& brick_read = bricks_.back();
  if (key_ == "color" && !parse_color(value)) {
    return fail(fmt::format("colour '{}' is not of the form #rrggbb", printable(value)));
  }
  (key_ == "symbol" ? brick_read.symbol
   : key_ == "name" ? brick_read.name
                    : brick_read.color) = value;
  return true;
}

bool Handler::number(std::int64_t value) {
  if (where_ == Where::cell) {
    if (cell_size_ == 4) return fail("a cell is four numbers: x, y, z, brick");
    cell_[cell_size_++] = value;
    return true;
  }
  if (where_ == Where::top && key_ == "stigc_structure") return version(value);
  return fail("a number has no place here");
}

bool Handler::version(std::int64_t value) {
  return value == 1 || fail(fmt::format("version {} of the format is not known, only 1", value));
}

/// Only the document itself and the entries of "bricks" are objects.
bool Handler::start_object(std::size_t) {
  if (where_ == Where::outside) {
    where_ = Where::top;
    return true;
  }
  if (where_ != Where::bricks) return fail("an object has no place here");
  if (bricks_.size() == kMaxColours) {
    return fail(fmt::format("more than {} bricks", kMaxColours));
  }
  where_ = Where::brick;
  brick_keys_.clear();
  bricks_.emplace_back();
  return true;
}

bool Handler::end_object() {
  if (where_ == Where::brick && brick_keys_.size() != 3) {
    return fail("a brick has the keys symbol, name and color");
  }
  where_ = where_ == Where::brick ? Where::bricks : Where::after;
  return true;
}

bool Handler::start_array(std::size_t) {
  if (where_ == Where::top && key_ == "bricks") {
    where_ = Where::bricks;
  } else if (where_ == Where::top && key_ == "cells") {
    where_ = Where::cells;
  } else if (where_ == Where::cells) {
    where_ = Where::cell;
    cell_size_ = 0;
  } else {
    return fail("an array has no place here");
  }
  return true;
}

/// The last closing bracket of "cells" and that of "bricks" both lead back to the top.
bool Handler::end_array() {
  if (where_ == Where::cell) return end_cell();
  where_ = Where::top;
  return true;
}

bool Handler::end_cell() {
  // A cell is checked when it is complete, so the caret stands at its end.
  if (cell_size_ != 4) return fail("a cell is four numbers: x, y, z, brick");
  for (std::size_t i = 0; i < 3; ++i) {
    if (cell_[i] < -kMaxCoordinate || cell_[i] > kMaxCoordinate) {
      return fail(fmt::format("coordinate {} lies outside ±{}", cell_[i], kMaxCoordinate),
                  Code::F406);
    }
  }
  if (cell_[3] < 1 || cell_[3] > kMaxColours) {
    return fail(fmt::format("brick {} is none of 1..{}", cell_[3], kMaxColours), Code::F406);
  }
  if (cells_.size() == kMostFileBricks) {
    return fail(fmt::format("more than {} cells", kMostFileBricks), Code::F406);
  }
  const auto colour = static_cast<Colour>(cell_[3]);
  cells_.push_back({{static_cast<std::int32_t>(cell_[0]), static_cast<std::int32_t>(cell_[1]),
                     static_cast<std::int32_t>(cell_[2])},
                    colour});
  highest_ = std::max(highest_, colour);
  where_ = Where::cells;
  return true;
}

std::optional<LoadedStructure> Handler::finish() {
  // A missing lattice means cubic; the other keys have no default.
  for (const char* key : {"stigc_structure", "bricks", "cells"}) {
    if (std::find(top_keys_.begin(), top_keys_.end(), key) == top_keys_.end()) {
      fail(fmt::format("key '{}' is missing", key));
      return std::nullopt;
    }
  }
  if (highest_ > bricks_.size()) {
    fail(fmt::format("a cell names brick {}, but there are {}", highest_, bricks_.size()),
         Code::F406);
    return std::nullopt;
  }
  if (const auto problem = find_problem(cells_)) {
    fail(to_string(*problem), Code::F406);
    return std::nullopt;
  }
  return LoadedStructure{Structure(lattice_, cells_), std::move(bricks_)};
}

// Invalid UTF-8 in a name becomes U+FFFD. Names come from rule files, which may hold any
// bytes; a .json file must be UTF-8.
std::string quoted(const std::string& text) {
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::optional<LoadedStructure> read_structure_json(SourceRef source, Diagnostics& diagnostics) {
  Handler handler(source, diagnostics);
  const std::string& text = source->text();
  const CountingIterator begin{text.data(), handler.count()};
  const CountingIterator end{text.data() + text.size(), handler.count()};
  if (!json::sax_parse(begin, end, &handler)) return std::nullopt;
  return handler.finish();
}

/// Printed by hand: one cell a line keeps the file readable, and cell order makes it
/// comparable.
std::string print_structure_json(const Structure& structure, const std::vector<Brick>& bricks) {
  const std::vector<PlacedBrick> cells = structure.bricks();
  std::size_t colours = bricks.size();
  for (const PlacedBrick& cell : cells) colours = std::max<std::size_t>(colours, cell.brick);
  std::string out = fmt::format("{{\"stigc_structure\": 1, \"lattice\": \"{}\",\n \"bricks\": [",
                                to_string(structure.lattice()));
  for (std::size_t i = 0; i < colours; ++i) {
    const auto colour = static_cast<Colour>(i + 1);
    const std::string name = i < bricks.size() ? bricks[i].name : symbol_of(bricks, colour);
    out += fmt::format("{}\n  {{\"symbol\": {}, \"name\": {}, \"color\": \"{}\"}}",
                       i == 0 ? "" : ",", quoted(symbol_of(bricks, colour)), quoted(name),
                       to_color(rgb_of(bricks, colour)));
  }
  out += "],\n \"cells\": [";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell c = cells[i].at;
    fmt::format_to(std::back_inserter(out), "{}\n  [{}, {}, {}, {}]", i == 0 ? "" : ",", c.x, c.y,
                   c.z, cells[i].brick);
  }
  return out + "]}\n";
}

}  // namespace stig::lattice
