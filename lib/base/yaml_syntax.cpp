// SPDX-License-Identifier: MIT
// Guesses at the slip behind a syntax error. The parser reports where it could not go on;
// the heuristics below look upwards from there for the mistakes that people make most, and
// add a note. None of them changes what is an error, so a wrong guess costs a line of text.
#include "base/yaml_syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

#include "base/text.h"

namespace stig {

namespace {

constexpr const char* kNoKey = "end of map not found";
constexpr const char* kNoEntry = "end of sequence not found";
constexpr const char* kTab = "illegal tab when looking for indentation";

/// The parser's words for what users get wrong most, in plainer ones. The keys are
/// yaml-cpp's own messages, compared as text: an unknown message is shown as it is.
std::string plainer(const std::string& message) {
  static const std::unordered_map<std::string_view, const char*> kWords = {
      {kNoKey, "expected a key, at the indentation of the keys before"},
      {kNoEntry, "expected an entry '- …', at the indentation of those before"},
      {"end of sequence flow not found", "the list opened with '[' is not closed before this"},
      {"end of map flow not found", "the mapping opened with '{' is not closed before this"},
      {"illegal map value", "no ':' can stand here; a text with ': ' in it needs quotes"},
      {"unknown token", "no value can start with this character without quotes"},
      {"illegal EOF in scalar", "a quote is not closed before the end of the file"},
      {kTab, "indentation is made of spaces, not of tabs"},
      {"alias not found after *", "a text that begins with '*' needs quotes: \"*\""},
      {"anchor not found after &", "a text that begins with '&' needs quotes: \"&\""},
  };
  const auto found = kWords.find(message);
  return found == kWords.end() ? message : found->second;
}

/// A line of the file, and where its parts are. Lines are looked at without their line ends
/// and trailing spaces.
struct Line {
  std::size_t number = 0, start = 0;
  std::string_view text;
  std::size_t indent = 0;   ///< spaces in front
  std::size_t content = 0;  ///< column of the first character behind "- "

  bool blank() const { return indent == text.size() || text[indent] == '#'; }
  /// Is there a key in it?
  bool has_key() const {
    return text.find(": ", content) != std::string_view::npos ||
           (text.size() > content && text.back() == ':');
  }
};

Line line_at(const SourceRef& source, std::size_t number) {
  Line line{number, source->line_start(number), source->line(number)};
  while (!line.text.empty() && std::string_view(" \t\r").find(line.text.back()) != line.text.npos) {
    line.text.remove_suffix(1);
  }
  line.indent = std::min(line.text.find_first_not_of(' '), line.text.size());
  line.content = std::min(line.text.find_first_not_of(" -"), line.text.size());
  return line;
}

SourceRange range(const SourceRef& source, const Line& line, std::size_t from, std::size_t to) {
  return {source, static_cast<std::uint32_t>(line.start + from),
          static_cast<std::uint32_t>(line.start + to)};
}

/// The nearest line above that says something; number 0 when there is none.
Line line_before(const SourceRef& source, std::size_t number) {
  while (--number > 0) {
    const Line line = line_at(source, number);
    if (!line.blank()) return line;
  }
  return {};
}

/// A '#' where a value is wanted inside brackets that its line opens, or npos: the rest of
/// the line, with the closing bracket, is lost to a comment. A quote hides brackets and
/// '#'; the scan follows only what matters to these.
std::size_t swallowing_hash(std::string_view line) {
  int depth = 0;
  char quote = '\0', last = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == ' ') continue;
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == '#' && (i == 0 || line[i - 1] == ' ' || last == '[' || last == ',')) {
      const bool wanted = depth > 0 && (last == ':' || last == ',' || last == '[');
      const bool remark = i + 1 < line.size() && line[i + 1] == ' ';
      return wanted && !remark ? i : std::string_view::npos;
    }
    last = c;
  }
  return std::string_view::npos;
}

/// Where the parser could not go on, and what is said of it. Each of the functions that take
/// one says what went wrong above it and returns true, or does not know.
struct Fault {
  const SourceRef& source;
  Line line;
  std::size_t column;
  Diagnostic& diagnostic;
};

/// `{color: #8d99ae}`: said where the '#' is, since nothing is wrong where the parser noticed.
bool explain_hash(Fault& fault) {
  for (std::size_t number = fault.line.number; number > 0; --number) {
    const Line line = line_at(fault.source, number);
    const std::size_t hash = swallowing_hash(line.text);
    if (hash == std::string_view::npos) continue;
    const std::size_t end = std::min(line.text.find_first_of(" ,]}", hash), line.text.size());
    fault.diagnostic.note(fault.diagnostic.range, fault.diagnostic.message);
    fault.diagnostic.range = range(fault.source, line, hash, end);
    fault.diagnostic.message = "'#' begins a comment; a text that begins with it needs quotes";
    fault.diagnostic.suggest(fmt::format("\"{}\"", line.text.substr(hash, end - hash)));
    return true;
  }
  return false;
}

