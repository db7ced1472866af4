// SPDX-License-Identifier: MIT
// The one file that knows yaml-cpp. Its exceptions end here.
//
// Its events are turned into a tree whose nodes have both ends; yaml-cpp marks only where
// things begin, so ends are found in the text (yaml_places.h).
#include "base/yaml.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <cassert>
#include <sstream>
#include <unordered_map>

#include "base/text.h"
#include "base/yaml_places.h"
#include "base/yaml_syntax.h"

namespace stig {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Thrown through the parser to end it; the reason has been reported.
struct Stop {};

/// Builds the tree from the parser's events.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const SourceRef& source, std::size_t base, const YamlLimits& limits,
              Diagnostics& diagnostics)
      : source_(source), text_(source->text()), base_(base), limits_(limits), out_(diagnostics) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ == 0) return;
    const std::size_t at = offset(mark);
    const std::string_view before = text_.substr(last_end_, at - std::min(at, last_end_));
    const bool marker = before.find("---") != std::string_view::npos || starts_with(at, "---");
    if (marker) {
      out_.add(Code::R009, range(at, at + 1), "a second YAML document starts here");
    } else {
      out_.add(Code::R006, range(at, at + 1),
               "nothing can follow here: the value before is complete");
    }
    throw Stop();
  }
  void OnDocumentEnd() override {}

  // A null has no text of its own. It is placed at the next sign of punctuation, where a
  // value is missing, or after what came before.
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {
    std::size_t at = last_end_;
    while (at < text_.size() &&
           std::string_view(" \t\r\n").find(text_[at]) != std::string_view::npos)
      ++at;
    if (at >= text_.size() || std::string_view(":-,?").find(text_[at]) == std::string_view::npos) {
      at = last_end_;
    }
    YamlNode node;
    node.begin = narrow(at);
    node.end = narrow(std::min(at + 1, text_.size()));
    put(std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    const std::size_t at = offset(mark);
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n,]}", at), text_.size());
    out_.add(Code::R010, range(at, end), "aliases are not allowed");
    put(broken(at, end));
  }

  void OnAnchor(const YAML::Mark& mark, const std::string& name) override {
    const std::size_t at = offset(mark);
    out_.add(Code::R010, range(at, at + 1 + name.size()),
             fmt::format("anchors are not allowed: {}", in_quotes("&" + name)));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    const std::size_t at = after_properties(mark, tag);
    YamlNode node;
    node.kind = YamlKind::scalar;
    node.text = value;
    node.begin = narrow(at);
    place_scalar(node, tag != "?");
    put(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value style) override {
    open(YamlKind::sequence, mark, tag, style);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value style) override {
    open(YamlKind::mapping, mark, tag, style);
  }
  void OnSequenceEnd() override { close(']'); }
  // Duplicates are looked for when a mapping is complete.
  void OnMapEnd() override {
    const bool in_list =
        stack_.size() > 1 && stack_[stack_.size() - 2].node.kind == YamlKind::sequence;
    report_duplicates(stack_.back().node, in_list);
    close('}');
  }

  YamlNode take_root() { return std::move(root_); }
  bool has_root() const { return has_root_; }
  const std::vector<ScalarSpan>& spans() const { return spans_; }

 private:
  struct Frame {
    YamlNode node;
    YamlNode key;
    bool has_key = false;
  };

  std::size_t offset(const YAML::Mark& mark) const {
    const std::size_t pos = mark.pos < 0 ? 0 : static_cast<std::size_t>(mark.pos);
    return std::min(base_ + pos, text_.size());
  }
  static std::uint32_t narrow(std::size_t value) { return static_cast<std::uint32_t>(value); }
  SourceRange range(std::size_t begin, std::size_t end) const {
    return {source_, narrow(begin), narrow(std::min(end, text_.size()))};
  }
  bool starts_with(std::size_t at, std::string_view what) const {
    return text_.substr(at, what.size()) == what;
  }
  YamlNode broken(std::size_t begin, std::size_t end) const {
    YamlNode node;
    node.kind = YamlKind::broken;
    node.begin = narrow(begin);
    node.end = narrow(end);
    return node;
  }

  /// Reports a tag; the offset of the value itself.
  std::size_t after_properties(const YAML::Mark& mark, const std::string& tag) {
    const std::size_t at = offset(mark);
    if (!tag.empty() && tag != "?" && tag != "!") {
      const std::size_t end = std::min(text_.find_first_of(" \t\r\n,]}", at), text_.size());
      out_.add(Code::R011, range(at, end), fmt::format("tags are not allowed: {}", in_quotes(tag)));
    }
    return skip_properties(text_, at);
  }

  /// The parser takes the end of the file for the quote that is missing.
  [[noreturn]] void unclosed_quote(std::size_t at) {
    out_.add(Code::R006, range(at, at + 1), "this quote is not closed");
    throw Stop();
  }

  void place_scalar(YamlNode& node, bool not_plain) {
    const char first = node.begin < text_.size() ? text_[node.begin] : '\0';
    std::size_t span_begin = node.begin;
    if (not_plain && (first == '"' || first == '\'')) {
      node.style = YamlStyle::quoted;
      const std::size_t end = quoted_end(text_, node.begin);
      if (end == std::string_view::npos) unclosed_quote(node.begin);
      node.end = narrow(end);
    } else if (not_plain && (first == '|' || first == '>')) {
      node.style = first == '|' ? YamlStyle::literal : YamlStyle::folded;
      const BlockContent content = block_content(text_, node.begin, node.text);
      // Without content the scalar is its header's indicator alone.
      const bool bare = content.end <= content.begin;
      node.end = narrow(bare ? node.begin + 1 : content.end);
      span_begin = bare ? node.begin : content.begin;
    } else {
      node.end = narrow(plain_end(text_, node.begin, node.text));
    }
    if (span_begin < node.end) spans_.push_back({span_begin, node.end});
  }

  void open(YamlKind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::EmitterStyle::value style) {
    const std::size_t at = after_properties(mark, tag);
    if (stack_.size() >= limits_.depth) {
      out_.add(Code::R007, range(at, at + 1),
               fmt::format("nested deeper than {} levels", limits_.depth));
      throw Stop();
    }
    Frame frame;
    frame.node.kind = kind;
    const bool flow = style == YAML::EmitterStyle::Flow && at < text_.size() &&
                      (text_[at] == '[' || text_[at] == '{');
    frame.node.style = flow ? YamlStyle::flow : YamlStyle::block;
    frame.node.begin = frame.node.end = narrow(at);
    if (flow) last_end_ = std::max(last_end_, at + 1);
    stack_.push_back(std::move(frame));
    count_node(at);
  }

  void close(char bracket) {
    assert(!stack_.empty());
    YamlNode node = std::move(stack_.back().node);
    stack_.pop_back();
    const std::size_t inner = std::max<std::size_t>(last_end_, node.begin);
    node.end = narrow(node.style == YamlStyle::flow ? flow_end(text_, inner, bracket) : inner);
    --nodes_;  // counted when opened
    put(std::move(node));
  }

  // Depth and number of nodes are bounded while the tree grows, so hostile input cannot
  // exhaust stack or memory.
  void count_node(std::size_t at) {
    if (++nodes_ <= limits_.nodes) return;
    out_.add(Code::R008, range(at, at + 1), fmt::format("more than {} values", limits_.nodes));
    throw Stop();
  }

  void put(YamlNode node) {
    count_node(node.begin);
    last_end_ = std::max<std::size_t>(last_end_, node.end);
    if (stack_.empty()) {
      root_ = std::move(node);
      has_root_ = true;
      return;
    }
    Frame& frame = stack_.back();
    if (frame.node.kind == YamlKind::sequence) {
      frame.node.items.push_back(std::move(node));
    } else if (!frame.has_key) {
      frame.key = std::move(node);
      frame.has_key = true;
    } else {
      frame.node.pairs.push_back({std::move(frame.key), std::move(node)});
      frame.has_key = false;
    }
  }

  void report_duplicates(const YamlNode& mapping, bool in_list) {
    std::unordered_map<std::string_view, const YamlNode*> seen;
    for (const YamlPair& pair : mapping.pairs) {
      if (pair.key.kind != YamlKind::scalar) continue;
      const auto [first, added] = seen.emplace(pair.key.text, &pair.key);
      if (added) continue;
      Diagnostic& diagnostic =
          out_.add(Code::R012, range(pair.key.begin, pair.key.end),
                   fmt::format("the key {} stands here twice", in_quotes(pair.key.text)))
              .note(range(first->second->begin, first->second->end), "the first one");
      // The key that begins an entry, again: its other keys would only be named one by one.
      if (!in_list || first->second != &mapping.pairs[0].key) continue;
      diagnostic.note(fmt::format("if another entry of the list begins here, write '- {}:'",
                                  printable(pair.key.text)));
      return;
    }
  }

  SourceRef source_;
  std::string_view text_;
  std::size_t base_;  ///< bytes before what the parser is given
  const YamlLimits& limits_;
  Diagnostics& out_;
  std::vector<Frame> stack_;
  YamlNode root_;
  bool has_root_ = false;
  int documents_ = 0;
  std::size_t nodes_ = 0;
  std::size_t last_end_ = 0;
  std::vector<ScalarSpan> spans_;
};

