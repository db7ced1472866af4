// SPDX-License-Identifier: MIT
// Reading the members of a struct that need nothing but the node under their key: numbers,
// words, truth values, cells. Symbols and drawings, which need the rest of the file, and lists
// of mappings are for rule_reader.cpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/yaml.h"
#include "rules/key_field.h"
#include "rules/rule_schema.h"
#include "rules/rule_set.h"

namespace stig::rules {

/// Reads a tree whose shape has been checked; nodes in `bad` are passed over. All that it is
/// made of must outlive it.
class PlainReader {
 public:
  PlainReader(const YamlDocument& document, const BadNodes& bad) : document_(document), bad_(bad) {}

  bool is_good(const YamlNode& node) const { return bad_.count(&node) == 0; }
  /// What stands under a key, or `a/b`, when it is there and of the right shape.
  const YamlNode* good(const YamlNode& mapping, std::string_view path) const;
  /// Where the key itself stands.
  SourceRange key_range(const YamlNode& mapping, std::string_view key) const;

  /// Fills in the plain members of a mapping; those whose keys are absent stay as they are.
  template <HasFields T>
  void read(const YamlNode& mapping, const Form& form, T& object) const;

  /// A member is plain when there is a function for its type here; a Colour is a symbol, and
  /// so none of them.
  static void read_value(const YamlNode& node, const FormKey& key, bool& value);
  static void read_value(const YamlNode& node, const FormKey& key, int& value);
  static void read_value(const YamlNode& node, const FormKey& key, std::int64_t& value);
  static void read_value(const YamlNode& node, const FormKey& key, double& value);
  /// Without spaces and line ends behind it.
  static void read_value(const YamlNode& node, const FormKey& key, std::string& value);
  static void read_value(const YamlNode& node, const FormKey& key, Offset& value);
  static void read_value(const YamlNode& node, const FormKey& key, Cell& value);
  static void read_value(const YamlNode& node, const FormKey& key, std::vector<std::string>& value);
  /// The enumerator whose position the word has in the schema.
  template <class T>
  requires std::is_enum_v<T>
  static void read_value(const YamlNode& node, const FormKey& key, T& value) {
    const auto word = std::find(key.words.begin(), key.words.end(), node.text);
    value = static_cast<T>(word - key.words.begin());
  }
  template <class T>
  requires(!HasFields<T>) static void read_value(const YamlNode& node, const FormKey& key,
                                                 std::optional<T>& value) {
    read_value(node, key, value.emplace());
  }

 private:
  const YamlDocument& document_;
  const BadNodes& bad_;
};

template <HasFields T>
void PlainReader::read(const YamlNode& mapping, const Form& form, T& object) const {
  for_each_field(object, [&](const auto& field) {
    const YamlNode* node = field.key.empty() ? nullptr : good(mapping, field.key);
    if (node == nullptr) return;
    const FormKey& key = key_of(form, field.key);
    if constexpr (requires { read_value(*node, key, field.value); }) {
      read_value(*node, key, field.value);
    }
  });
}

}  // namespace stig::rules
