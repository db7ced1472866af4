// SPDX-License-Identifier: MIT
// Random values for the members of a rule set that are numbers or words, within the bounds of
// their keys; call inside rc::check. A key that joins the language is drawn from then on.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "rules/key_field.h"
#include "rules/rule_schema.h"
#include "support/draws.h"
#include "support/uses.h"

namespace stig {

inline void draw_value(bool& value, const FormKey& /*key*/) { value = chance(); }

/// Small, so that numbers meet.
inline void draw_value(int& value, const FormKey& key) {
  const int low = static_cast<int>(std::max(key.low, -2.0));
  const int high = static_cast<int>(std::min(key.high, low < 0 ? 4.0 : low + 2.0));
  value = low + below(high - low + 1);
}

inline void draw_value(double& value, const FormKey& key) {
  std::vector<double> allowed;
  for (const double some : {0.5, 0.1, 1e-7, 0.3333333333333333, 0.25, 2.0, 12345.678, 1e9}) {
    if (some <= key.high) allowed.push_back(some);
  }
  value = *rc::gen::elementOf(allowed);
}

template <class T>
requires std::is_enum_v<T>
void draw_value(T& value, const FormKey& key) {
  value = static_cast<T>(below(static_cast<int>(key.words.size())));
}

template <class T>
requires requires(T& inner, const FormKey& key) { draw_value(inner, key); }
void draw_value(std::optional<T>& value, const FormKey& key) { draw_value(value.emplace(), key); }

/// Draws one in so many of these members; the others stay, and so do those under the keys in
/// `but`, which the caller sees to.
template <HasFields T>
void draw_fields(T& object, const Form& form, int one_in,
                 std::initializer_list<std::string_view> but) {
  for_each_field(object, [&](const auto& field) {
    if constexpr (requires(const FormKey& key) { draw_value(field.value, key); }) {
      if (std::find(but.begin(), but.end(), field.key) != but.end() || below(one_in) > 0) return;
      draw_value(field.value, key_of(form, field.key));
    }
  });
}

}  // namespace stig