/// Bytes that no YAML text has; yaml-cpp would even take some for the end. They are
/// looked for before anything is parsed: afterwards every offset points at valid UTF-8.
bool check_bytes(const SourceRef& source, const YamlLimits& limits, Diagnostics& diagnostics) {
  const std::string& text = source->text();
  if (text.size() > limits.bytes) {
    diagnostics.add(Code::R002, {source, 0, 0},
                    fmt::format("the file has {} bytes, more than the {} that are read",
                                text.size(), limits.bytes));
    return false;
  }
  const auto is_control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
  };
  const auto control = std::find_if(text.begin(), text.end(), is_control);
  if (control != text.end()) {
    const auto at = static_cast<std::uint32_t>(control - text.begin());
    diagnostics.add(Code::R003, {source, at, at + 1},
                    fmt::format("control character 0x{:02x}", static_cast<unsigned>(*control)));
    return false;
  }
  const std::size_t invalid = find_invalid_utf8(text);
  if (invalid != std::string::npos) {
    const auto at = static_cast<std::uint32_t>(invalid);
    diagnostics.add(Code::R004, {source, at, at + 1}, "this byte is not UTF-8");
    return false;
  }
  return true;
}

/// Runs the parser over all documents; false when it had to stop.
bool run_parser(const SourceRef& source, std::size_t base, TreeBuilder& builder,
                Diagnostics& diagnostics) {
  try {
    // The stream begins after a byte order mark; marks from the parser are shifted back by
    // `base`.
    std::istringstream stream(source->text().substr(base));
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    return true;
  } catch (const Stop&) {
    return false;
  } catch (const YAML::Exception& error) {
    const bool placed = error.mark.pos >= 0;
    report_syntax(source,
                  placed ? base + static_cast<std::size_t>(error.mark.pos) : source->text().size(),
                  error.msg, diagnostics);
    return false;
  }
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
  for (const YamlPair& pair : pairs) {
    if (pair.key.kind == YamlKind::scalar && pair.key.text == key) return &pair.value;
  }
  return nullptr;
}

