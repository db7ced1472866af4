// SPDX-License-Identifier: MIT
// XML as a tree of elements that know where they stand, without the parser's own types.
//
// Size, depth and number of elements are bounded, and definitions of entities are refused: files
// come from anywhere. Of an element's text only the first piece is kept, which is all that robots'
// descriptions have.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "urdf/uses.h"

namespace stig::urdf {

struct XmlAttribute {
  std::string name, value;
  SourceRange place;  ///< of the value
};

struct XmlNode {
  std::string name, text;  ///< without white space around it
  SourceRange place;       ///< of the name
  SourceRange text_place;
  std::vector<XmlAttribute> attributes;
  std::vector<XmlNode> children;

  /// The first such, or null.
  const XmlAttribute* attribute(std::string_view key) const;
  const XmlNode* child(std::string_view key) const;
  std::vector<const XmlNode*> all(std::string_view key) const;
};

/// The root element; nothing with F430 reported when the text is no such XML.
std::optional<XmlNode> parse_xml(const SourceRef& source, Diagnostics& diagnostics);

}  // namespace stig::urdf
