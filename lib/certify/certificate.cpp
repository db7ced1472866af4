// SPDX-License-Identifier: MIT
// The text form of certificates (certificate.h lists its lines, docs/proofs.md describes
// them). A certificate comes from anywhere, so the reader treats it as hostile: every
// number has a range, every count is backed by text that must be there, and nothing is
// allocated ahead of the words that fill it. Printing is canonical, which makes
// certificates comparable as bytes.
#include "certify/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <iterator>
#include <string_view>

#include "base/hash.h"
#include "base/text.h"
#include "certify/filling.h"

namespace stig::certify {
namespace {

/// A side may span all cells that coordinates can name, from -kMaxCoordinate to
/// kMaxCoordinate.
constexpr std::int64_t kMostBoxSide = std::int64_t{2} * kMaxCoordinate + 1;

std::size_t hex_digits_for(std::size_t bits) { return (bits + 3) / 4; }

// Printing

using Text = std::back_insert_iterator<std::string>;

/// A certificate speaks of cells absolutely. A box is therefore printed with its lowest
/// cell, even where the rule file leaves it to the start's middle.
void print_box(Text out, const std::optional<BoxSpec>& box) {
  if (!box) {
    fmt::format_to(out, "box none\n");
    return;
  }
  assert(box->origin);
  const Cell low = *box->origin;
  const Offset size = box->size;
  fmt::format_to(out, "box {} {} {} {} {} {}{}\n", low.x, low.y, low.z, size.x, size.y, size.z,
                 box->periodic ? " periodic" : "");
}

void print_numbers(Text out, const std::vector<std::uint32_t>& numbers) {
  const char* gap = "";
  for (const std::uint32_t number : numbers) {
    fmt::format_to(out, "{}{}", gap, number);
    gap = " ";
  }
  fmt::format_to(out, "\n");
}

/// All fillings of a window have as many digits as it has bricks for, so that a
/// certificate is no smaller than what it unfolds to.
void print_filling(Text out, const Filling& filling, std::size_t bits) {
  assert(is_filling_of(bits, filling));
  // Most significant digit first, although words and bits are stored least first.
  for (std::size_t digit = hex_digits_for(bits); digit-- > 0;) {
    fmt::format_to(out, "{:x}", filling[digit / 16] >> (digit % 16 * 4) & 15U);
  }
}

void print_window(Text out, const CertifiedWindow& window) {
  fmt::format_to(out, "window {} {} {}\n", window.group.size(), window.context.size(),
                 window.fillings.size());
  print_numbers(out, window.group);
  print_numbers(out, window.context);
  for (std::size_t i = 0; i < window.fillings.size(); ++i) {
    if (i > 0) fmt::format_to(out, " ");
    print_filling(out, window.fillings[i], window.group.size() + window.context.size());
  }
  fmt::format_to(out, "\n");
}

void print_stage(Text out, const CertifiedStage& stage, std::size_t number) {
  fmt::format_to(out, "stage {} order {}\n", number, stage.order.size());
  for (const CertifiedBrick& brick : stage.order) {
    fmt::format_to(out, "{} {} {} {} {:x}\n", brick.at.x, brick.at.y, brick.at.z, brick.colour,
                   brick.before);
  }
  for (const std::vector<std::uint32_t>& chain : stage.far) {
    fmt::format_to(out, "far ");
    print_numbers(out, chain);
  }
  for (const CertifiedWindow& window : stage.windows) print_window(out, window);
}

// Reading

/// Says what is wrong once; everything read afterwards is of no account. The format is
/// regular enough for one word of lookahead: `word_` is the next word, and an empty one
/// means that the line has ended. Every function leaves the reader on the word after what
/// it took, and after a failure all of them return quickly with defaults, so callers need
/// not test each item.
class Reader {
 public:
  Reader(const std::string& path, const std::string& text, Diagnostics& diagnostics)
      : path_(path), text_(text), diagnostics_(diagnostics) {}

  std::optional<Certificate> read() {
    Certificate certificate;
    next_line();
    expect_word("stigc-certificate");
    number(1, 1);
    line_done();
    expect_word("rules");
    certificate.rule_set_hash = hex(16, 64);
    line_done();
    read_box(certificate.box);
    while (good() && word_ == "stage") read_stage(certificate.stages);
    expect_word("end");
    certificate.bricks = static_cast<std::uint64_t>(number(0, INT64_MAX));
    line_done();
    if (good() && !at_end_) fail("nothing stands after the line 'end'");
    if (!good()) return std::nullopt;
    return certificate;
  }

