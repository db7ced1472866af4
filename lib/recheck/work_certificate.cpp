// SPDX-License-Identifier: MIT
// The text form, a line an item. A certificate may come from anybody: each number has a range, each
// list ends with its line, and nodes are as many as there are lines.
#include "recheck/work_certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <cassert>
#include <charconv>
#include <cmath>

#include "base/hash.h"
#include "base/text.h"

namespace stig::recheck {

namespace {

using Kind = WorkNode::Kind;
constexpr std::array<std::string_view, 6> kKinds = {"top-colour", "top-level", "cell",
                                                    "side",       "put",       "nothing"};
constexpr int kMostNear = 64;          ///< cells from a column
constexpr std::size_t kDeepest = 200;  ///< questions on the way to a leaf
constexpr std::size_t kMostLooks = 256;
constexpr int kMostAnswers = 256;

void print_node(std::string& out, const WorkCertificate& all, std::uint32_t number) {
  const WorkNode& node = all.nodes[number];
  const NearCell& c = node.cell;
  if (node.kind == Kind::nothing) {
    out += "nothing\n";
  } else if (node.kind == Kind::put) {
    out += fmt::format("put {} {} {} {}\n", c.du, c.dv, c.z, node.colour);
  } else {
    out += fmt::format("ask {}", kKinds[static_cast<std::size_t>(node.kind)]);
    if (node.kind == Kind::cell) out += fmt::format(" {} {} {}", c.du, c.dv, c.z);
    out += fmt::format(" {}\n", node.branches.size());
  }
  for (const auto& [answers, child] : node.branches) {
    out += fmt::format("is {}\n", fmt::join(answers, " "));
    print_node(out, all, child);
  }
}

void print_bricks(std::string& out, const WorkCertificate& all) {
  for (std::size_t i = 0; i < all.bricks.size(); ++i) {
    const WorkBrick& one = all.bricks[i];
    const Cell& at = one.brick.at;
    out += fmt::format("{} {} {} {}", at.x, at.y, at.z, one.brick.brick);
    if (all.ordered && i >= all.start) {
      out += fmt::format(" {} {} {} after", kSideNames[static_cast<std::size_t>(one.side)],
                         one.column.du, one.column.dv);
      for (const std::uint32_t before : one.after) out += fmt::format(" {}", before);
    }
    out += "\n";
  }
}

/// Says what is wrong once, and gives zeros from then on.
class Reader {
 public:
  Reader(const std::string& path, const std::string& text, Diagnostics& diagnostics)
      : path_(path), text_(text), diagnostics_(diagnostics) {}

  std::optional<WorkCertificate> read() {
    next_line();
    expect(kWorkCertificate);
    number(1, 1);
    read_claims();
    read_node(0);
    read_bricks();
    next_line();
    expect("end");
    if (!failed_ && (!words_.empty() || next_ < text_.size())) fail("nothing stands after 'end'");
    if (failed_) return std::nullopt;
    return std::move(out_);
  }

 private:
  void fail(const std::string& what) {
    if (failed_) return;
    failed_ = true;
    diagnostics_.add(Code::F470,
                     {std::make_shared<SourceFile>(path_, text_),
                      static_cast<std::uint32_t>(begin_), static_cast<std::uint32_t>(end_)},
                     what);
  }

