// SPDX-License-Identifier: MIT
#include "base/yaml_edit.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "base/text.h"

namespace stig {
namespace {

/// The entry of a list that a word means.
const YamlNode* entry_of(const YamlNode& list, std::string_view word) {
  for (const YamlNode& item : list.items) {
    const YamlNode* name = item.find("name");
    if (name != nullptr && name->text == word) return &item;
  }
  std::size_t number = 0;
  const auto end = word.data() + word.size();
  const bool whole = std::from_chars(word.data(), end, number).ptr == end;
  return whole && number >= 1 && number <= list.items.size() ? &list.items[number - 1] : nullptr;
}

const YamlNode* child_of(const YamlNode& node, std::string_view word) {
  if (node.kind == YamlKind::mapping) return node.find(word);
  return node.kind == YamlKind::sequence ? entry_of(node, word) : nullptr;
}

/// As far as a path leads: the last node, and the words that are left.
struct Way {
  const YamlNode* node = nullptr;
  std::string_view rest;
};

Way follow(const YamlNode& root, std::string_view path) {
  Way way{&root, path};
  while (!way.rest.empty()) {
    const std::size_t point = way.rest.find('.');
    const YamlNode* next = child_of(*way.node, way.rest.substr(0, point));
    if (next == nullptr) break;
    way.node = next;
    way.rest = point == way.rest.npos ? std::string_view() : way.rest.substr(point + 1);
  }
  return way;
}

/// How far a place is from the beginning of its line.
std::size_t column_of(std::string_view text, std::size_t at) {
  const std::size_t line = text.substr(0, at).rfind('\n');
  return line == text.npos ? at : at - line - 1;
}

/// Puts a new key first in a mapping: where that begins is known for both of its styles.
std::string with_key(const std::string& text, const YamlNode& mapping, std::string_view key,
                     std::string_view value) {
  const bool flow = mapping.style == YamlStyle::flow;
  const std::size_t at = mapping.begin + (flow ? 1U : 0U);
  const std::string end = !flow                   ? "\n" + std::string(column_of(text, at), ' ')
                          : mapping.pairs.empty() ? ""
                                                  : ", ";
  std::string out = text;
  return out.insert(at, fmt::format("{}: {}{}", yaml_text(key, flow), value, end));
}

}  // namespace

const YamlNode* find_node(const YamlDocument& document, std::string_view path) {
  const Way way = follow(document.root, path);
  return way.rest.empty() ? way.node : nullptr;
}

std::optional<std::string> with_value(const std::string& text, std::string_view path,
                                      std::string_view value, std::string& problem) {
  Diagnostics diagnostics;
  const auto document =
      parse_yaml(std::make_shared<const SourceFile>("", text), YamlLimits(), diagnostics);
  if (!document) {
    problem = "it is no YAML";
    return std::nullopt;
  }
  const Way way = follow(document->root, path);
  if (!way.rest.empty()) {
    const bool key = way.node->kind == YamlKind::mapping && way.rest.find('.') == way.rest.npos;
    if (key) return with_key(text, *way.node, way.rest, value);
    problem = fmt::format("there is no {} at {}",
                          in_quotes(std::string(way.rest.substr(0, way.rest.find('.')))),
                          in_quotes(std::string(path)));
    return std::nullopt;
  }
  if (way.node->end <= way.node->begin) {
    problem = fmt::format("nothing is written at {}", in_quotes(std::string(path)));
    return std::nullopt;
  }
  std::string out = text;
  // A block ends with its line, which stays one.
  std::size_t end = way.node->end;
  while (end > way.node->begin && (out[end - 1] == '\n' || out[end - 1] == ' ')) --end;
  return out.replace(way.node->begin, end - way.node->begin, value);
}

}  // namespace stig
