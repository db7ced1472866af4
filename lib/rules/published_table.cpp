// SPDX-License-Identifier: MIT
// A form is the list of its rows, each the offsets of its entries in reading order; all else is the
// same for every form. A rule with a mistake is read to its end, so that each mistake is reported
// once and the next rule begins where it should.
#include "rules/published_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace stig::rules {
namespace {

constexpr std::string_view kBetween = " \t\r,";
constexpr std::string_view kArrow = "=>";
constexpr std::size_t kMostRules = 20000;

struct Word {
  std::string_view text;
  std::size_t begin = 0;  ///< in the file
  std::size_t end() const { return begin + text.size(); }
};

std::vector<Word> words_of(std::string_view text, std::size_t begin, std::size_t end) {
  std::vector<Word> words;
  while ((begin = text.find_first_not_of(kBetween, begin)) < end) {
    const std::size_t stop = std::min(text.find_first_of(kBetween, begin), end);
    words.push_back({text.substr(begin, stop - begin), begin});
    begin = stop;
  }
  return words;
}

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

struct Shape {
  Lattice lattice = Lattice::cubic;
  std::vector<std::vector<Offset>> rows;
  bool one_line = false;  ///< the brick and its probability follow on the row's own line
};

Shape matrices(Lattice lattice) {
  Shape shape{lattice, {}, false};
  for (int y = 1; y >= -1; --y) {
    std::vector<Offset>& row = shape.rows.emplace_back();
    for (int z = 1; z >= -1; --z) {
      for (int x = -1; x <= 1; ++x) row.push_back({x, y, z});
    }
  }
  return shape;
}

/// Round the middle clockwise as drawn, from the upper left; then the middle, off the level.
Shape slices() {
  constexpr std::array<Offset, 6> kRing{
      {{-1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, -1, 0}, {0, -1, 0}, {-1, 0, 0}}};
  Shape shape{Lattice::hexagonal, {}, false};
  for (int z = 1; z >= -1; --z) {
    std::vector<Offset>& row = shape.rows.emplace_back();
    for (const Offset& at : kRing) row.push_back({at.x, at.y, z});
    if (z != 0) row.push_back({0, 0, z});
  }
  return shape;
}

Shape shape_of(TableForm form, Lattice matrices_of) {
  if (form == TableForm::matrices) return matrices(matrices_of);
  Shape shape = slices();
  if (form == TableForm::slices) return shape;
  std::vector<Offset> all;
  for (const std::vector<Offset>& row : shape.rows) all.insert(all.end(), row.begin(), row.end());
  return {Lattice::hexagonal, {std::move(all)}, true};
}

class TableReader {
 public:
  TableReader(SourceRef source, const TableReading& reading, Diagnostics& diagnostics)
      : source_(std::move(source)), reading_(reading), diagnostics_(diagnostics) {
    set_.name = "table";
    set_.symmetry = reading.symmetry;
    set_.inversion = reading.inversion;
  }

  std::optional<RuleSet> read() {
    const std::string& text = source_->text();
    for (std::size_t begin = 0; begin < text.size() && !stopped_;) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      read_line(words_of(text, begin, end), end);
      begin = end + 1;
    }
    if (!stopped_) finish(text.size());
    if (errors_ > 0) return std::nullopt;
    add_bricks();
    return std::move(set_);
  }

 private:
  void read_line(const std::vector<Word>& words, std::size_t end) {
    if (words.empty()) return;
    const std::string_view first = words.front().text;
    if (first.starts_with("#") || first.starts_with("//")) {
      read_comment(words, end);
    } else if (shape_.rows.empty() && !find_shape(words)) {
      stopped_ = true;
    } else if (first == kArrow) {
      end_rule(words);
    } else {
      read_row(words);
    }
  }

