// SPDX-License-Identifier: MIT
// Short ways to write the entries of a table of keys. Private to this folder.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "base/form.h"

namespace stig::robots::keys {

inline constexpr double kFar = 10;  ///< m, of a robot's parts from each other

// Members left out have their defaults.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

inline FormKey words(std::string_view name, FormKind kind, std::string_view doc) {
  return {.name = name, .kind = kind, .doc = doc};
}
inline FormKey number(std::string_view name, std::string_view doc, double low, double high) {
  return {.name = name, .kind = FormKind::number, .doc = doc, .low = low, .high = high};
}
inline FormKey whole(std::string_view name, std::string_view doc, double low, double high) {
  return {.name = name, .kind = FormKind::integer, .doc = doc, .low = low, .high = high};
}
inline FormKey above_zero(std::string_view name, std::string_view doc, double high) {
  return {.name = name,
          .kind = FormKind::number,
          .doc = doc,
          .low = 0,
          .high = high,
          .above_low = true};
}
inline FormKey numbers(std::string_view name, std::string_view doc, std::size_t least,
                       std::size_t most, double low, double high) {
  return {.name = name,
          .kind = FormKind::numbers,
          .doc = doc,
          .low = low,
          .high = high,
          .least = least,
          .most = most};
}
inline FormKey vector(std::string_view name, std::string_view doc, double most) {
  return numbers(name, doc, 3, 3, -most, most);
}
inline FormKey choice(std::string_view name, std::string_view doc,
                      std::vector<std::string_view> of) {
  return {.name = name, .kind = FormKind::choice, .doc = doc, .words = std::move(of)};
}
inline FormKey part(std::string_view name, std::string_view doc, const Form& form) {
  return {.name = name, .kind = FormKind::form, .doc = doc, .form = &form};
}
inline FormKey parts(std::string_view name, std::string_view doc, const Form& form,
                     std::size_t least, std::size_t most) {
  return {.name = name,
          .kind = FormKind::forms,
          .doc = doc,
          .form = &form,
          .least = least,
          .most = most};
}
inline FormKey version(std::string_view name, std::string_view doc, double known) {
  return {.name = name, .kind = FormKind::version, .required = true, .doc = doc, .high = known};
}
inline FormKey required(FormKey key) {
  key.required = true;
  return key;
}

#pragma GCC diagnostic pop

}  // namespace stig::robots::keys
