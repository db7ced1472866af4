// SPDX-License-Identifier: MIT
// YAML as a tree of nodes that know where they stand.
//
// Built on yaml-cpp's events (yaml_events.h), without its node type: that one keeps duplicate keys
// silently, knows starts but no ends, and follows aliases without bound. A node's
// type is left to whoever knows the key: `010` is the text "010", `yes` is a text.
// Aliases, anchors and tags are reported and leave a broken node behind.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"

namespace stig {

enum class YamlKind : std::uint8_t {
  null,  ///< nothing written, or an unquoted null or ~
  scalar,
  sequence,
  mapping,
  broken,  ///< already reported; say no more about it
};

enum class YamlStyle : std::uint8_t { plain, quoted, literal, folded, flow, block };

struct YamlPair;

struct YamlNode {
  YamlKind kind = YamlKind::null;
  YamlStyle style = YamlStyle::plain;
  std::uint32_t begin = 0, end = 0;  ///< bytes of the file
  std::string text;                  ///< of a scalar
  std::vector<YamlNode> items;       ///< of a sequence
  std::vector<YamlPair> pairs;       ///< of a mapping, in order, duplicates too

  /// The value of the first such key, or nullptr.
  const YamlNode* find(std::string_view key) const;
};

struct YamlPair {
  YamlNode key, value;
};

struct YamlComment {
  std::uint32_t begin = 0, end = 0;  ///< from the '#', without the line end
  bool trailing = false;             ///< something else stands before it on its line
};

struct YamlDocument {
  SourceRef source;
  YamlNode root;
  std::vector<YamlComment> comments;

  SourceRange range(const YamlNode& node) const { return {source, node.begin, node.end}; }
  /// The beginning of a value, enough to point at: the first key of a mapping, the
  /// bar of a block, otherwise the first line.
  SourceRange head(const YamlNode& node) const;
};

/// Finds parts of a scalar's text in the file; made once for a scalar, since it
/// looks through it. The document must outlive it.
class YamlTextMap {
 public:
  YamlTextMap(const YamlDocument& document, const YamlNode& scalar);
  /// Place of the bytes [begin, end) of the text, on one line: exact for literal
  /// blocks, one-line plain and escape-free quoted texts, otherwise the whole scalar.
  SourceRange range(std::size_t begin, std::size_t end) const;

 private:
  struct Line {
    std::size_t text, source;  ///< where it starts
  };
  SourceRange whole_;
  std::vector<Line> lines_;  ///< empty: not exact
};

struct YamlLimits {
  std::size_t bytes = std::size_t{1} << 20;
  std::size_t depth = 32;
  std::size_t nodes = 200'000;
};

/// The tree, or nothing when the text could not be parsed. Duplicate keys, aliases
/// and tags are reported and do not stop it.
std::optional<YamlDocument> parse_yaml(SourceRef source, const YamlLimits& limits,
                                       Diagnostics& diagnostics);

/// A text as YAML: plain where every reader takes it for just that text, otherwise
/// double-quoted on one line. Inside brackets fewer texts can be plain.
std::string yaml_text(std::string_view text, bool inside_flow = false);

}  // namespace stig