  /// The first line with numbers tells the forms apart.
  bool find_shape(const std::vector<Word>& words) {
    std::optional<TableForm> form = reading_.form;
    if (!form && words.size() == 9) form = TableForm::matrices;
    if (!form && words.size() == 7) form = TableForm::slices;
    if (!form && words.size() >= 20 && words.size() <= 22) form = TableForm::lines;
    if (!form) {
      error(words.front().begin, words.back().end(),
            fmt::format("no table of rules begins with a line of {} entries", words.size()))
          .note(
              "9 entries begin matrices, 7 slices of the hexagonal lattice, 22 a rule in one line");
      return false;
    }
    shape_ = shape_of(*form, reading_.matrices_of);
    set_.lattice = shape_.lattice;
    return true;
  }

  void read_comment(const std::vector<Word>& words, std::size_t end) {
    std::size_t begin = words.front().begin;
    const std::string_view text = source_->text();
    begin = std::min(text.find_first_not_of("#/ \t\r", begin), end);
    const std::vector<Word> said = words_of(text, begin, end);
    const bool two = said.size() >= 2;
    if (two && (said[0].text == "step" || said[0].text == "Step")) begin_step(said[1]);
    // What numbers the rules goes into their names.
    if (said.size() == 2 && said[0].text == "rule" && whole_number(said[1].text)) return;
    const std::string line =
        said.empty() ? "#" : "# " + printable(text.substr(begin, said.back().end() - begin));
    const std::string before =
        set_.rules.empty() && stage_ == 0 ? "stigc" : fmt::format("rules/{}", set_.rules.size());
    set_.comments.push_back({before, false, line});
  }

  void begin_step(const Word& word) {
    std::string_view digits = word.text;
    if (digits.ends_with(":")) digits.remove_suffix(1);
    const std::optional<int> number = whole_number(digits);
    if (!number) return;  // a sentence about steps
    if (*number < 1 || *number > kMaxStage) {
      error(word.begin, word.end(), fmt::format("steps are numbered from 1 to {}", kMaxStage));
    } else if (stage_ == 0 && !set_.rules.empty()) {
      error(word.begin, word.end(), "rules stand before the first step");
    }
    stage_ = std::clamp(*number, 1, kMaxStage);
  }

  void read_row(const std::vector<Word>& words) {
    if (row_ == shape_.rows.size()) {
      error(words.front().begin, words.back().end(), "'=>' and the brick to place are wanted here");
      return;
    }
    const std::vector<Offset>& row = shape_.rows[row_++];
    const std::size_t least = row.size() + (shape_.one_line ? 1 : 0);
    const std::size_t most = row.size() + (shape_.one_line ? 2 : 0);
    const bool fits = words.size() >= least && words.size() <= most;
    if (!fits) {
      const std::string also = most > least ? fmt::format(" or {}", most) : "";
      error(words.front().begin, words.back().end(),
            fmt::format("this line has {} entries, {}{} are wanted", words.size(), least, also));
    }
    for (std::size_t i = 0; fits && i < row.size(); ++i) read_entry(words[i], row[i]);
    if (!shape_.one_line) return;
    if (fits) read_result({words.begin() + static_cast<std::ptrdiff_t>(row.size()), words.end()});
    add_rule();
  }

  void read_entry(const Word& word, Offset at) {
    const int index = neighbourhood(shape_.lattice).index_of(at);
    if (index < 0) {
      const bool site = at == Offset{};
      const bool good = site ? word.text == "*" : word.text == "0" || word.text == "-";
      if (good) return;
      error(word.begin, word.end(),
            site ? "the middle of the level slice is the site, '*'"
                 : "this corner of a matrix is no cell of the hexagonal lattice, and holds '0' or "
                   "'-'");
      return;
    }
    const std::optional<int> state = word.text == "." ? 0 : whole_number(word.text);
    if (state && *state >= 0 && *state <= kMaxColours) {
      rule_.pattern.allowed[static_cast<std::size_t>(index)] =
          StateSet::of(static_cast<State>(*state));
      most_brick_ = std::max(most_brick_, *state);
      return;
    }
    Diagnostic& wrong = error(word.begin, word.end(),
                              fmt::format("{} is no state: 0 is empty, 1 to {} are bricks",
                                          in_quotes(word.text), kMaxColours));
    if (word.text == "-") {
      wrong.note("of the hexagonal lattice? --lattice hexagonal reads corners so");
    }
  }

