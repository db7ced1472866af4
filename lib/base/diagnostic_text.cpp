// SPDX-License-Identifier: MIT
// Diagnostics as a terminal shows them.
#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostic.h"
#include "base/text.h"

namespace stig {

namespace {

constexpr std::size_t kTabWidth = 8;
constexpr std::size_t kWidest = 100;  ///< columns of source shown of one line

struct Paint {
  bool on;
  std::string operator()(const char* sequence, const std::string& text) const {
    return on ? fmt::format("\x1b[{}m{}\x1b[0m", sequence, text) : text;
  }
};

constexpr const char* kBold = "1";
constexpr const char* kRed = "1;31";
constexpr const char* kMagenta = "1;35";
constexpr const char* kCyan = "1;36";
constexpr const char* kGreen = "1;32";

/// One code point of a source line as shown, `width` columns wide. Columns are counted in
/// characters as shown: tabs widen to the next multiple of eight, hidden characters become
/// escapes of several columns.
struct Glyph {
  std::string shown;
  std::size_t width;
  std::size_t offset;  ///< in bytes from the line's start
};

/// The code points around [begin, end) of a line, as many as the window needs.
std::vector<Glyph> glyphs_of(std::string_view line, std::size_t from, std::size_t most) {
  std::vector<Glyph> glyphs;
  std::size_t column = 0;
  for (std::size_t i = from; i < line.size() && column < most;) {
    const CodePoint point = decode_utf8(line.substr(i));
    std::string shown = printable(line.substr(i), point);
    std::size_t width = shown.size() == point.length ? 1 : shown.size();
    if (point.value == '\t') {
      width = kTabWidth - column % kTabWidth;
      shown = std::string(width, ' ');
    }
    glyphs.push_back({std::move(shown), width, i});
    column += width;
    i += point.length;
  }
  return glyphs;
}

/// Where the shown part of a long line starts: far enough left of the caret. The window
/// starts at a character, never within one; UTF-8's continuation bytes are 10xxxxxx.
std::size_t window_start(std::string_view line, std::size_t caret) {
  constexpr std::size_t kBefore = 40;
  if (line.size() <= kWidest || caret <= kWidest - kBefore) return 0;
  std::size_t start = std::min(caret, line.size()) - kBefore;
  while (start > 0 && (static_cast<unsigned char>(line[start]) & 0xC0U) == 0x80U) --start;
  return start;
}

/// The source line and the marks under [begin, end), both offsets in the line.
void show_line(std::string& out, std::size_t number, std::string_view line, std::size_t begin,
               std::size_t end, const Paint& paint) {
  const std::size_t start = window_start(line, begin);
  std::string text = start > 0 ? "…" : "";
  std::string marks(start > 0 ? 1 : 0, ' ');
  bool marked = false;
  std::size_t shown_to = start;
  for (const Glyph& glyph : glyphs_of(line, start, kWidest)) {
    text += glyph.shown;
    const bool inside = glyph.offset >= begin && glyph.offset < std::max(end, begin + 1);
    std::string under(glyph.width, inside ? '~' : ' ');
    if (inside && !marked) under[0] = '^';
    marked = marked || inside;
    marks += under;
    shown_to = glyph.offset + 1;
  }
  // An empty range, or one past the line's end, still gets a caret.
  if (!marked) marks += '^';
  if (line.size() > shown_to + 4) text += "…";
  marks.erase(marks.find_last_not_of(' ') + 1);
  text.erase(text.find_last_not_of(' ') + 1);
  out += fmt::format("{:>5} | {}\n", number, text);
  out += fmt::format("      | {}\n", paint(kGreen, marks));
}

void show_source(std::string& out, const SourceRange& range, const Paint& paint) {
  if (!range || range.file->text().empty()) return;
  const auto at = range.file->position(range.begin);
  const std::size_t line_begin = range.file->line_start(at.line);
  const std::size_t begin = range.begin - std::min<std::size_t>(range.begin, line_begin);
  const std::size_t end = range.end - std::min<std::size_t>(range.end, line_begin);
  show_line(out, at.line, range.file->line(at.line), begin, end, paint);
}

std::string place(const SourceRange& range, const Paint& paint) {
  if (!range) return "";
  const auto at = range.file->position(range.begin);
  const std::string path = printable(range.file->path());
  return paint(kBold, fmt::format("{}:{}:{}:", path, at.line, at.column)) + " ";
}

/// A message of several lines: the first as it is, the rest (a drawing) indented.
/// Everything that came from a file passes through `printable`: a terminal must not be
/// steered by input.
std::string message_lines(std::string_view message) {
  std::string out;
  while (true) {
    const std::size_t end = message.find('\n');
    out += printable(message.substr(0, end)) + "\n";
    if (end == std::string_view::npos || end + 1 == message.size()) return out;
    message.remove_prefix(end + 1);
    out += "        ";
  }
}

void show(std::string& out, const Diagnostic& d, const Paint& paint) {
  const bool is_error = d.severity == Severity::error;
  const std::string label =
      fmt::format("{}[{}]:", is_error ? "error" : "warning", info(d.code).name);
  out += place(d.range, paint) + paint(is_error ? kRed : kMagenta, label) + " ";
  out += message_lines(d.message);
  show_source(out, d.range, paint);
  if (!d.suggestion.empty()) {
    out += paint(kCyan, "help:") + fmt::format(" did you mean {}?\n", in_quotes(d.suggestion));
  }
  for (const Note& note : d.notes) {
    out += place(note.range, paint) + paint(kCyan, "note:") + " " + message_lines(note.message);
    show_source(out, note.range, paint);
  }
}

/// All are counted, also those that are not shown.
std::string summary(const Diagnostics& diagnostics, std::size_t shown) {
  const std::size_t errors = diagnostics.count(Severity::error);
  const std::size_t warnings = diagnostics.count(Severity::warning);
  std::string out;
  if (errors > 0) out += counted(errors, "error");
  if (warnings > 0) out += (errors > 0 ? ", " : "") + counted(warnings, "warning");
  if (shown < errors + warnings) out += fmt::format(" ({} shown)", shown);
  return out + "\n";
}

}  // namespace

std::string to_text(const Diagnostics& diagnostics, const TextStyle& style) {
  const Paint paint{style.color};
  std::string out;
  std::size_t shown = 0;
  for (const Diagnostic* d : sorted_by_place(diagnostics)) {
    if (shown == style.most) break;
    show(out, *d, paint);
    ++shown;
  }
  return diagnostics.all().empty() ? out : out + summary(diagnostics, shown);
}

}  // namespace stig
