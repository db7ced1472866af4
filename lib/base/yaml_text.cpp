// SPDX-License-Identifier: MIT
// When a text can be written without quotes. The answer is conservative: YAML 1.1 and 1.2
// and their readers disagree about many words and characters, and a text in quotes means
// the same to all of them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "base/text.h"
#include "base/yaml.h"

namespace stig {

namespace {

bool is_alphanumeric(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Words and numbers that some YAML reader takes for something else than text.
bool looks_like_another_type(std::string_view text) {
  static constexpr std::array<std::string_view, 11> kWords = {
      "true", "false", "yes", "no", "on", "off", "null", "y", "n", "nan", "inf"};
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(kWords.begin(), kWords.end(), lower) != kWords.end();
}

/// May the character at i stand inside a plain text? Conservative, so that every YAML
/// reader agrees. Some of these characters would be safe in most positions; quotes are
/// cheap, and surprises are not.
bool is_safe(std::string_view text, std::size_t i, bool inside_flow) {
  static constexpr std::string_view kAlways = " _-./()+'%!=&^@$<>;";
  static constexpr std::string_view kInBlock = ",[]{}?*|~\"";
  const char c = text[i];
  if (is_alphanumeric(c) || kAlways.find(c) != kAlways.npos) return true;
  if (inside_flow) return false;
  if (c == ':') return i + 1 < text.size() && text[i + 1] != ' ';
  if (c == '#') return i > 0 && text[i - 1] != ' ';
  return kInBlock.find(c) != kInBlock.npos;
}

/// The first character decides between indicators, numbers and texts in every reader.
bool is_plain(std::string_view text, bool inside_flow) {
  if (text.empty() || text.back() == ' ') return false;
  const char first = text.front();
  if (!is_alphanumeric(first) && first != '_' && (static_cast<unsigned char>(first) & 0x80U) == 0) {
    return false;
  }
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = decode_utf8(text.substr(i));
    const bool safe = point.value < 0x80 ? is_safe(text, i, inside_flow)
                                         : printable(text.substr(i), point).size() == point.length;
    if (!safe) return false;
    i += point.length;
  }
  return !looks_like_another_type(text);
}

/// Double quotes are the only style of YAML with escapes, so any text fits on one line.
std::string escaped(std::string_view text, const CodePoint& point) {
  switch (point.value) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    default:
      break;
  }
  const std::string shown = printable(text, point);
  if (shown.size() == point.length) return shown;
  const auto value = static_cast<unsigned>(point.value);
  if (value < 0x80) return fmt::format("\\x{:02x}", value);
  return value < 0x10000 ? fmt::format("\\u{:04x}", value) : fmt::format("\\U{:08x}", value);
}

}  // namespace

std::string yaml_text(std::string_view text, bool inside_flow) {
  if (is_plain(text, inside_flow)) return std::string(text);
  std::string out = "\"";
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = decode_utf8(text.substr(i));
    out += escaped(text.substr(i), point);
    i += point.length;
  }
  return out + "\"";
}

}  // namespace stig
