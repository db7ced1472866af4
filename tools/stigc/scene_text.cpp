// SPDX-License-Identifier: MIT
// The scene that is written for a user must be the one that was run, duration included: so the text
// is changed and not what was read. Through the parser, since "duration:" may stand in a comment.
#include "scene_text.h"

#include <fmt/format.h>

#include <memory>

#include "base/yaml.h"

namespace stig {

std::string with_duration(std::string text, double seconds) {
  Diagnostics ignored;
  const auto document = parse_yaml(std::make_shared<const SourceFile>("scene", text), {}, ignored);
  if (!document || document->root.kind != YamlKind::mapping) return text;
  const YamlNode& root = document->root;
  if (const YamlNode* old = root.find("duration")) {
    // Anything but a scalar is an error that the reader is to see.
    return old->kind == YamlKind::scalar
               ? text.replace(old->begin, old->end - old->begin, fmt::format("{}", seconds))
               : text;
  }
  if (root.style == YamlStyle::flow) {
    // {…}: the key goes inside the braces.
    return text.insert(root.begin + 1, fmt::format("duration: {}, ", seconds));
  }
  if (!text.ends_with('\n')) text += '\n';
  return text + fmt::format("duration: {}\n", seconds);
}

}  // namespace stig
