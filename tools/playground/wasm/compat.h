// SPDX-License-Identifier: MIT
// What the libraries use of C++20 and Emscripten's standard library, of LLVM 13, has not. Included
// before every source of the module, and nowhere else.
#pragma once

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

/// Decimal numbers alone, as from_chars has them: strtod would take hexadecimal ones too.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string_view text(first, static_cast<size_t>(last - first));
  const string number(text.substr(0, text.find_first_not_of("0123456789.eE+-")));
  char* end = nullptr;
  errno = 0;
  const double found = strtod(number.c_str(), &end);
  const ptrdiff_t length = end - number.c_str();
  if (length == 0) return {first, errc::invalid_argument};
  if (errno == ERANGE) return {first + length, errc::result_out_of_range};
  value = found;
  return {first + length, errc()};
}

/// Without exponents, which end the number.
inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format) {
  const string_view text(first, static_cast<size_t>(last - first));
  const size_t length = text.find_first_not_of("0123456789.-");
  return from_chars(first, length == string_view::npos ? last : first + length, value);
}

}  // namespace std
