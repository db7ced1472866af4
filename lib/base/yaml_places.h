// SPDX-License-Identifier: MIT
// Where YAML values end and where comments stand: what a parser that only tells
// where things start leaves to be found in the text. Used by yaml.cpp.
#pragma once

#include <string_view>
#include <vector>

#include "base/yaml.h"

namespace stig {

/// End of a plain scalar with this value that starts at `begin`: the value's
/// characters are matched, folded line ends skipped.
std::size_t plain_end(std::string_view source, std::size_t begin, std::string_view value);
/// Just past the closing quote of the quoted scalar that starts at `begin`, or npos.
std::size_t quoted_end(std::string_view source, std::size_t begin);

/// The content of a block scalar (| or >) whose header starts at `begin`.
struct BlockContent {
  std::size_t begin = 0;   ///< first byte after the header's line
  std::size_t end = 0;     ///< end of the last line that is not blank
  std::size_t indent = 0;  ///< spaces before every line
};
BlockContent block_content(std::string_view source, std::size_t begin, std::string_view value);

/// Just past the bracket that closes a flow list or mapping, looked for from
/// `from` (the end of its last entry); comments are skipped.
std::size_t flow_end(std::string_view source, std::size_t from, char bracket);

/// Past anchors and tags that stand before a value.
std::size_t skip_properties(std::string_view source, std::size_t begin);

/// Every comment outside the given ranges of scalars, which are in rising order.
struct ScalarSpan {
  std::size_t begin, end;
};
std::vector<YamlComment> find_comments(std::string_view source,
                                       const std::vector<ScalarSpan>& scalars);

}  // namespace stig