/// When a block's first row is indented deeper than the one at fault, or not even as deep as its
/// key, the block was taken to end there.
bool explain_short_block(Fault& fault) {
  // Forty lines up are enough for any drawing, and bound the work.
  for (std::size_t number = fault.line.number; number-- > 1 && fault.line.number - number < 40;) {
    const Line head = line_at(fault.source, number);
    if (head.blank() || (head.text.back() != '|' && head.text.back() != '>')) continue;
    const Line row = line_at(fault.source, number + 1);
    if (!row.blank() && row.indent <= head.content) {
      fault.diagnostic.note(range(fault.source, row, row.indent, row.indent + 1),
                            "the rows of a block are indented deeper than its key");
      return true;
    }
    const std::size_t here = fault.line.indent;
    if (number + 1 >= fault.line.number || here >= row.indent || here <= head.content) return false;
    fault.diagnostic.note(range(fault.source, row, row.indent, row.indent + 1),
                          fmt::format("the block's first row is indented deeper, so the block "
                                      "ended; write '|{}' to say where its rows start",
                                      here - head.content));
    return true;
  }
  return false;
}

/// `when:` without its bar: rows without a key stand below it, deeper than it.
bool explain_missing_bar(Fault& fault) {
  for (std::size_t number = fault.line.number; --number > 0;) {
    const Line head = line_at(fault.source, number);
    if (head.blank()) continue;
    if (head.text.back() != ':') {
      if (head.has_key()) return false;
      continue;
    }
    const Line row = line_at(fault.source, number + 1);
    if (row.indent <= head.content || row.blank() || row.has_key()) return false;
    fault.diagnostic.note(range(fault.source, head, head.content, head.text.size()),
                          fmt::format("a text of several lines needs a bar: write '{} |'",
                                      printable(head.text.substr(head.content))));
    return true;
  }
  return false;
}

/// `place:2` or `floor = true` above the key at which the parser noticed.
bool explain_lost_key(Fault& fault) {
  const std::size_t key_end = fault.line.text.find(": ", fault.line.content);
  const Line before = line_before(fault.source, fault.line.number);
  if (before.number == 0 || before.has_key() || key_end < fault.column) return false;
  if (before.content != fault.line.content) return false;
  const std::size_t colon = before.text.find(':', before.content);
  const bool close = colon != std::string_view::npos;
  fault.diagnostic.note(range(fault.source, before, before.content, before.text.size()),
                        close ? "here a space is missing behind the colon"
                              : "there is no key in this line: write 'key: value'");
  return true;
}

/// Keys that are a little off: `- name: x` with `place: 1` a column too far to the left.
bool explain_uneven_keys(Fault& fault) {
  const Line before = line_before(fault.source, fault.line.number);
  if (before.number == 0 || !before.has_key() || !fault.line.has_key()) return false;
  const auto here = static_cast<std::int64_t>(fault.line.content);
  const auto there = static_cast<std::int64_t>(before.content);
  if (here == there || std::abs(here - there) > 3) return false;
  fault.diagnostic.note(range(fault.source, before, before.content, before.text.size()),
                        fmt::format("this begins in column {}, what is refused in column {}; keys "
                                    "of one mapping begin in the same column",
                                    there + 1, here + 1));
  return true;
}

}  // namespace

void report_syntax(const SourceRef& source, std::size_t at, const std::string& reason,
                   Diagnostics& diagnostics) {
  const std::size_t size = source->text().size();
  const auto begin = static_cast<std::uint32_t>(std::min(at, size));
  const auto end = static_cast<std::uint32_t>(std::min(at + 1, size));
  Diagnostic& diagnostic = diagnostics.add(Code::R006, {source, begin, end}, plainer(reason));
  const Line line = line_at(source, source->position(begin).line);
  Fault fault{source, line, begin - line.start, diagnostic};
  // From the most certain guess to the least.
  if (reason == kTab || explain_hash(fault) || explain_short_block(fault)) return;
  if (explain_missing_bar(fault) || explain_lost_key(fault)) return;
  if (reason == kNoKey || reason == kNoEntry) explain_uneven_keys(fault);
}

}  // namespace stig