std::optional<YamlDocument> parse_yaml(SourceRef source, const YamlLimits& limits,
                                       Diagnostics& diagnostics) {
  if (!check_bytes(source, limits, diagnostics)) return std::nullopt;
  const bool marked = source->text().compare(0, kByteOrderMark.size(), kByteOrderMark) == 0;
  const std::size_t base = marked ? kByteOrderMark.size() : 0;
  TreeBuilder builder(source, base, limits, diagnostics);
  if (!run_parser(source, base, builder, diagnostics)) return std::nullopt;
  YamlDocument document{source, {}, {}};
  if (builder.has_root()) document.root = builder.take_root();
  if (document.root.kind == YamlKind::null) {
    diagnostics.add(Code::R005, {source, 0, 0}, "the file is empty");
    return std::nullopt;
  }
  document.comments = find_comments(source->text(), builder.spans());
  return document;
}

SourceRange YamlDocument::head(const YamlNode& node) const {
  if (node.style == YamlStyle::block && !node.pairs.empty()) return range(node.pairs[0].key);
  if (node.style == YamlStyle::literal || node.style == YamlStyle::folded) {
    return {source, node.begin, node.begin + 1};
  }
  const std::size_t line_end =
      std::min(source->text().find('\n', node.begin), source->text().size());
  return {source, node.begin,
          static_cast<std::uint32_t>(std::min<std::size_t>(node.end, line_end))};
}

/// Literal blocks map line by line; other texts only if they stand in the file just as they
/// are.
YamlTextMap::YamlTextMap(const YamlDocument& document, const YamlNode& scalar)
    : whole_(document.range(scalar)) {
  const std::string_view all = document.source->text();
  if (scalar.style == YamlStyle::literal) {
    const BlockContent content = block_content(all, scalar.begin, scalar.text);
    std::size_t source = content.begin;
    for (std::size_t text = 0; text < scalar.text.size();) {
      lines_.push_back({text, source + content.indent});
      text = std::min(scalar.text.find('\n', text), scalar.text.size()) + 1;
      source = std::min(all.find('\n', source), all.size() - 1) + 1;
    }
    return;
  }
  const std::size_t quote = scalar.style == YamlStyle::quoted ? 1 : 0;
  const std::string_view written = all.substr(scalar.begin, scalar.end - scalar.begin);
  const bool same = written.size() == scalar.text.size() + 2 * quote &&
                    written.substr(quote, scalar.text.size()) == scalar.text;
  if (same) lines_.push_back({0, scalar.begin + quote});
}

SourceRange YamlTextMap::range(std::size_t begin, std::size_t end) const {
  assert(begin <= end);
  const auto next =
      std::upper_bound(lines_.begin(), lines_.end(), begin,
                       [](std::size_t at, const Line& line) { return at < line.text; });
  if (next == lines_.begin()) return whole_;
  const Line& line = *std::prev(next);
  const std::size_t from = line.source + (begin - line.text);
  const std::size_t to = std::min<std::size_t>(from + (end - begin), whole_.end);
  if (from >= to) return whole_;
  return {whole_.file, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)};
}

}  // namespace stig
