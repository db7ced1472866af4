// SPDX-License-Identifier: MIT
// What is reported here stands in the order of the text; what ends all sets `stopped_`, after which
// nothing is added any more.
#include "base/yaml_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <unordered_map>
#include <utility>

#include "base/text.h"

namespace stig {

namespace {

std::uint32_t narrow_place(std::size_t value) { return static_cast<std::uint32_t>(value); }

YamlNode broken_node(std::size_t begin, std::size_t end) {
  YamlNode node;
  node.kind = YamlKind::broken;
  node.begin = narrow_place(begin);
  node.end = narrow_place(end);
  return node;
}

/// Where a word ends that is no value: an alias, a tag.
std::size_t word_end(std::string_view text, std::size_t at) {
  return std::min(text.find_first_of(" \t\r\n,]}", at), text.size());
}

}  // namespace

YamlTree::YamlTree(const SourceRef& source, std::size_t base, const YamlLimits& limits,
                   Diagnostics& diagnostics)
    : source_(source), text_(source->text()), base_(base), limits_(limits), out_(diagnostics) {}

bool YamlTree::take(const YamlEvent& event) {
  using Kind = YamlEvent::Kind;
  assert(!stopped_);
  const std::size_t at = std::min(base_ + event.at, text_.size());
  switch (event.kind) {
    case Kind::document:
      begin_document(at);
      break;
    case Kind::null:
      add_null();
      break;
    case Kind::alias:
      add_alias(at);
      break;
    case Kind::anchor:
      add_anchor(at, event.text);
      break;
    case Kind::scalar:
      add_scalar(at, event);
      break;
    case Kind::sequence:
      open(YamlKind::sequence, at, event);
      break;
    case Kind::mapping:
      open(YamlKind::mapping, at, event);
      break;
    case Kind::sequence_end:
      close(']');
      break;
    case Kind::mapping_end: {
      // Duplicates are looked for when a mapping is complete.
      const bool in_list =
          stack_.size() > 1 && stack_[stack_.size() - 2].node.kind == YamlKind::sequence;
      report_duplicates(stack_.back().node, in_list);
      close('}');
      break;
    }
  }
  return !stopped_;
}

void YamlTree::begin_document(std::size_t at) {
  if (documents_++ == 0) return;
  const std::string_view before = text_.substr(last_end_, at - std::min(at, last_end_));
  const bool marker = before.find("---") != std::string_view::npos || starts_with(at, "---");
  if (marker) {
    out_.add(Code::R009, range(at, at + 1), "a second YAML document starts here");
  } else {
    out_.add(Code::R006, range(at, at + 1),
             "nothing can follow here: the value before is complete");
  }
  stopped_ = true;
}

// A null has no text of its own. It is placed at the next sign of punctuation, where a
// value is missing, or after what came before.
void YamlTree::add_null() {
  std::size_t at = last_end_;
  while (at < text_.size() && std::string_view(" \t\r\n").find(text_[at]) != std::string_view::npos)
    ++at;
  if (at >= text_.size() || std::string_view(":-,?").find(text_[at]) == std::string_view::npos) {
    at = last_end_;
  }
  YamlNode node;
  node.begin = narrow_place(at);
  node.end = narrow_place(std::min(at + 1, text_.size()));
  put(std::move(node));
}

void YamlTree::add_alias(std::size_t at) {
  const std::size_t end = word_end(text_, at);
  out_.add(Code::R010, range(at, end), "aliases are not allowed");
  put(broken_node(at, end));
}

void YamlTree::add_anchor(std::size_t at, const std::string& name) {
  out_.add(Code::R010, range(at, at + 1 + name.size()),
           fmt::format("anchors are not allowed: {}", in_quotes("&" + name)));
}

void YamlTree::add_scalar(std::size_t at, const YamlEvent& event) {
  YamlNode node;
  node.kind = YamlKind::scalar;
  node.text = event.text;
  node.begin = narrow_place(after_properties(at, event.tag));
  place_scalar(node, event.tag != "?");
  if (!stopped_) put(std::move(node));
}

SourceRange YamlTree::range(std::size_t begin, std::size_t end) const {
  return {source_, narrow_place(begin), narrow_place(std::min(end, text_.size()))};
}

bool YamlTree::starts_with(std::size_t at, std::string_view what) const {
  return text_.substr(at, what.size()) == what;
}

/// Reports a tag; the offset of the value itself.
std::size_t YamlTree::after_properties(std::size_t at, const std::string& tag) {
  if (!tag.empty() && tag != "?" && tag != "!") {
    out_.add(Code::R011, range(at, word_end(text_, at)),
             fmt::format("tags are not allowed: {}", in_quotes(tag)));
  }
  return skip_properties(text_, at);
}

void YamlTree::place_scalar(YamlNode& node, bool not_plain) {
  const char first = node.begin < text_.size() ? text_[node.begin] : '\0';
  std::size_t span_begin = node.begin;
  if (not_plain && (first == '"' || first == '\'')) {
    node.style = YamlStyle::quoted;
    const std::size_t end = quoted_end(text_, node.begin);
    if (end == std::string_view::npos) {
      // The parser takes the end of the file for the quote that is missing.
      out_.add(Code::R006, range(node.begin, node.begin + 1), "this quote is not closed");
      stopped_ = true;
      return;
    }
    node.end = narrow_place(end);
  } else if (not_plain && (first == '|' || first == '>')) {
    place_block(node, span_begin);
  } else {
    node.end = narrow_place(plain_end(text_, node.begin, node.text));
  }
  if (span_begin < node.end) spans_.push_back({span_begin, node.end});
}

void YamlTree::place_block(YamlNode& node, std::size_t& span_begin) {
  node.style = text_[node.begin] == '|' ? YamlStyle::literal : YamlStyle::folded;
  const BlockContent content = block_content(text_, node.begin, node.text);
  // Without content the scalar is its header's indicator alone.
  const bool bare = content.end <= content.begin;
  node.end = narrow_place(bare ? node.begin + 1 : content.end);
  span_begin = bare ? node.begin : content.begin;
}

void YamlTree::open(YamlKind kind, std::size_t begin, const YamlEvent& event) {
  const std::size_t at = after_properties(begin, event.tag);
  if (stack_.size() >= limits_.depth) {
    out_.add(Code::R007, range(at, at + 1),
             fmt::format("nested deeper than {} levels", limits_.depth));
    stopped_ = true;
    return;
  }
  Frame frame;
  frame.node.kind = kind;
  const bool flow = event.flow && at < text_.size() && (text_[at] == '[' || text_[at] == '{');
  frame.node.style = flow ? YamlStyle::flow : YamlStyle::block;
  frame.node.begin = frame.node.end = narrow_place(at);
  if (flow) last_end_ = std::max(last_end_, at + 1);
  stack_.push_back(std::move(frame));
  count_node(at);
}

void YamlTree::close(char bracket) {
  assert(!stack_.empty());
  YamlNode node = std::move(stack_.back().node);
  stack_.pop_back();
  const std::size_t inner = std::max<std::size_t>(last_end_, node.begin);
  node.end = narrow_place(node.style == YamlStyle::flow ? flow_end(text_, inner, bracket) : inner);
  --nodes_;  // counted when opened
  put(std::move(node));
}

// Depth and number of nodes are bounded while the tree grows, so hostile input cannot
// exhaust stack or memory.
void YamlTree::count_node(std::size_t at) {
  if (++nodes_ <= limits_.nodes) return;
  out_.add(Code::R008, range(at, at + 1), fmt::format("more than {} values", limits_.nodes));
  stopped_ = true;
}

void YamlTree::put(YamlNode node) {
  count_node(node.begin);
  if (stopped_) return;
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

void YamlTree::report_duplicates(const YamlNode& mapping, bool in_list) {
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

}  // namespace stig
