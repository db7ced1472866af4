// SPDX-License-Identifier: MIT
// What a table of keys (base/form.h) asks of a single node: that it is a name, a colour, a number
// within its bounds. A format's own kinds of value are checked by the same functions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/form.h"

namespace stig {

/// low..high, or above low.
struct NumberBounds {
  double low = 0, high = 0;
  bool above_low = false;
  bool whole = false;
};

/// "a rule", "an entry".
std::string with_article(std::string_view noun);

/// Is there a control character of ASCII?
bool has_control(std::string_view text);

/// Every check returns whether the node is sound, and adds it to `bad` when it is not. All that
/// it is made of must outlive it.
class NodeChecks {
 public:
  NodeChecks(const YamlDocument& document, Diagnostics& diagnostics, BadNodes& bad)
      : document_(document), out_(diagnostics), bad_(bad) {}

  /// Adds it to `bad`; false.
  bool mark(const YamlNode& node);
  /// R103; a node that is broken has been reported before. `instead` may replace it.
  bool wrong(const YamlNode& node, std::string_view wanted, std::string instead = {});
  /// R105.
  bool out_of_range(const YamlNode& node, std::string message);
  /// R106.
  bool bad_text(const YamlNode& node, std::string message, std::string instead = {});
  /// R108.
  bool unknown_version(const YamlNode& node, int known);
  bool expect(const YamlNode& node, YamlKind kind, std::string_view wanted);
  bool check_name(const YamlNode& node);
  bool check_colour(const YamlNode& node);
  bool check_boolean(const YamlNode& node);
  bool check_choice(const YamlNode& node, std::string_view key,
                    const std::vector<std::string_view>& words);
  bool check_number(const YamlNode& node, std::string_view key, const NumberBounds& bounds);
  /// A mapping with the keys of the form; `check` is called with the value and the key of each
  /// that is known.
  template <class Check>
  bool check_keys(const YamlNode& node, const Form& form, Check check);
  /// A mapping of another form, and all that is in it.
  bool check_part(const YamlNode& node, const Form& form) {
    return check_form(document_, node, form, out_, bad_);
  }
  /// Entries of a list or mapping.
  bool check_size(const YamlNode& node, std::string_view key, std::size_t size, std::size_t least,
                  std::size_t most);

 private:
  /// R103 of what is no mapping.
  bool wrong_mapping(const YamlNode& node, const Form& form);
  /// R101; marks the value.
  bool unknown_key(const YamlPair& pair, std::string_view title,
                   const std::vector<std::string_view>& known);
  /// R102, unless an unknown key of the mapping is that key misspelt; marks nothing.
  void missing_key(const YamlNode& mapping, std::string_view title, std::string_view key,
                   std::string_view doc, const std::vector<std::string_view>& known);

  const YamlDocument& document_;
  Diagnostics& out_;
  BadNodes& bad_;
};

template <class Check>
bool NodeChecks::check_keys(const YamlNode& node, const Form& form, Check check) {
  if (node.kind != YamlKind::mapping) return wrong_mapping(node, form);
  std::vector<std::string_view> known;
  for (const FormKey& key : form.keys) known.push_back(key.name);
  const auto check_pair = [&](const YamlPair& pair) {
    if (!expect(pair.key, YamlKind::scalar, "a key")) return false;
    for (const FormKey& key : form.keys) {
      if (key.name == pair.key.text) return check(pair.value, key);
    }
    return unknown_key(pair, form.title, known);
  };
  bool sound = true;
  for (const YamlPair& pair : node.pairs) sound = check_pair(pair) && sound;
  for (const FormKey& key : form.keys) {
    if (!key.required || node.find(key.name) != nullptr) continue;
    missing_key(node, form.title, key.name, key.doc, known);
    sound = false;
  }
  return sound || mark(node);
}

}  // namespace stig