  void end_rule(const std::vector<Word>& words) {
    if (row_ != shape_.rows.size()) {
      error(words.front().begin, words.back().end(),
            fmt::format("{} of {} stand before this '=>'", counted(row_, "line"),
                        shape_.rows.size()));
    } else if (words.size() < 2 || words.size() > 3) {
      error(words.front().begin, words.back().end(),
            "'=>', the brick, and p=PROBABILITY or nothing are wanted");
    } else {
      read_result({words.begin() + 1, words.end()});
    }
    add_rule();
  }

  /// The brick to place and, perhaps, its probability.
  void read_result(const std::vector<Word>& words) {
    const std::optional<int> brick = whole_number(words[0].text);
    if (brick && *brick >= 1 && *brick <= kMaxColours) {
      rule_.place = static_cast<Colour>(*brick);
      most_brick_ = std::max(most_brick_, *brick);
    } else {
      error(words[0].begin, words[0].end(),
            fmt::format("the brick to place is a number from 1 to {}", kMaxColours));
    }
    if (words.size() < 2) return;
    std::string_view text = words[1].text;
    if (text.starts_with("p=")) text.remove_prefix(2);
    double chance = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), chance);
    const bool whole = problem == std::errc() && end == text.data() + text.size();
    if (whole && chance > 0 && chance <= 1) {
      rule_.probability = chance;
    } else {
      error(words[1].begin, words[1].end(), "a probability is more than 0 and at most 1");
    }
  }

  void add_rule() {
    // A step may be begun again, and goes on counting then.
    const int number = ++in_stage_[static_cast<std::size_t>(stage_)];
    rule_.stage = stage_;
    rule_.name = stage_ > 0 ? fmt::format("step {} rule {}", stage_, number)
                            : fmt::format("rule {}", number);
    set_.rules.push_back(std::move(rule_));
    rule_ = Rule{};
    row_ = 0;
    if (set_.rules.size() <= kMostRules) return;
    error(0, 0, fmt::format("the table has more than {} rules", kMostRules));
    stopped_ = true;
  }

  void finish(std::size_t end) {
    // What stands behind the last rule ends the file.
    const std::string none = fmt::format("rules/{}", set_.rules.size());
    for (Comment& comment : set_.comments) {
      if (comment.element == none) comment.element.clear();
    }
    if (row_ > 0) error(end, end, "the last rule lacks its end: '=>' and the brick to place");
    if (set_.rules.empty() && errors_ == 0) error(end, end, "there are no rules in this file");
  }

  /// Numbers are the symbols; those that no rule has are declared too, so that brick k is colour k.
  void add_bricks() {
    for (int k = 1; k <= most_brick_; ++k) {
      set_.bricks.push_back({fmt::to_string(k), fmt::to_string(k), {}, {}, {}});
    }
    set_.start = {{Cell{0, 0, 0}, 1}};
  }

  Diagnostic& error(std::size_t begin, std::size_t end, std::string message) {
    ++errors_;
    const SourceRange range{source_, static_cast<std::uint32_t>(begin),
                            static_cast<std::uint32_t>(end)};
    return diagnostics_.add(Code::F420, range, std::move(message));
  }

  SourceRef source_;
  TableReading reading_;
  Diagnostics& diagnostics_;
  RuleSet set_;
  Shape shape_;
  Rule rule_;  ///< being read
  std::size_t row_ = 0, errors_ = 0;
  int stage_ = 0, most_brick_ = 0;
  std::array<int, kMaxStage + 1> in_stage_{};  ///< rules of each step; of none, 0
  bool stopped_ = false;
};

}  // namespace

std::optional<RuleSet> read_published_table(SourceRef source, const TableReading& reading,
                                            Diagnostics& diagnostics) {
  return TableReader(std::move(source), reading, diagnostics).read();
}

}  // namespace stig::rules