  /// What is left of a line is one word too many.
  void next_line() {
    if (!words_.empty()) fail(fmt::format("{} is one word too many", in_quotes(words_.front())));
    words_.clear();
    begin_ = std::min(next_, text_.size());
    end_ = std::min(text_.find('\n', begin_), text_.size());
    next_ = end_ + 1;
    if (end_ > begin_ && text_[end_ - 1] == '\r') {
      fail("this line ends in CR LF; a certificate's lines end in LF alone");
    }
    for (std::size_t at = begin_; at < end_;) {
      const std::size_t stop = std::min(text_.find(' ', at), end_);
      words_.push_back(std::string_view(text_).substr(at, stop - at));
      at = stop + 1;
    }
    std::reverse(words_.begin(), words_.end());  // taken off at the end
  }
  std::string_view word() {
    if (words_.empty()) return {};
    const std::string_view out = words_.back();
    words_.pop_back();
    return out;
  }
  void expect(std::string_view expected) {
    if (word() != expected) fail(fmt::format("'{}' belongs here", expected));
  }
  std::int64_t number(std::int64_t low, std::int64_t high) {
    const std::string_view text = word();
    std::int64_t value = low;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || stop != text.data() + text.size() || value < low ||
        value > high) {
      fail(fmt::format("a number from {} to {} belongs here", low, high));
      return low;
    }
    return value;
  }
  int near() { return static_cast<int>(number(-kMostNear, kMostNear)); }
  double metres() {
    const std::string_view text = word();
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || stop != text.data() + text.size() ||
        !std::isfinite(value) || value < 0 || value > 10) {
      fail("a length in m belongs here");
      return 0;
    }
    return value;
  }
  int side() {
    const std::string_view text = word();
    const auto found = std::find(kSideNames.begin(), kSideNames.end(), text);
    if (found == kSideNames.end()) fail("a side belongs here: +x +y -x -y");
    return found == kSideNames.end() ? 0 : static_cast<int>(found - kSideNames.begin());
  }
  WorkCrowd crowd() {
    const std::string_view text = word();
    const auto found = std::find(kCrowdNames.begin(), kCrowdNames.end(), text);
    if (found == kCrowdNames.end()) fail("'any', 'one-a-side' or 'one' belongs here");
    return found == kCrowdNames.end() ? WorkCrowd::one
                                      : static_cast<WorkCrowd>(found - kCrowdNames.begin());
  }
  /// One of two words.
  bool either(std::string_view yes, std::string_view no) {
    const std::string_view text = word();
    if (text != yes && text != no) fail(fmt::format("'{}' or '{}' belongs here", yes, no));
    return text == yes;
  }

  void read_claims() {
    next_line();
    expect("rules");
    const std::string_view hash = word();
    const auto [stop, error] =
        std::from_chars(hash.data(), hash.data() + hash.size(), out_.rule_set_hash, 16);
    if (hash.size() != 16 || error != std::errc{} || stop != hash.data() + hash.size()) {
      fail("a hash of 16 hexadecimal digits belongs here");
    }
    next_line();
    expect("robots");
    out_.crowd = crowd();
    next_line();
    expect("sides");
    while (!failed_ && !words_.empty()) {
      const int one = side();
      if (std::find(out_.sides.begin(), out_.sides.end(), one) != out_.sides.end()) {
        fail("a side is named twice");
      }
      out_.sides.push_back(one);
    }
    next_line();
    while (!failed_ && !words_.empty() && words_.back() == "look") {
      word();
      if (out_.looks.size() == kMostLooks) {
        return fail(fmt::format("more than {} looks are not read", kMostLooks));
      }
      const double distance = metres();
      out_.looks.push_back({distance, metres()});
      next_line();
    }
  }

