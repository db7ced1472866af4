// SPDX-License-Identifier: MIT
// UTF-8 and safe display of bytes from outside. Decoding follows RFC 3629 to the letter,
// since lenient decoders are a known way around checks; display escapes whatever could move
// the cursor, hide text or reverse its direction on a terminal ("Trojan Source", N. Boucher
// and R. Anderson 2021).
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace stig {

namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Controls, zero-width characters and those that change the direction of text.
bool is_hidden(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
         c == 0x00AD || c >= 0xE0000;
}

}  // namespace

CodePoint decode_utf8(std::string_view text) {
  assert(!text.empty());
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1, true};
  const CodePoint bad{lead, 1, false};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  // C0 and C1 could only begin overlong forms, F5 to FF values beyond Unicode.
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return bad;
  char32_t value = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return bad;
    value = (value << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (overlong || surrogate || value > 0x10FFFF) return bad;
  return {value, length, true};
}

std::size_t find_invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = decode_utf8(text.substr(i));
    if (!point.valid) return i;
    i += point.length;
  }
  return std::string_view::npos;
}

/// Continuation bytes are not counted, which is right for valid text and harmless for
/// other.
std::size_t count_code_points(std::string_view text) {
  const auto continues = std::count_if(text.begin(), text.end(), is_continuation);
  return text.size() - static_cast<std::size_t>(continues);
}

/// Escapes are those of C and JSON, which readers of messages know.
std::string printable(std::string_view text, const CodePoint& point) {
  if (!point.valid || (is_hidden(point.value) && point.value < 0x80)) {
    return fmt::format("\\x{:02x}", static_cast<unsigned>(point.value));
  }
  if (is_hidden(point.value)) {
    return fmt::format("\\u{:04x}", static_cast<unsigned>(point.value));
  }
  return std::string(text.substr(0, point.length));
}

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = decode_utf8(text.substr(i));
    out += printable(text.substr(i), point);
    i += point.length;
  }
  return out;
}

/// Cut by characters and not by bytes, so that none is torn.
std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMost = 60;
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size() && count < kMost; ++count) {
    end += decode_utf8(text.substr(end)).length;
  }
  return "'" + printable(text.substr(0, end)) + (end < text.size() ? "…'" : "'");
}

std::string escaped_markup(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string shell_quoted(std::string_view text) {
  // A quote ends the quoted text, comes escaped, and begins it again.
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string counted(std::uint64_t number, std::string_view one) {
  return fmt::format("{} {}{}", number, one, number == 1 ? "" : "s");
}

}  // namespace stig
