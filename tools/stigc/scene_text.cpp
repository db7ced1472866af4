// SPDX-License-Identifier: MIT
// The scene that is written for a user must be the one that was run, duration included: so the text
// is changed and not what was read. Through the parser, since "duration:" may stand in a comment.
#include "scene_text.h"

#include <fmt/format.h>

#include <memory>

#include "base/yaml.h"

namespace stig::cli {
namespace {

/// The scene's mapping; nothing where the text is none.
std::optional<YamlNode> mapping_of(const std::string& text) {
  Diagnostics ignored;
  auto document = parse_yaml(std::make_shared<const SourceFile>("scene", text), {}, ignored);
  if (!document || document->root.kind != YamlKind::mapping) return std::nullopt;
  return std::move(document->root);
}

std::string with_key(std::string text, const YamlNode& root, std::string_view key,
                     std::string_view value) {
  if (root.style == YamlStyle::flow) {
    // {…}: the key goes inside the braces.
    return text.insert(root.begin + 1, fmt::format("{}: {}, ", key, value));
  }
  if (!text.ends_with('\n')) text += '\n';
  return text + fmt::format("{}: {}\n", key, value);
}

}  // namespace

std::string with_duration(std::string text, double seconds) {
  const std::optional<YamlNode> root = mapping_of(text);
  if (!root) return text;
  const std::string value = fmt::format("{}", seconds);
  if (const YamlNode* old = root->find("duration")) {
    // Anything but a scalar is an error that the reader is to see.
    return old->kind == YamlKind::scalar ? text.replace(old->begin, old->end - old->begin, value)
                                         : text;
  }
  return with_key(std::move(text), *root, "duration", value);
}

std::string with_default(std::string text, std::string_view key, std::string_view value) {
  const std::optional<YamlNode> root = mapping_of(text);
  if (!root || root->find(key) != nullptr) return text;
  return with_key(std::move(text), *root, key, value);
}

}  // namespace stig::cli
