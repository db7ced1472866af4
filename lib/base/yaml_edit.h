// SPDX-License-Identifier: MIT
// One value of a YAML text put in place of another, all else as it was, comments too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/yaml.h"

namespace stig {

/// The node that a path such as "rules.grow.probability" leads to. Its words, parted by points, are
/// keys of mappings; in a list, the `name` of an entry, or its number from 1 on. Null: there is
/// none.
const YamlNode* find_node(const YamlDocument& document, std::string_view path);

/// The text with `value`, which is YAML in one line, at a path. Its last word may be a key that is
/// not there yet; all others have to be. Nothing with `problem` set where they are not, or where
/// the text is no YAML.
std::optional<std::string> with_value(const std::string& text, std::string_view path,
                                      std::string_view value, std::string& problem);

}  // namespace stig
