// SPDX-License-Identifier: MIT
// What a parser of YAML says as it goes, without the parser: the tree (yaml_tree.h) is made of this
// alone, so that another parser can stand in where yaml-cpp cannot come along, as in a browser.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace stig {

struct YamlEvent {
  enum class Kind : std::uint8_t {
    document,  ///< begins
    null,      ///< nothing written, or an unquoted null or ~
    alias,
    anchor,  ///< of the node whose event comes next
    scalar,
    sequence,
    mapping,
    sequence_end,
    mapping_end,
  };
  Kind kind = Kind::document;
  std::size_t at = 0;  ///< byte at which it begins, tag and anchor included
  std::string text;    ///< of a scalar; the name of an anchor
  std::string tag;     ///< "?" for a plain scalar without one, "!" or nothing otherwise
  bool flow = false;   ///< a sequence or mapping in brackets
};

/// Where and why a text is no YAML.
struct YamlFault {
  std::optional<std::size_t> at;  ///< left out: at the end
  std::string reason;             ///< in the words of yaml-cpp
};

/// Hands the events of a text to `take`, in order, until it returns false or the text is found to
/// be no YAML.
std::optional<YamlFault> parse_events(const std::string& text,
                                      const std::function<bool(const YamlEvent&)>& take);

}  // namespace stig