  /// The line with the node is the present one.
  std::uint32_t read_node(std::size_t depth) {
    const auto number_of_node = static_cast<std::uint32_t>(out_.nodes.size());
    out_.nodes.emplace_back();
    if (depth > kDeepest) fail("so many questions one after another are not read");
    if (failed_) return number_of_node;
    const std::string_view first = word();
    WorkNode node;
    std::int64_t branches = 0;
    if (first == "put") {
      node.kind = Kind::put;
      node.cell = cell();
      const bool on_top = node.cell.du == 0 && node.cell.dv == 0;
      if (on_top && node.cell.z != 0) fail("what is put on top of its column has 0 for a level");
      node.colour = static_cast<Colour>(number(1, kMaxColours));
    } else if (first == "ask") {
      branches = read_question(node);
    } else if (first != "nothing") {
      fail("'ask', 'put' or 'nothing' belongs here");
    }
    std::bitset<kMostAnswers> answered;
    for (std::int64_t i = 0; !failed_ && i < branches; ++i) {
      next_line();
      expect("is");
      std::vector<int> answers;
      while (!failed_ && !words_.empty()) answers.push_back(answer(answered));
      next_line();
      const std::uint32_t child = read_node(depth + 1);
      node.branches.emplace_back(std::move(answers), child);
    }
    out_.nodes[number_of_node] = std::move(node);
    return number_of_node;
  }
  /// To a question, which has each in one branch and once.
  int answer(std::bitset<kMostAnswers>& answered) {
    const auto one = static_cast<std::size_t>(number(0, kMostAnswers - 1));
    if (answered[one]) fail(fmt::format("{} is an answer twice", one));
    answered.set(one);
    return static_cast<int>(one);
  }
  NearCell cell() {
    const int du = near(), dv = near();
    return {du, dv, near()};
  }
  std::int64_t read_question(WorkNode& node) {
    const auto found = std::find(kKinds.begin(), kKinds.begin() + 4, word());
    if (found == kKinds.begin() + 4) fail("a question belongs here");
    node.kind = static_cast<Kind>(found - kKinds.begin());
    if (node.kind == Kind::cell) node.cell = cell();
    return number(0, 255);
  }

  void read_bricks() {
    next_line();
    expect("bricks");
    const std::int64_t bricks = number(1, UINT32_MAX);
    expect("start");
    out_.start = static_cast<std::size_t>(number(1, bricks));
    out_.ordered = either("ordered", "walked");
    for (std::int64_t i = 0; !failed_ && i < bricks; ++i) read_brick(i);
  }
  void read_brick(std::int64_t i) {
    next_line();
    WorkBrick one;
    std::array<std::int32_t, 3> at{};
    for (std::int32_t& c : at) {
      c = static_cast<std::int32_t>(number(-kMaxCoordinate, kMaxCoordinate));
    }
    one.brick = {{at[0], at[1], at[2]}, static_cast<Colour>(number(1, kMaxColours))};
    if (out_.ordered && i >= static_cast<std::int64_t>(out_.start)) {
      one.side = side();
      const int du = near();
      one.column = {du, near(), 0};
      expect("after");
      while (!failed_ && !words_.empty()) {
        one.after.push_back(static_cast<std::uint32_t>(number(0, i - 1)));
      }
    }
    out_.bricks.push_back(std::move(one));
  }

  const std::string& path_;
  const std::string& text_;
  Diagnostics& diagnostics_;
  WorkCertificate out_;
  std::vector<std::string_view> words_;         ///< of the line, the next one last
  std::size_t begin_ = 0, end_ = 0, next_ = 0;  ///< of the line, and where the next begins
  bool failed_ = false;
};

}  // namespace

std::string print_work_certificate(const WorkCertificate& certificate) {
  assert(!certificate.nodes.empty());
  std::string out = fmt::format("{} 1\nrules {}\nrobots {}\nsides", kWorkCertificate,
                                to_hex(certificate.rule_set_hash),
                                kCrowdNames[static_cast<std::size_t>(certificate.crowd)]);
  for (const int side : certificate.sides) {
    out += fmt::format(" {}", kSideNames[static_cast<std::size_t>(side)]);
  }
  out += "\n";
  for (const WorkLook& look : certificate.looks) {
    out += fmt::format("look {} {}\n", look.distance, look.lift);
  }
  print_node(out, certificate, 0);
  out += fmt::format("bricks {} start {} {}\n", certificate.bricks.size(), certificate.start,
                     certificate.ordered ? "ordered" : "walked");
  print_bricks(out, certificate);
  return out + "end\n";
}

std::optional<WorkCertificate> read_work_certificate(const std::string& path,
                                                     const std::string& text,
                                                     Diagnostics& diagnostics) {
  return Reader(path, text, diagnostics).read();
}

}  // namespace stig::recheck