 private:
  bool good() const { return !failed_; }

  // Only the first failure is reported: what follows it is read out of step.
  void fail(const std::string& message) {
    if (failed_) return;
    failed_ = true;
    const auto begin = static_cast<std::uint32_t>(begin_);
    const auto end = static_cast<std::uint32_t>(begin_ + word_.size());
    // The text is copied for the diagnostic alone. Certificates can be large, and nearly
    // all of them are well formed.
    diagnostics_.add(Code::F470, {std::make_shared<SourceFile>(path_, text_), begin, end}, message);
  }

  /// Goes to the next line and its first word; a blank line has none.
  void next_line() {
    begin_ = line_end_ = next_;
    word_ = {};
    at_end_ = next_ >= text_.size();
    if (at_end_) return;
    line_end_ = std::min(text_.find('\n', next_), text_.size());
    next_ = std::min(line_end_ + 1, text_.size());
    next_word();
    if (line_end_ > 0 && text_[line_end_ - 1] == '\r') {
      fail("this line ends in CR LF; a certificate's lines end in LF alone");
    }
  }

  void next_word() {
    // A word's end is found from its begin, so that `begin_` is always where a caret goes.
    std::size_t at = begin_ + word_.size();
    while (at < line_end_ && text_[at] == ' ') ++at;
    std::size_t stop = at;
    while (stop < line_end_ && text_[stop] != ' ') ++stop;
    begin_ = at;
    word_ = std::string_view(text_).substr(at, stop - at);
  }

  void line_done() {
    if (!word_.empty()) fail(fmt::format("{} is one word too many", in_quotes(word_)));
    if (good()) next_line();
  }

  void expect_word(std::string_view expected) {
    if (word_ != expected) fail(fmt::format("'{}' belongs here", expected));
    next_word();
  }

  // Returns `low` after a failure, which is in range for every caller.
  std::int64_t number(std::int64_t low, std::int64_t high) {
    std::int64_t value = low;
    const char* end = word_.data() + word_.size();
    const auto [stop, error] = std::from_chars(word_.data(), end, value);
    if (word_.empty() || error != std::errc{} || stop != end || value < low || value > high) {
      fail(fmt::format("a number from {} to {} belongs here", low, high));
      return low;
    }
    next_word();
    return value;
  }

  /// A number of at most so many bits, in at least so many digits.
  std::uint64_t hex(std::size_t digits, std::size_t bits) {
    std::uint64_t value = 0;
    const char* end = word_.data() + word_.size();
    const auto [stop, error] = std::from_chars(word_.data(), end, value, 16);
    // The length is checked too, since from_chars takes any number of leading zeros.
    if (word_.size() < digits || word_.size() > hex_digits_for(bits) || error != std::errc{} ||
        stop != end || (bits < kBitsPerWord && value >> bits != 0)) {
      fail(fmt::format("a hexadecimal number of {} bits belongs here", bits));
      return 0;
    }
    next_word();
    return value;
  }

  std::int32_t coordinate() {
    return static_cast<std::int32_t>(number(-kMaxCoordinate, kMaxCoordinate));
  }
  // Evaluated one after another: the order in which function arguments are evaluated is
  // unspecified, and the three coordinates must be read in the order of the text.
  Cell cell() {
    const std::int32_t x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }
  std::int32_t side() { return static_cast<std::int32_t>(number(1, kMostBoxSide)); }

  void read_box(std::optional<BoxSpec>& box) {
    expect_word("box");
    if (word_ == "none") {
      next_word();
    } else {
      box.emplace();
      box->origin = cell();
      const std::int32_t x = side(), y = side(), z = side();
      box->size = {x, y, z};
      box->periodic = word_ == "periodic";
      if (box->periodic) next_word();
    }
    line_done();
  }

  void read_stage(std::vector<CertifiedStage>& stages) {
    CertifiedStage& stage = stages.emplace_back();
    next_word();
    const auto number_of_stage = static_cast<std::int64_t>(stages.size());
    // A bound, since the number is stored as an int and printed in messages.
    if (number_of_stage > kMaxStage) return fail("there are too many stages");
    number(number_of_stage, number_of_stage);
    expect_word("order");
    // A brick takes a line: a count that the text cannot hold is refused at its end.
    const std::int64_t bricks = number(0, UINT32_MAX);
    line_done();
    for (std::int64_t i = 0; good() && i < bricks; ++i) stage.order.push_back(read_brick());
    while (good() && (word_ == "far" || word_ == "window")) {
      if (word_ == "far") {
        read_far(stage);
      } else {
        read_window(stage);
      }
    }
  }

