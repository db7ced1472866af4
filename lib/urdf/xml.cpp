// SPDX-License-Identifier: MIT
// pugixml parses a copy in place, so that what it points at is at the same offset in the source. It
// replaces no entities but the five of XML itself and numbers.
#include "urdf/xml.h"

#include <algorithm>
#include <pugixml.hpp>

#include "base/text.h"

namespace stig::urdf {

namespace {

constexpr std::size_t kMostDepth = 32, kMostElements = 100'000;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

class XmlReader {
 public:
  XmlReader(const SourceRef& source, Diagnostics& out)
      : source_(source), out_(out), bytes_(source->text()) {}

  std::optional<XmlNode> read() {
    if (!plain_text()) return std::nullopt;
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer_inplace(
        bytes_.data(), bytes_.size(), pugi::parse_default | pugi::parse_doctype,
        pugi::encoding_utf8);
    if (!result) {
      refuse(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
             std::string("not well-formed XML: ") + result.description());
      return std::nullopt;
    }
    for (const pugi::xml_node node : document.children()) {
      if (node.type() != pugi::node_doctype) continue;
      if (std::string_view(node.value()).find('[') == std::string_view::npos) continue;
      refuse(offset(node.value()), "a document type with definitions of its own");
      return std::nullopt;
    }
    const pugi::xml_node root = document.document_element();
    std::size_t roots = 0;
    for (const pugi::xml_node node : document.children()) {
      if (node.type() == pugi::node_element && ++roots == 2) {
        refuse(offset(node.name()), "a second element beside the first");
        return std::nullopt;
      }
    }
    if (!root) {
      refuse(0, "no element");
      return std::nullopt;
    }
    XmlNode out = element(root, 1);
    if (refused_) return std::nullopt;
    return out;
  }

 private:
  bool plain_text() {
    const std::size_t zero = bytes_.find('\0');
    const std::size_t invalid = find_invalid_utf8(bytes_);
    if (zero == bytes_.npos && invalid == bytes_.npos) return true;
    refuse(std::min(zero, invalid), "not text in UTF-8");
    return false;
  }

  void refuse(std::size_t place, const std::string& message) {
    if (refused_) return;
    refused_ = true;
    const std::size_t begin = std::min(place, source_->text().size());
    const std::size_t end = std::min(begin + 1, source_->text().size());
    out_.add(Code::F430, range(begin, end), message);
  }

  SourceRange range(std::size_t begin, std::size_t end) const {
    return {source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }
  std::size_t offset(const char* inside) const {
    // An empty string is the parser's own.
    const bool ours = inside >= bytes_.data() && inside <= bytes_.data() + bytes_.size();
    return ours ? static_cast<std::size_t>(inside - bytes_.data()) : 0;
  }
  SourceRange range_of(const char* inside, std::size_t size) const {
    const std::size_t begin = offset(inside);
    return range(begin, begin + size);
  }

  XmlNode element(const pugi::xml_node& node, std::size_t depth) {
    XmlNode out;
    out.name = node.name();
    out.place = range_of(node.name(), out.name.size());
    if (depth > kMostDepth) {
      refuse(out.place.begin, "elements within elements, deeper than 32");
    } else if (++elements_ > kMostElements) {
      refuse(out.place.begin, "more than 100000 elements");
    }
    if (refused_) return out;
    for (const pugi::xml_attribute one : node.attributes()) {
      const std::string value = one.value();
      const SourceRange place = value.empty()
                                    ? range_of(one.name(), std::string_view(one.name()).size())
                                    : range_of(one.value(), value.size());
      out.attributes.push_back({one.name(), value, place});
    }
    const char* const text = node.child_value();
    const std::string_view word = trimmed(text);
    out.text = std::string(word);
    out.text_place = word.empty() ? out.place : range_of(word.data(), word.size());
    for (const pugi::xml_node child : node.children()) {
      if (child.type() == pugi::node_element) out.children.push_back(element(child, depth + 1));
      if (refused_) break;
    }
    return out;
  }

  const SourceRef& source_;
  Diagnostics& out_;
  std::string bytes_;
  std::size_t elements_ = 0;
  bool refused_ = false;
};

}  // namespace

const XmlAttribute* XmlNode::attribute(std::string_view key) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const XmlAttribute& one) { return one.name == key; });
  return found == attributes.end() ? nullptr : &*found;
}

const XmlNode* XmlNode::child(std::string_view key) const {
  const auto found = std::find_if(children.begin(), children.end(),
                                  [&](const XmlNode& one) { return one.name == key; });
  return found == children.end() ? nullptr : &*found;
}

std::vector<const XmlNode*> XmlNode::all(std::string_view key) const {
  std::vector<const XmlNode*> out;
  for (const XmlNode& one : children) {
    if (one.name == key) out.push_back(&one);
  }
  return out;
}

std::optional<XmlNode> parse_xml(const SourceRef& source, Diagnostics& diagnostics) {
  return XmlReader(source, diagnostics).read();
}

}  // namespace stig::urdf
