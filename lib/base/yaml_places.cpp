// SPDX-License-Identifier: MIT
// Ends of values and comments, found in the text alone. Each function assumes what the
// parser has established (a scalar begins here and has this value), so it can be simple; on
// text that does not fit it returns a short range and never reads beyond the end.
#include "base/yaml_places.h"

#include <algorithm>
#include <cassert>

namespace stig {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::size_t line_end(std::string_view source, std::size_t from) {
  return std::min(source.find('\n', from), source.size());
}

std::size_t next_line(std::string_view source, std::size_t from) {
  return std::min(line_end(source, from) + 1, source.size());
}

std::size_t leading_spaces(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

/// Line ends within a plain scalar are folded to spaces in its value, so all white space is
/// skipped on both sides.
std::size_t plain_end(std::string_view source, std::size_t begin, std::string_view value) {
  std::size_t at = begin;
  for (const char c : value) {
    if (is_space(c)) continue;
    std::size_t next = at;
    while (next < source.size() && is_space(source[next])) ++next;
    if (next == source.size() || source[next] != c) break;
    at = next + 1;
  }
  return std::max(at, std::min(begin + 1, source.size()));
}

/// In double quotes a backslash escapes the next character; in single quotes a quote is
/// doubled.
std::size_t quoted_end(std::string_view source, std::size_t begin) {
  assert(begin < source.size());
  const char quote = source[begin];
  for (std::size_t i = begin + 1; i < source.size(); ++i) {
    if (quote == '"' && source[i] == '\\') {
      ++i;
    } else if (source[i] == quote) {
      const bool doubled = quote == '\'' && i + 1 < source.size() && source[i + 1] == quote;
      if (!doubled) return i + 1;
      ++i;
    }
  }
  return std::string_view::npos;
}

BlockContent block_content(std::string_view source, std::size_t begin, std::string_view value) {
  BlockContent content;
  content.begin = next_line(source, begin);
  content.end = content.begin;
  // The first line with something in it tells how far all are indented.
  bool found = false;
  std::string_view rest = value;
  for (std::size_t at = content.begin; at < source.size(); at = next_line(source, at)) {
    const std::string_view line = source.substr(at, line_end(source, at) - at);
    // Blank lines say nothing about indentation.
    if (!found && !is_blank(line)) {
      const std::size_t skip = std::min(rest.find_first_not_of('\n'), rest.size());
      rest.remove_prefix(skip);
      if (rest.empty()) break;
      const std::size_t inner = std::min(leading_spaces(rest), leading_spaces(line));
      content.indent = leading_spaces(line) - inner;
      found = true;
    } else if (!is_blank(line) && leading_spaces(line) < content.indent) {
      break;
    }
    if (!is_blank(line)) content.end = at + line.size();
  }
  return content;
}

/// Brackets within quoted entries have been passed: the search begins behind the last
/// entry.
std::size_t flow_end(std::string_view source, std::size_t from, char bracket) {
  for (std::size_t i = from; i < source.size(); ++i) {
    if (source[i] == bracket) return i + 1;
    const bool comment = source[i] == '#' && i > 0 && is_space(source[i - 1]);
    if (comment) i = line_end(source, i);
  }
  return source.size();
}

std::size_t skip_properties(std::string_view source, std::size_t begin) {
  std::size_t at = begin;
  while (at < source.size() && (source[at] == '&' || source[at] == '!')) {
    while (at < source.size() && !is_space(source[at])) ++at;
    while (at < source.size() && is_space(source[at])) ++at;
  }
  return at < source.size() ? at : begin;
}

/// A '#' begins a comment only at the start of a line or after white space, and nowhere
/// within a scalar.
std::vector<YamlComment> find_comments(std::string_view source,
                                       const std::vector<ScalarSpan>& scalars) {
  std::vector<YamlComment> comments;
  auto scalar = scalars.begin();
  std::size_t line_begin = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    while (scalar != scalars.end() && scalar->end <= i) ++scalar;
    if (scalar != scalars.end() && i >= scalar->begin) {
      const std::size_t last_break = source.substr(i, scalar->end - i).rfind('\n');
      if (last_break != std::string_view::npos) line_begin = i + last_break + 1;
      i = scalar->end - 1;
    } else if (source[i] == '\n') {
      line_begin = i + 1;
    } else if (source[i] == '#' && (i == 0 || is_space(source[i - 1]))) {
      std::size_t end = line_end(source, i);
      const bool trailing = !is_blank(source.substr(line_begin, i - line_begin));
      const std::size_t next = end;
      while (end > i && is_space(source[end - 1])) --end;
      comments.push_back(
          {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end), trailing});
      i = next - 1;
    }
  }
  return comments;
}

}  // namespace stig
