// SPDX-License-Identifier: MIT
// Values of a rule set as its file has them: one way for each type, whatever the key.
//
//     const ValueTexts texts(rules);
//     texts.mapping(*rules.box, BoxSpec(), box_form());   // "{size: [9, 9, 4]}"
#pragma once

#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "rules/key_field.h"
#include "rules/rule_schema.h"
#include "rules/rule_set.h"

namespace stig::rules {

/// A key with its value as it is written. A drawing's rows stand below.
struct KeyText {
  std::string key, text, rows;
};

/// The rule set gives symbols their meaning; it must outlive this.
class ValueTexts {
 public:
  explicit ValueTexts(const RuleSet& rules) : rules_(rules) {}

  /// The keys of a mapping that are written, in the order of the schema: those that are
  /// required, and those that do not say what `usual` says anyway. `in_line`: within a
  /// mapping on one line, where more texts need quotes.
  template <HasFields T>
  std::vector<KeyText> keys(const T& object, const T& usual, const Form& form, bool in_line) const;
  /// "{key: value, …}"
  template <HasFields T>
  std::string mapping(const T& object, const T& usual, const Form& form) const {
    return in_braces(keys(object, usual, form, true));
  }

  std::string text(const std::string& value, const FormKey& key, bool in_line) const;
  /// true or false; of a choice of two words the first is true.
  std::string text(bool value, const FormKey& key, bool in_line) const;
  std::string text(Colour value, const FormKey& key, bool in_line) const;
  std::string text(std::int64_t value, const FormKey& key, bool in_line) const;
  std::string text(double value, const FormKey& key, bool in_line) const;
  std::string text(Offset value, const FormKey& key, bool in_line) const;
  std::string text(Cell value, const FormKey& key, bool in_line) const;
  std::string text(StateSet value, const FormKey& key, bool in_line) const;
  std::string text(const Pattern& value, const FormKey& key, bool in_line) const;
  /// A structure that is drawn.
  std::string text(const std::vector<PlacedBrick>& value, const FormKey& key, bool in_line) const;
  std::string text(const std::vector<std::string>& words, const FormKey& key, bool in_line) const;
  std::string text(const std::map<int, std::int64_t>& value, const FormKey& key,
                   bool in_line) const;

  std::string text(int value, const FormKey& key, bool in_line) const {
    return text(std::int64_t{value}, key, in_line);
  }
  template <class T>
  requires std::is_enum_v<T> std::string text(T value, const FormKey& key, bool /*in_line*/)
  const { return std::string(key.words[static_cast<std::size_t>(value)]); }
  template <HasFields T>
  std::string text(const T& object, const FormKey& key, bool /*in_line*/) const {
    return mapping(object, T(), *key.form);
  }
  template <HasFields T>
  std::string text(const std::vector<T>& list, const FormKey& key, bool /*in_line*/) const {
    std::string out;
    for (const T& object : list) {
      out += (out.empty() ? "" : ", ") + mapping(object, T(), *key.form);
    }
    return "[" + out + "]";
  }
  template <class T>
  std::string text(const std::optional<T>& value, const FormKey& key, bool in_line) const {
    return value ? text(*value, key, in_line) : std::string();
  }

  /// Symbols in brackets that together stand for a set of states; one of the legend's in
  /// their place only `by_legend`.
  std::string state_list(StateSet states, bool by_legend) const;

 private:
  static std::string in_braces(const std::vector<KeyText>& keys);
  /// The keys of a mapping from what is written by path, nested ones gathered.
  static std::vector<KeyText> in_order(std::map<std::string, KeyText>& written, const Form& form);

  template <class T>
  std::string rows(const T& /*value*/) const {
    return {};
  }
  std::string rows(const Pattern& pattern) const;
  std::string rows(const std::vector<PlacedBrick>& structure) const;

  const RuleSet& rules_;
};

template <HasFields T>
std::vector<KeyText> ValueTexts::keys(const T& object, const T& usual, const Form& form,
                                      bool in_line) const {
  std::map<std::string, KeyText> written;
  for_each_pair(object, usual, [&](const auto& field, const auto& otherwise) {
    if (field.key.empty()) return;
    const FormKey& key = key_of(form, field.key);
    if (!key.required && same_fields(field.value, otherwise.value)) return;
    written[std::string(field.key)] = {std::string(key.name), text(field.value, key, in_line),
                                       rows(field.value)};
  });
  return in_order(written, form);
}

}  // namespace stig::rules