  CertifiedBrick read_brick() {
    CertifiedBrick brick;
    brick.at = cell();
    brick.colour = static_cast<Colour>(number(1, kMaxColours));
    brick.before = static_cast<std::uint32_t>(hex(1, kMaxNeighbours));
    line_done();
    return brick;
  }

  std::uint32_t position(const CertifiedStage& stage) {
    // Positions count from 0 within the stage. Without bricks the range is left at 0 to 0;
    // the failure has been noted by then.
    if (stage.order.empty()) fail("this stage has no bricks");
    return static_cast<std::uint32_t>(
        number(0, std::max<std::int64_t>(1, static_cast<std::int64_t>(stage.order.size())) - 1));
  }

  void read_far(CertifiedStage& stage) {
    next_word();
    // A chain has at least two bricks, its ends. Whether its steps are `before` steps is
    // for the check to find out (StageCheck::load_far).
    std::vector<std::uint32_t> chain{position(stage), position(stage)};
    while (good() && !word_.empty()) chain.push_back(position(stage));
    stage.far.push_back(std::move(chain));
    line_done();
  }

  void read_window(CertifiedStage& stage) {
    next_word();
    CertifiedWindow window;
    // A window cannot have more bricks than the stage, which bounds `bits` and with it the
    // words of each filling.
    const auto bricks = static_cast<std::int64_t>(stage.order.size());
    const std::int64_t group = number(0, bricks), context = number(0, bricks);
    const std::int64_t fillings = number(0, UINT32_MAX);
    line_done();
    for (std::int64_t i = 0; good() && i < group; ++i) window.group.push_back(position(stage));
    line_done();
    for (std::int64_t i = 0; good() && i < context; ++i) window.context.push_back(position(stage));
    line_done();
    const auto bits = static_cast<std::size_t>(group + context);
    for (std::int64_t i = 0; good() && i < fillings; ++i) {
      const std::size_t begin = begin_, length = word_.size();
      window.fillings.push_back(read_filling(bits));
      // Rising order is demanded for two reasons: no filling is listed twice, and the check
      // finds fillings by bisection. The diagnostic points back at the filling, which has
      // been read past by now.
      if (good() && i > 0 && !less(window.fillings.rbegin()[1], window.fillings.back())) {
        begin_ = begin;
        word_ = std::string_view(text_).substr(begin, length);
        fail("fillings rise from one to the next");
      }
    }
    line_done();
    stage.windows.push_back(std::move(window));
  }

  Filling read_filling(std::size_t bits) {
    Filling filling;
    std::string_view digits = word_;
    if (digits.empty() || digits.size() != hex_digits_for(bits)) {
      fail(fmt::format("a filling of {} hexadecimal digits belongs here", hex_digits_for(bits)));
      return filling;
    }
    filling.assign(words_for(bits), 0);
    // The digits of one word each are cut off from the end, since the last digits hold the
    // lowest bits.
    for (std::uint64_t& word : filling) {
      const std::string_view part =
          digits.substr(digits.size() - std::min<std::size_t>(16, digits.size()));
      const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), word, 16);
      if (error != std::errc{} || stop != part.data() + part.size()) {
        fail("a filling is written in hexadecimal digits");
        return filling;
      }
      digits.remove_suffix(part.size());
    }
    // The last word may have bits to spare; they must be zero, or equal sets would differ
    // as words.
    if (!is_filling_of(bits, filling)) {
      fail("the filling has a brick that its window has not");
    }
    next_word();
    return filling;
  }

  const std::string& path_;
  const std::string& text_;
  Diagnostics& diagnostics_;
  std::string_view word_;
  std::size_t begin_ = 0;                ///< of word_, in text_
  std::size_t line_end_ = 0, next_ = 0;  ///< the end of this line, the begin of the next
  bool at_end_ = false, failed_ = false;
};

}  // namespace

std::string print_certificate(const Certificate& certificate) {
  std::string text;
  const Text out(text);
  fmt::format_to(out, "stigc-certificate 1\nrules {}\n", to_hex(certificate.rule_set_hash));
  print_box(out, certificate.box);
  for (std::size_t i = 0; i < certificate.stages.size(); ++i) {
    print_stage(out, certificate.stages[i], i + 1);
  }
  fmt::format_to(out, "end {}\n", certificate.bricks);
  return text;
}

std::optional<Certificate> read_certificate(const std::string& path, const std::string& text,
                                            Diagnostics& diagnostics) {
  return Reader(path, text, diagnostics).read();
}

}  // namespace stig::certify
