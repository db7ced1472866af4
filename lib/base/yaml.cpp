// SPDX-License-Identifier: MIT
// From bytes to a document: what no YAML text has is refused, the parser's events (yaml_events.h)
// become a tree (yaml_tree.h), and what the parser refuses is said in plainer words.
#include "base/yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/text_bytes.h"
#include "base/yaml_events.h"
#include "base/yaml_places.h"
#include "base/yaml_syntax.h"
#include "base/yaml_tree.h"

namespace stig {

namespace {

/// yaml-cpp would even take some bytes for the end. They are looked for before anything is parsed:
/// afterwards every offset points at valid UTF-8.
bool check_bytes(const SourceRef& source, const YamlLimits& limits, Diagnostics& diagnostics) {
  const std::string& text = source->text();
  if (text.size() > limits.bytes) {
    diagnostics.add(Code::R002, {source, 0, 0},
                    fmt::format("the file has {} bytes, more than the {} that are read",
                                text.size(), limits.bytes));
    return false;
  }
  return is_text(source, diagnostics);
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
  const bool marked = source->text().starts_with(kByteOrderMark);
  const std::size_t base = marked ? kByteOrderMark.size() : 0;
  YamlTree tree(source, base, limits, diagnostics);
  // The parser's text begins after a byte order mark; the tree shifts its places back by `base`.
  const auto fault = parse_events(source->text().substr(base),
                                  [&](const YamlEvent& event) { return tree.take(event); });
  if (fault) {
    report_syntax(source, fault->at ? base + *fault->at : source->text().size(), fault->reason,
                  diagnostics);
  }
  if (fault || tree.stopped()) return std::nullopt;
  YamlDocument document{source, {}, {}};
  if (tree.has_root()) document.root = tree.take_root();
  if (document.root.kind == YamlKind::null) {
    diagnostics.add(Code::R005, {source, 0, 0}, "the file is empty");
    return std::nullopt;
  }
  document.comments = find_comments(source->text(), tree.spans());
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
