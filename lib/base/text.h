// SPDX-License-Identifier: MIT
// Small helpers for text that came from outside: UTF-8, and showing bytes safely.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace stig {

/// One decoded code point; an invalid byte is a point of length 1 with valid = false.
struct CodePoint {
  char32_t value = 0;
  std::size_t length = 1;
  bool valid = true;
};
/// The code point at the front of a text that is not empty. Overlong forms,
/// surrogates and values above U+10FFFF are invalid (RFC 3629).
CodePoint decode_utf8(std::string_view text);

/// Offset of the first byte that is no UTF-8, or npos.
std::size_t find_invalid_utf8(std::string_view text);

/// Number of code points of UTF-8. Of bytes that are none, those that look like the
/// rest of a character are not counted.
std::size_t count_code_points(std::string_view text);

/// As it may be shown on a terminal: control characters, characters that reorder
/// or hide text, and invalid bytes become \x1b, \u202e; the rest stays.
std::string printable(std::string_view text);
std::string printable(std::string_view text, const CodePoint& point);

/// 'text' in quotes, printable, cut after 60 characters.
std::string in_quotes(std::string_view text);

/// As text or an attribute's value of XML or HTML.
std::string escaped_markup(std::string_view text);

/// As a field of CSV, in quotes where it needs them (RFC 4180).
std::string csv_field(std::string_view text);

/// In single quotes of bash, zsh and others of POSIX.
std::string shell_quoted(std::string_view text);

/// "1 brick", "2 bricks"; of words that take an s.
std::string counted(std::uint64_t number, std::string_view one);

}  // namespace stig
